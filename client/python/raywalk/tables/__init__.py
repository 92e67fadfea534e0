"""The study's tables with our figures beside its own."""

from raywalk.tables.files import read_results, write_tables
from raywalk.tables.table import Table, csv_text, markdown, terminal
from raywalk.tables.table1 import table1
from raywalk.tables.table2 import table2

TABLES = {1: table1, 2: table2}

__all__ = ["TABLES", "Table", "csv_text", "markdown", "read_results", "table1", "table2", "terminal", "write_tables"]
