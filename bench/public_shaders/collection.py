"""A collection: shaders by name, written to a folder so that the judge and people can read them."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

Stage = Literal["vertex", "fragment"]
SUFFIXES: dict[Stage, str] = {"vertex": ".vert", "fragment": ".frag"}

_UNSAFE = re.compile(r"[^\w./+-]+")


@dataclass(frozen=True, slots=True)
class Shader:
    """One shader: where it stands under ``out/public/shaders``, and its text."""

    name: str
    stage: Stage
    text: str

    @property
    def file(self) -> str:
        """Its path in the folder of all shaders; the suffix tells the stage."""
        return _UNSAFE.sub("_", self.name) + SUFFIXES[self.stage]

    @property
    def key(self) -> str:
        """The same for the same text and stage, whatever the name."""
        return hashlib.sha256(f"{self.stage}\0{self.text}".encode()).hexdigest()[:32]


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


def write_shaders(shaders: Iterable[Shader], folder: Path) -> None:
    """Write each shader to its file under ``folder``; what stands there already stays."""
    for shader in shaders:
        path = folder / shader.file
        data = shader.text.encode()
        if not path.exists() or path.read_bytes() != data:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(data)
