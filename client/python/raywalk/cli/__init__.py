"""The command line `raywalk`."""

from raywalk.cli.app import app, main

__all__ = ["app", "main"]
