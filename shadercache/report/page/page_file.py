"""The page as one file: template, style, scripts, plotly, data, texts and pictures."""

from __future__ import annotations

import gzip
import json
from base64 import b64encode
from importlib.resources import files
from importlib.util import find_spec
from pathlib import Path
from string import Template
from typing import Any

from shadercache.diagnostics import input_error, usage_error
from shadercache.report.page.page_contents import Progress, fill_pictures, page_texts
from shadercache.report.page.page_data import PageSource, page_data
from shadercache.report.page.page_group import page_groups
from shadercache.report.page.picture_shelf import PictureShelf

LARGEST = 11_300_000
"""Bytes that pages are kept below; pictures are left out for it."""

SCRIPTS = (
    "base",
    "choice",
    "plots",
    "plane",
    "figures",
    "viewer",
    "details",
    "source",
    "table",
    "start",
)
"""The page's scripts, in the order in which they stand in it."""


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
    texts = page_texts(groups, source.blob)
    fixed = {
        "style": _part("page.css"),
        "plotly": plotly_script(),
        "script": "\n".join(_part(f"{name}.js") for name in SCRIPTS),
        # Without a time in its header gzip makes equal bytes of equal texts.
        "texts": b64encode(gzip.compress(_json(texts).encode(), mtime=0)).decode(),
    }
    data = page_data(source, groups)
    taken = sum(len(part.encode()) for part in (*fixed.values(), _json(data)))
    fill_pictures(data, groups, PictureShelf(source.blob, LARGEST - taken), progress)
    names = ", ".join(dict.fromkeys(group["scene"]["name"] for group in data["groups"]))
    title = f"{names}: time against error".replace("&", "&amp;").replace("<", "&lt;")
    page = Template(_part("page.html")).substitute(fixed, title=title, data=_json(data))
    return page.encode()


def plotly_script() -> str:
    """The text of plotly.js, as the Python package brings it.

    Raises :class:`UsageError` SC031: it is not installed.
    """
    # Only looked for: to import plotly takes half a second.
    found = find_spec("plotly")
    places = [] if found is None else found.submodule_search_locations or []
    for place in places:
        path = Path(place) / "package_data" / "plotly.min.js"
        if path.is_file():
            # Ends of a script element would end it here too.
            return path.read_text(encoding="utf-8").replace("</script", "<\\/script")
    hint = "pip install 'shadercache[report]'"
    raise usage_error("SC031", "a report needs the package plotly", hint)


def _part(name: str) -> str:
    return files(__package__).joinpath(name).read_text(encoding="utf-8")


def _json(data: Any) -> str:
    """JSON that may stand in a script element: no text in it can end that or begin a comment."""
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c")
