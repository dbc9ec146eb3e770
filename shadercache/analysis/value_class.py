"""What kind of thing values depend on: the surface, the view, or the screen.

``screen``: where or how large a surface is seen (:mod:`analysis.screen`, derivatives). ``view``:
the camera, by what a scene says changes with it; without one, by the projection that the vertex
shader multiplies the position by, and by names. All else is of the ``surface``.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Literal, TypeAlias

ValueClass: TypeAlias = Literal["surface", "view", "screen"]

_WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")
_VIEW = frozenset(
    (
        *("eye", "cam", "camera", "view", "viewer", "viewpos", "viewdir", "modelview", "worldview"),
        *("mv", "vp", "pv", "mvp", "wvp", "pvm", "viewproj", "viewprojection", "viewmatrix"),
        *("modelviewprojection", "modelviewproj", "eyepos", "campos", "camerapos"),
    )
)
# A shadow map has a view of its own, and a viewport is a size.
_OTHER = frozenset(("light", "sun", "shadow", "port"))


def is_of_view(name: str) -> bool:
    """Is a uniform the camera's, by its name: ``u_eye``, ``viewMatrix``, ``cameraPosition``?"""
    words = {word.lower() for word in _WORD.findall(name)}
    # By convention normals are brought into the space of the eye.
    return not words & _OTHER and bool(words & _VIEW or {"normal", "matrix"} <= words)


def class_of(
    on_screen: bool,
    uniforms: Iterable[str],
    projection: frozenset[str],
    changes: Mapping[str, str] | None,
) -> ValueClass:
    """The class of a value that depends on these uniforms, through varyings too.

    ``projection``: the uniforms that bring the position onto the screen; ``changes``: which inputs
    change in a scene, and with what.
    """
    if on_screen:
        return "screen"
    if changes is not None:
        return "view" if any(changes.get(name) == "view" for name in uniforms) else "surface"
    return "view" if any(is_of_view(n) or n in projection for n in uniforms) else "surface"
