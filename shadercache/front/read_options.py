"""How a shader is to be read."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

Dialect = Literal["glsl", "shadertoy", "auto", "vulkan"]

MAX_TOKENS = 2_000_000


@dataclass(frozen=True, slots=True)
class ReadOptions:
    """What the text of a shader alone does not say.

    ``defines`` are macros (name, replacement) that exist before the first line; the name may have
    parameters, as in ``("F(x)", "x + x")``. ``undefined`` takes away predefined macros, such as
    those of extensions that the driver at hand lacks. ``#include`` finds files in
    ``include_folders`` and nowhere else, but for the folder of the file that includes. ``unroll``
    takes loops of few trips apart, so that what they compute can be cached. ``approximate`` offers
    values of the screen as well. ``webgl``: is a file without ``#version`` GLSL ES 1.00? ``None``:
    where it says so. ``moving``: attributes, textures and buffers that change from frame to frame,
    beside those that are guessed; ``none`` among them: nothing is guessed. ``instanced``: several
    instances are drawn at once, as shaders with attributes or numbers of instances are taken to be.
    """

    defines: tuple[tuple[str, str], ...] = ()
    undefined: tuple[str, ...] = ()
    include_folders: tuple[Path, ...] = ()
    max_tokens: int = MAX_TOKENS
    dialect: Dialect = "glsl"
    unroll: bool = False
    approximate: bool = False
    webgl: bool | None = None
    moving: tuple[str, ...] = ()
    instanced: bool = False

    @property
    def of_vertex(self) -> ReadOptions:
        """The same for a vertex shader: a host declares things around fragment shaders only."""
        return self if self.dialect == "vulkan" else replace(self, dialect="glsl")

    @property
    def words(self) -> Iterator[str]:
        """How a shader is read, as the command line says it."""
        for name, text in self.defines:
            yield from ("-D", f"{name}={text}")
        for name in self.undefined:
            yield from ("-U", name)
        for folder in self.include_folders:
            yield from ("-I", str(folder))
        if self.dialect != "glsl":
            yield from ("--dialect", self.dialect)
        if self.unroll:
            yield "--unroll"
        if self.approximate:
            yield "--approximate"
        for name in self.moving:
            yield from ("--moving", name)


DEFAULTS = ReadOptions()
