"""``shadercache report``: one page that shows what a result store holds."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from shadercache.cli.progress import progress


def command(
    store: Annotated[
        Path, typer.Argument(metavar="STORE", help="Result store of 'shadercache sweep'.")
    ],
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="FILE", help="The page to write.")
    ] = Path("out/report.html"),
) -> None:
    """Write one self-contained page: summary, plots, pictures, shaders, and how to repeat them.

    The page needs no network and no server. It shows the rows of each scene, size and machine apart
    from those of others. Where it would have more than 12 MB with all pictures, those of the best
    configurations come first. Needs the extra 'report' (plotly).
    """
    from shadercache.files import write_bytes
    from shadercache.report.page.page_data import PageSource
    from shadercache.report.page.page_file import page_file
    from shadercache.sweep.store import Store

    with Store(store) as opened:
        rows = opened.rows()
        stale = len(opened.rows(stale=True)) - len(rows)
        source = PageSource(store.name, rows, opened.blob, stale)
        with progress("pictures", sum(row.failure is None for row in rows)) as advance:
            page = page_file(source, advance)
    write_bytes(output, page)
    left_out = f", {stale} stale rows left out" if stale else ""
    print(f"wrote {output}: {len(rows)} rows{left_out}, {len(page) / 1e6:.1f} MB")
