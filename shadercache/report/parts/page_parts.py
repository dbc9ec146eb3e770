"""A page as one file: a template with style, scripts, plotly, data and texts in it."""

from __future__ import annotations

import gzip
import json
from base64 import b64encode
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib.resources import files
from importlib.util import find_spec
from pathlib import Path
from string import Template
from typing import Any

from shadercache.diagnostics import usage_error

LARGEST = 11_300_000
"""Bytes that pages are kept below; pictures are left out for it."""


@dataclass(frozen=True)
class PageParts:
    """What a kind of page is made of: the package of its own files, its template, its styles and
    scripts in the order in which they stand in it.

    Files are looked for in that package first, then beside this file.
    """

    package: str
    template: str
    styles: tuple[str, ...]
    scripts: tuple[str, ...]

    def fixed(self, texts: Mapping[str, str]) -> dict[str, str]:
        """All but the data. ``texts``: by the name that the data has for each.

        Raises :class:`UsageError` SC031: plotly is not installed.
        """
        return {
            "style": self._joined(self.styles),
            "plotly": plotly_script(),
            "script": self._joined(self.scripts),
            # Without a time in its header gzip makes equal bytes of equal texts.
            "texts": b64encode(gzip.compress(script_json(texts).encode(), mtime=0)).decode(),
        }

    def room(self, fixed: Mapping[str, str], data: Any) -> int:
        """Bytes that are left for pictures."""
        parts = (*fixed.values(), script_json(data))
        return LARGEST - sum(len(part.encode()) for part in parts)

    def page(self, fixed: Mapping[str, str], title: str, data: Any) -> bytes:
        """The page, as UTF-8."""
        safe = title.replace("&", "&amp;").replace("<", "&lt;")
        template = Template(self._text(self.template))
        return template.substitute(fixed, title=safe, data=script_json(data)).encode()

    def _joined(self, names: Sequence[str]) -> str:
        return "\n".join(map(self._text, names))

    def _text(self, name: str) -> str:
        own = files(self.package).joinpath(name)
        shared = files(__package__).joinpath(name)
        return (own if own.is_file() else shared).read_text(encoding="utf-8")


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


def script_json(data: Any) -> str:
    """JSON that may stand in a script element: no text in it can end that or begin a comment."""
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c")
