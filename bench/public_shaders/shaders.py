"""Shaders of a folder, by name: the stage of each file, what it includes; no text twice.

A file's name tells its stage: ``x.vert``, ``x.vs``, ``x.vsh``, ``x.vert.glsl``, ``x_vs.glsl``,
``vertex.glsl``, and the same for fragments. A ``.glsl`` file that asks whether ``VERTEX`` or
``FRAGMENT`` is defined holds a shader of each stage, as emulators and game engines keep them. One
that does neither is a fragment shader if it has a main function, and otherwise a library for
others to include.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from os.path import isfile
from pathlib import Path

from shadercache.sema.facts import Stage

_SUFFIXES = frozenset((".vert", ".vs", ".vsh", ".frag", ".fs", ".fsh", ".glsl"))
_WORDS: dict[str, Stage | None] = {
    **dict.fromkeys(("vert", "vertex", "vs", "vsh"), "vertex"),
    **dict.fromkeys(("frag", "fragment", "fs", "fsh", "ps", "pixel"), "fragment"),
    **dict.fromkeys(("cs", "comp", "compute", "gs", "geom", "geometry", "tesc", "tese"), None),
}
_UNSAFE = re.compile(r"[^\w./+-]+")
_NAME_PARTS = re.compile(r"[^\W_]+")
_MAIN = re.compile(r"\bvoid\s+main\s*\(")
_OTHER_STAGE = re.compile(r"\blocal_size_[xyz]\b|\bGL_(?:EXT|NV)_ray_tracing\b|\bEmitVertex\b")
_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]+["<]([^">\n]+)[">].*$', re.MULTILINE)
_VERSION_LINE = re.compile(r"^[ \t]*#[ \t]*version\b.*\n", re.MULTILINE)


@dataclass(frozen=True, slots=True)
class Shader:
    """One shader: where it stands under ``out/public/shaders``, and its text."""

    name: str
    stage: Stage
    text: str

    @property
    def file(self) -> str:
        """Its path in the folder of all shaders; the suffix tells the stage."""
        return f"{_UNSAFE.sub('_', self.name)}.{self.stage[:4]}"


def folder_shaders(folder: Path, include_folders: Sequence[Path] = ()) -> list[Shader]:
    """The distinct shaders of a folder, by name; ``#include`` is done as the host would do it."""
    folder = folder.resolve()
    distinct: dict[tuple[str, str], Shader] = {}
    for path in sorted(folder.rglob("*")):
        if path.suffix.lower() in _SUFFIXES and path.is_file():
            name = f"{folder.name}/{path.relative_to(folder)}"
            for shader in shaders_of(name, _expanded(path, include_folders, set())):
                distinct.setdefault((shader.stage, shader.text), shader)
    return list(distinct.values())


def shaders_of(name: str, text: str) -> Iterator[Shader]:
    """The shaders in a file of that name: none, one, or one of each stage."""
    words = _NAME_PARTS.findall(name.lower().rsplit("/", 1)[-1])
    # The last one: a suffix tells more than what stands before it.
    word = next((word for word in reversed(words) if word in _WORDS), None)
    if word is not None:
        stage = _WORDS[word]
        if stage is not None:
            yield Shader(name, stage, text)
    elif "VERTEX" in text and "FRAGMENT" in text:
        yield Shader(name, "vertex", _with_define(text, "VERTEX"))
        yield Shader(name, "fragment", _with_define(text, "FRAGMENT"))
    elif _MAIN.search(text) and not _OTHER_STAGE.search(text):
        yield Shader(name, "fragment", text)


def _with_define(text: str, name: str) -> str:
    """The text with a macro that is defined from its beginning, or from behind its #version."""
    version = _VERSION_LINE.search(text)
    at = version.end() if version else 0
    return f"{text[:at]}#define {name} 1\n{text[at:]}"


def _expanded(path: Path, folders: Sequence[Path], seen: set[Path]) -> str:
    """A file with the files it includes, each once; what is not found stays as it is written."""
    seen.add(path.resolve())

    def insert(include: re.Match[str]) -> str:
        for folder in (path.parent, *folders):
            target = folder / include[1]
            if isfile(target):  # Unlike Path.is_file it lets a name be too long.
                fresh = target.resolve() not in seen
                return _expanded(target, folders, seen) if fresh else ""
        return include[0]

    return _INCLUDE.sub(insert, path.read_text(encoding="utf-8", errors="replace"))


def evenly(shaders: list[Shader], limit: int | None) -> list[Shader]:
    """At most ``limit`` of them, evenly spread; all of them for ``None``."""
    return shaders[:: -(-len(shaders) // limit)] if limit and shaders else shaders


def evenly_by_folder(shaders: Iterable[Shader], limit: int | None) -> list[Shader]:
    """Of each folder and stage at most ``limit``: generated families have thousands alike."""
    families: dict[tuple[str, Stage], list[Shader]] = defaultdict(list)
    for shader in shaders:
        families[shader.name.rpartition("/")[0], shader.stage].append(shader)
    return [shader for family in families.values() for shader in evenly(family, limit)]
