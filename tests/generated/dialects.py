"""What the versions of GLSL differ in, as far as generated shaders use it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

FOLDER = Path(__file__).with_name("vertex")


@dataclass(frozen=True)
class Dialect:
    """A version: its first line, the words of its interface, and what it has."""

    name: str
    version: str
    reads: str
    color: str
    es: bool
    modern: bool
    """Has ``switch``, unsigned and bit operations, and the texture functions of GLSL 1.30."""
    sampled: str
    projected: str
    derivatives: bool = True
    arrays: bool = True
    """Has constructors of arrays, and arrays that are indexed by what varies."""
    loops: bool = True
    """Has ``while`` and ``do``, for certain."""

    @property
    def vertex(self) -> str:
        """The vertex shader that goes with it."""
        return (FOLDER / f"{self.name}.vert").read_text(encoding="utf-8")


DIALECTS = {
    item.name: item
    for item in (
        Dialect("gl330", "330", "in", "o_color", False, True, "texture", "textureProj"),
        Dialect(
            "gl120", "120", "varying", "gl_FragColor", False, False, "texture2D", "texture2DProj"
        ),
        Dialect(
            "es100",
            "100",
            "varying",
            "gl_FragColor",
            True,
            False,
            "texture2D",
            "texture2DProj",
            derivatives=False,
            arrays=False,
            loops=False,
        ),
        Dialect("es300", "300 es", "in", "o_color", True, True, "texture", "textureProj"),
    )
}
