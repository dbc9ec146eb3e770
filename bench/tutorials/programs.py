"""The programs of a collection: fragment shaders, each with the vertex shader it goes with.

Shaders are files (``x.vs`` and ``x.fs``, ``x.vert`` and ``x.frag``) or scripts of web pages. A
fragment shader goes with the vertex shader that the program of its folder names before it
(``"a.vs", "b.fs"``), else with that of its own name, else with the one of its folder (or page) that
hands on what it reads, and least besides.
"""

from __future__ import annotations

import html
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType

VERTEX = (".vs", ".vert", ".vsh")
FRAGMENT = (".fs", ".frag", ".fsh")
BETWEEN = (".gs", ".geom", ".tcs", ".tes", ".tesc", ".tese")

HOSTS = (".c", ".cpp", ".js", ".java", ".py")

_NAMES = re.compile(r"\"([^\"\n]+)\"\s*,\s*\"([^\"\n]+)\"")
_SCRIPT = re.compile(
    r"<script[^>]*\bid=\"(?P<name>[^\"]+)\"[^>]*\btype=\"x-shader/x-(?P<stage>vertex|fragment)\"[^>]*>"
    r"(?P<text>.*?)</script>",
    re.DOTALL,
)
_COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
_QUALIFIERS = r"^\s*(?:layout\s*\([^)]*\)\s*)?(?:(?:flat|smooth|centroid|noperspective)\s+)*"


@dataclass(frozen=True, slots=True)
class Program:
    """A fragment shader, the vertex shader it goes with, if there is one, and whether a geometry or
    tessellation shader stands between them. ``also``: how many more have the same texts."""

    name: str
    fragment: str
    vertex: str | None
    between: bool = False
    also: int = 0


@dataclass(frozen=True, slots=True)
class _Text:
    place: str
    stem: str
    text: str

    @property
    def file(self) -> str:
        return self.place.rpartition("/")[2]


def programs_of(folder: Path) -> list[Program]:
    """The programs of a folder, no two with the same texts, by name."""
    known: dict[tuple[str, str | None, bool], Program] = {}
    for program in _every(folder):
        key = program.fragment, program.vertex, program.between
        first = known.get(key, program)
        known[key] = replace(first, also=first.also + (key in known))
    return list(known.values())


def _every(folder: Path) -> Iterator[Program]:
    for page in sorted(folder.rglob("*.html")):
        scripts = list(_SCRIPT.finditer(page.read_text(encoding="utf-8", errors="replace")))
        place = page.relative_to(folder).as_posix()
        groups: dict[str, list[_Text]] = {"vertex": [], "fragment": []}
        for script in scripts:
            stem = re.sub(r"^[vf]s-?", "", script["name"])
            text = html.unescape(script["text"]).strip() + "\n"
            groups[script["stage"]].append(_Text(f"{place}#{script['name']}", stem, text))
        yield from _paired(groups["fragment"], groups["vertex"])
    files = [path for path in sorted(folder.rglob("*")) if path.is_file()]
    for parent in dict.fromkeys(path.parent for path in files):
        here = [path for path in files if path.parent == parent]
        between = frozenset(path.stem for path in here if path.suffix in BETWEEN)
        fragments, vertices = (
            [_read(path, folder) for path in here if path.suffix in suffixes]
            for suffixes in (FRAGMENT, VERTEX)
        )
        hosts = [_read(path, folder).text for path in here if path.suffix in HOSTS]
        told = {name: vertex for host in hosts for vertex, name in _NAMES.findall(host)}
        yield from _paired(fragments, vertices, told, between)


def _read(path: Path, folder: Path) -> _Text:
    text = path.read_text(encoding="utf-8", errors="replace")
    return _Text(path.relative_to(folder).as_posix(), path.stem, text)


def _paired(
    fragments: Sequence[_Text],
    vertices: Sequence[_Text],
    told: Mapping[str, str] = MappingProxyType({}),
    between: frozenset[str] = frozenset(),
) -> Iterator[Program]:
    """``told``: file names of vertex shaders by those of fragment shaders."""
    for fragment in fragments:
        name = told.get(fragment.file, "")
        named = [one.text for one in vertices if one.file == name] or [
            one.text for one in vertices if one.stem == fragment.stem
        ]
        text = named[0] if named else _fitting(fragment.text, vertices)
        yield Program(fragment.place, fragment.text, text, fragment.stem in between)


def _fitting(fragment: str, vertices: Sequence[_Text]) -> str | None:
    read = _declared(fragment, "in|varying")
    fits = [vertex.text for vertex in vertices if read <= _declared(vertex.text, "out|varying")]
    return min(fits, key=lambda text: len(_declared(text, "out|varying")), default=None)


def _declared(text: str, words: str) -> frozenset[str]:
    """The names of what a shader reads or hands on; of a block its members count as one."""
    plain = _COMMENT.sub(" ", text)
    pattern = rf"{_QUALIFIERS}(?:{words})\s+(?:(?P<block>\w+)\s*\{{|[\w\s]*?(?P<name>\w+)\s*[;\[])"
    found = re.finditer(pattern, plain, re.MULTILINE)
    return frozenset(match["block"] or match["name"] for match in found)
