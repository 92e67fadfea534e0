"""The study's tables with our figures beside its own."""

from raywalk.tables.files import TABLES, read_results, table_text, tables_of, write_tables
from raywalk.tables.table import Table, markdown, terminal
from raywalk.tables.table1 import table1
from raywalk.tables.table2 import table2
from raywalk.tables.table3 import table3

__all__ = [
    "TABLES",
    "Table",
    "markdown",
    "read_results",
    "table1",
    "table2",
    "table3",
    "table_text",
    "tables_of",
    "terminal",
    "write_tables",
]
