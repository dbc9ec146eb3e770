"""What compilers say of emitted programs: glslang, and the driver of this machine."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from manifests import plain

from tests.glslang import objections

if TYPE_CHECKING:
    from shadercache.compiler import Emission
    from shadercache.gpu.context import Gpu

Pair = tuple[str, str]


def pairs_of(emission: Emission[Any]) -> list[Pair]:
    """The texts of vertex and fragment shader of every program of an emission."""
    manifest = plain(emission.manifest)
    passes: list[Any] = [item for v in manifest.get("variants", ()) for item in v["passes"]]
    passes += [manifest[name] for name in ("original", "payload", "debug") if name in manifest]
    return [(emission.files[p["vertex"]], emission.files[p["fragment"]]) for p in passes]


def without_heading(text: str) -> str:
    """A program without the comment that names its node: two that differ in it are one."""
    return "\n".join(line for line in text.split("\n") if not line.startswith("// shadercache:"))


def errors_of_reference(pairs: Iterable[Pair], folder: Path) -> list[str]:
    """What glslang says against the programs, shader by shader; nothing where it is missing."""
    texts = [
        (name, without_heading(text))
        for pair in pairs
        for name, text in zip(("x.vert", "x.frag"), pair, strict=True)
    ]
    return [line for line in objections(texts, folder) if line.startswith("ERROR")]


def errors_of_driver(gpu: Gpu, pairs: Iterable[Pair]) -> list[str]:
    """What the driver says against the programs, compiled and linked."""
    import moderngl

    found: list[str] = []
    for vertex, fragment in dict.fromkeys(
        (without_heading(a), without_heading(b)) for a, b in pairs
    ):
        try:
            gpu.ctx.program(vertex_shader=vertex, fragment_shader=fragment).release()
        except moderngl.Error as error:
            found.append(f"{error}\n{vertex}\n{fragment}")
    return found
