"""Shaders of a folder, by name: the stage of each file, what it includes; no text twice.

A file's stage is told by its name: ``x.vert``, ``x.vs``, ``x.vsh``, ``x.vert.glsl``, ``x_vs.glsl``,
``vertex.glsl``, and the same for fragments. A ``.glsl`` file that asks whether ``VERTEX`` or
``FRAGMENT`` is defined holds a shader of each stage, as emulators and game engines keep them. One
that tells nothing is a fragment shader if it has a main function, and otherwise a library for
others to include. A ``.shader_test`` of piglit holds shaders in sections.
"""

from __future__ import annotations

import hashlib
import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from os.path import isfile
from pathlib import Path
from typing import Literal

Stage = Literal["vertex", "fragment"]

_SUFFIXES = frozenset((".vert", ".vs", ".vsh", ".frag", ".fs", ".fsh", ".glsl", ".shader_test"))
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
_SECTION = re.compile(r"^\[([^\]\n]+)\][^\n]*\n", re.MULTILINE)
_REQUIRED = re.compile(r"^GLSL( ES)? >= (\d+)\.(\d+)", re.MULTILINE)


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

    @property
    def key(self) -> str:
        """The same for the same text and stage, whatever the name."""
        return hashlib.sha256(f"{self.stage}\0{self.text}".encode()).hexdigest()[:32]


def folder_shaders(folder: Path, include_folders: Sequence[Path] = ()) -> list[Shader]:
    """The distinct shaders of a folder, by name; ``#include`` is done as the host would do it."""
    folder = folder.resolve()
    return list(
        distinct(
            shader
            for path in sorted(folder.rglob("*"))
            if path.suffix.lower() in _SUFFIXES and path.is_file()
            for shader in shaders_of(
                f"{folder.name}/{path.relative_to(folder)}", _expanded(path, include_folders, set())
            )
        )
    )


def shaders_of(name: str, text: str) -> Iterator[Shader]:
    """The shaders in a file of that name: none, one, or one of each stage."""
    words = _NAME_PARTS.findall(name.lower().rsplit("/", 1)[-1])
    word = next((word for word in reversed(words) if word in _WORDS), None)
    if name.endswith(".shader_test"):
        yield from _sections(name, text)
    elif word is not None:
        stage = _WORDS[word]
        if stage is not None:
            yield Shader(name, stage, text)
    elif "VERTEX" in text and "FRAGMENT" in text:
        yield Shader(name, "vertex", _with_define(text, "VERTEX"))
        yield Shader(name, "fragment", _with_define(text, "FRAGMENT"))
    elif _MAIN.search(text) and not _OTHER_STAGE.search(text):
        yield Shader(name, "fragment", text)


def _sections(name: str, text: str) -> Iterator[Shader]:
    """The shaders in a test. One without #version has the version that the test requires."""
    parts = _SECTION.split(text)
    if "shader include" in parts:
        return
    required = _REQUIRED.search(text)
    es, major, minor = required.groups() if required else (None, "1", "10")
    number = int(major) * 100 + int(minor.ljust(2, "0"))
    version = f"#version {number}{' es' if es and number > 100 else ''}\n"
    seen: Counter[str] = Counter()
    stages: dict[str, Stage] = {"vertex shader": "vertex", "fragment shader": "fragment"}
    for title, body in zip(parts[1::2], parts[2::2], strict=True):
        if title in stages:
            seen[title] += 1
            numbered = f"{name}.{seen[title]}" if seen[title] > 1 else name
            yield Shader(numbered, stages[title], body if "#version" in body else version + body)


def _with_define(text: str, name: str) -> str:
    """The text with a macro that is defined from its beginning, or from behind its #version."""
    version = _VERSION_LINE.search(text)
    at = version.end() if version else 0
    return f"{text[:at]}#define {name} 1\n{text[at:]}"


def _expanded(path: Path, folders: Sequence[Path], seen: set[Path]) -> str:
    """A file with the files it includes, each once; what is not found stays as it is written."""
    seen.add(path.resolve())

    def insert(found: re.Match[str]) -> str:
        for folder in (path.parent, *folders):
            target = folder / found[1]
            if isfile(target):  # Unlike Path.is_file it lets a name be too long.
                fresh = target.resolve() not in seen
                return _expanded(target, folders, seen) if fresh else ""
        return found[0]

    return _INCLUDE.sub(insert, path.read_text(encoding="utf-8", errors="replace"))


def distinct(shaders: Iterable[Shader]) -> Iterator[Shader]:
    """The shaders without those whose text another one has had."""
    seen: set[str] = set()
    for shader in shaders:
        if shader.key not in seen:
            seen.add(shader.key)
            yield shader


def evenly(shaders: list[Shader], limit: int | None) -> list[Shader]:
    """At most ``limit`` of them, evenly spread; all of them for ``None``."""
    return shaders[:: -(-len(shaders) // limit)] if limit and shaders else shaders


def evenly_by_folder(shaders: Iterable[Shader], limit: int | None) -> list[Shader]:
    """Of each folder and stage at most ``limit``: generated families have thousands alike."""
    families: dict[tuple[str, Stage], list[Shader]] = defaultdict(list)
    for shader in shaders:
        families[shader.name.rpartition("/")[0], shader.stage].append(shader)
    return [shader for family in families.values() for shader in evenly(family, limit)]


def write_shaders(shaders: Iterable[Shader], folder: Path) -> None:
    """Write each shader to its file under ``folder``."""
    for shader in shaders:
        path = folder / shader.file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(shader.text.encode())
