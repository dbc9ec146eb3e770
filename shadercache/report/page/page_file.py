"""The page of a result store as one file."""

from __future__ import annotations

from shadercache.diagnostics import input_error
from shadercache.report.page.page_contents import Progress, fill_pictures, page_texts
from shadercache.report.page.page_data import PageSource, page_data
from shadercache.report.page.page_group import page_groups
from shadercache.report.page.picture_shelf import PictureShelf
from shadercache.report.parts.page_parts import PageParts

PARTS = PageParts(
    __package__,
    "page.html",
    ("common.css", "page.css"),
    (
        "base.js",
        "tasks.js",
        "plots.js",
        "viewer.js",
        "code.js",
        "table.js",
        "choice.js",
        "plane.js",
        "figures.js",
        "pictures.js",
        "details.js",
        "source.js",
        "rows_table.js",
        "start.js",
    ),
)


def page_file(source: PageSource, progress: Progress | None = None) -> bytes:
    """The page of a store, as UTF-8.

    Raises:
        InputError: SC037, the store has no rows.
        UsageError: SC031, plotly is not installed.
    """
    if not source.rows:
        hint = "shadercache sweep SCENE -o STORE fills one"
        raise input_error("SC037", f"{source.name} has no rows, so there is no report", hint)
    groups = page_groups(source.rows)
    fixed = PARTS.fixed(page_texts(groups, source.blob))
    data = page_data(source, groups)
    fill_pictures(data, groups, PictureShelf(source.blob, PARTS.room(fixed, data)), progress)
    names = ", ".join(dict.fromkeys(group["scene"]["name"] for group in data["groups"]))
    return PARTS.page(fixed, f"{names}: time against error", data)
