"""The whole study in one command: its plan, what is measured and kept, and what is written from it."""
