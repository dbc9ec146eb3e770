"""Plain tables: fixed-width columns, quick for thousands of rows."""

from __future__ import annotations

import shutil
import sys
from collections.abc import Iterable, Sequence


def format_table(
    header: Sequence[str], rows: Iterable[Sequence[str]], right: str = "", width: int | None = None
) -> str:
    """The table as text, without a line end at the last line.

    Args:
        header: One title per column.
        rows: The cells, as text, one per column.
        right: Titles of columns to align to the right, separated by spaces.
        width: Cut lines to this many characters (in the last columns).
    """
    lines = [tuple(header), *map(tuple, rows)]
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    to_right = set(right.split())
    # Plain text and one form for all lines: rich takes .3 s for a table of 600 rows.
    form = "  ".join(
        f"{{:{'>' if title in to_right else '<'}{size}}}"
        for title, size in zip(header, widths, strict=True)
    )
    return "\n".join(shorten(form.format(*line).rstrip(), width) for line in lines)


def shorten(text: str, width: int | None) -> str:
    """``text`` on one line, cut to ``width`` characters with dots where it was longer."""
    text = " ".join(text.split("\n"))
    return text if width is None or len(text) <= width else text[: max(0, width - 3)] + "..."


def terminal_width() -> int | None:
    """Columns of the terminal that stdout is, or None where it is a file or a pipe."""
    return shutil.get_terminal_size().columns if sys.stdout.isatty() else None
