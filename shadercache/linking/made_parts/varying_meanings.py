"""What the varyings of a fragment shader commonly are, by their names and types."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal, TypeAlias

from shadercache.lang.types import Type
from shadercache.linking.first_scene.meanings import plain

Space: TypeAlias = Literal["object", "world", "view"]

_IN_SPACE: dict[str, str] = {
    "position": "the position",
    "normal": "the normal",
    "tangent": "the tangent",
    "bitangent": "the bitangent",
    "frame": "tangent, bitangent and normal",
    "to_eye": "the way to the eye",
}
_WORDS = {
    "uv": "texture coordinates",
    "uv1": "the second texture coordinates",
    "color": "the colour of the vertex",
    "depth": "the distance along the view",
    "clip": "the position in clip space",
}
_SIZES: dict[str, tuple[int, ...]] = {
    **dict.fromkeys(("position", "normal", "tangent", "color"), (3, 4)),
    **dict.fromkeys(("bitangent", "to_eye"), (3,)),
    **{"uv": (2,), "uv1": (2,), "depth": (1,), "clip": (4,)},
}

# Tried in this order. Texture coordinates come before what hands on something of a light, for
# there are coordinates of light maps.
_NAMES: tuple[tuple[str | None, re.Pattern[str]], ...] = (
    ("uv1", re.compile(r"(?:uv|(?<!ver)tex.*|st)[1-9]$|lightmap")),
    ("uv", re.compile(r"uv|(?<!ver)tex|^st$|^coords?$")),
    (None, re.compile(r"light|sun|lamp|shadow|prev|last|old|instance|refl|refr|wind|bone|morph")),
    ("bitangent", re.compile(r"bitan|binorm")),
    ("tangent", re.compile(r"tan")),
    ("normal", re.compile(r"norm|nrm|^n$")),
    ("to_eye", re.compile(r"(?:view|eye|camera|cam)(?:er)?(?:dir|vec|ray)|to(?:eye|view|cam)")),
    ("to_eye", re.compile(r"^(?:view|eye|viewer|camera)$|^viewposition$")),
    ("color", re.compile(r"colou?r|^col$|tint|albedo|diffuse")),
    ("depth", re.compile(r"depth|dist|^z$")),
    ("clip", re.compile(r"clip|ndc|proj|screen")),
    ("position", re.compile(r"pos|vert|point|place|coord|^p$|^(?:world|local|object|frag)$")),
)
# In words that are written together, and as parts of a name.
_SPACES: tuple[tuple[Space, re.Pattern[str], frozenset[str]], ...] = (
    ("world", re.compile(r"world"), frozenset(("ws", "w"))),
    ("object", re.compile(r"object|local|model"), frozenset(("os", "obj"))),
    ("view", re.compile(r"view|eye|cam"), frozenset(("mv", "ec", "vs"))),
)
_PARTS = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")
_AFFIX = re.compile(r"^(?:frag(?:ment)?|pixel|ps|vary(?:ing)?|interp\w*?)(?=\w)|(?:out|frag)$")

_THREE = "vViewPosition"
"""In the shaders of three.js this is the way from the surface to the eye."""


@dataclass(frozen=True, slots=True)
class VaryingMeaning:
    """What a varying is. ``function``: the one of ``made.vert`` that gives it, without a prefix."""

    what: str
    space: Space | None

    @property
    def function(self) -> str:
        """The name of the function that gives it."""
        return self.what if self.space is None else f"{self.space}_{self.what}"

    @property
    def words(self) -> str:
        """What it is, in words."""
        if self.space is None:
            return _WORDS[self.what]
        space = {"object": "of the object", "world": "of the world", "view": "of the view"}
        return f"{_IN_SPACE[self.what]}, in the space {space[self.space]}"


@dataclass(frozen=True, slots=True)
class Habits:
    """What the whole shader tells about the spaces of its varyings.

    ``sees``: it has a uniform with the place of the eye, so that it lights in the world. ``world``:
    one of its varyings is a position in the world by its name. ``view``: one is of the view.
    """

    sees: bool
    world: bool
    view: bool

    def space_of(self, what: str, name: str) -> Space:
        """The space of something that is in one."""
        told = _space(what, name)
        if told is not None:
            return told
        if what == "position":
            # `FragPos` is a place in the world; a bare position is, where lighting needs one.
            in_world = "frag" in name.lower() or (self.sees and not self.world)
            return "world" if in_world else "object"
        return "view" if self.view and not self.sees else "world"


def _space(what: str, name: str) -> Space | None:
    """The space that a name tells."""
    word, parts = plain(name), {part.lower() for part in _PARTS.findall(name)}
    for space, pattern, abbreviated in _SPACES:
        # The way to the eye has the eye in its name, whatever its space.
        if what == "to_eye" and space == "view":
            continue
        if pattern.search(word) or not abbreviated.isdisjoint(parts):
            return space
    return None


def habits_of(varyings: Iterable[str], sees: bool) -> Habits:
    """What the names of all varyings, and whether there is a uniform of the eye, tell."""
    found = [(_what(_word(name)), name) for name in varyings]
    spaces = {_space("position", name) for what, name in found if what == "position"}
    faced = any(what == "to_eye" and plain(name) == plain(_THREE) for what, name in found)
    return Habits(sees, world="world" in spaces, view="view" in spaces or faced)


def meaning_of(name: str, kind: Type, habits: Habits) -> VaryingMeaning | None:
    """What a varying is; None where its name and type do not say it."""
    what = _what(_word(name))
    if what is None or kind.is_array or kind.base != "float":
        return None
    if kind.is_matrix:
        frame = kind.rows == kind.cols == 3 and what in ("tangent", "normal")
        return VaryingMeaning("frame", habits.space_of("frame", name)) if frame else None
    if kind.rows not in _SIZES[what]:
        return None
    if what not in _IN_SPACE:
        return VaryingMeaning(what, None)
    if name == _THREE:
        return VaryingMeaning(what, "view")
    return VaryingMeaning(what, habits.space_of(what, name))


def _what(word: str) -> str | None:
    if "tbn" in word:
        return "tangent"
    return next((what for what, pattern in _NAMES if pattern.search(word)), None)


def _word(name: str) -> str:
    """A name without what only says that it is a varying: ``normal`` of ``v_fragNormal``."""
    word = plain(name)
    return _AFFIX.sub("", word) or word
