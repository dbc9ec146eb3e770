"""What a scene file says of the inputs of shaders: uniforms, textures, and why they change."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

from shadercache.scene.animation import Animation, Animations, Ramp, Rows
from shadercache.scene.toml_reader import Table, is_number

T = TypeVar("T")

SEMANTICS = (
    "model",
    "view",
    "projection",
    "model-view",
    "view-projection",
    "model-view-projection",
    "normal-matrix",
    "eye",
    "time",
    "time-delta",
    "frame",
    "resolution",
    "resolution-aspect",
)
"""What a uniform can be tied to; ``camera.semantic_values`` and ``scene_values`` define each."""

CAUSES = ("view", "light", "time")
"""Why a uniform may change from frame to frame. Those with a semantic tell it by that."""


@dataclass(frozen=True, slots=True)
class TextureSpec:
    """A texture file and how it is sampled. ``made``: it is generated, and ``path`` says what."""

    path: Path
    filter: str
    mipmap: bool
    wrap: str
    anisotropy: float
    made: bool = False


@dataclass(frozen=True, eq=False)
class Uniforms:
    """What uniforms are given, by name: numbers in the order of upload, semantics, animations."""

    constants: Mapping[str, tuple[float, ...]]
    semantics: Mapping[str, str]
    animated: Animations

    def over(self, other: Uniforms) -> Uniforms:
        """These, and those of ``other`` that have no value here."""

        def rest(values: Mapping[str, T]) -> dict[str, T]:
            return {name: value for name, value in values.items() if name not in mine}

        mine = {*self.constants, *self.semantics, *self.animated}
        return Uniforms(
            rest(other.constants) | dict(self.constants),
            rest(other.semantics) | dict(self.semantics),
            rest(other.animated) | dict(self.animated),
        )


def read_uniforms(table: Table) -> Uniforms:
    """``[uniforms]``; mistakes are noted in the table."""
    constants: dict[str, tuple[float, ...]] = {}
    semantics: dict[str, str] = {}
    animated: dict[str, Animation] = {}
    for name, value in table.values.items():
        if isinstance(value, str) or (isinstance(value, dict) and set(value) == {"semantic"}):
            word = value if isinstance(value, str) else value["semantic"]
            semantics[name] = word
            if word not in SEMANTICS:
                message = f"{table.full(name)}: unknown semantic {word!r}"
                table.problem("SC506", name, message, hint=f"one of {', '.join(SEMANTICS)}")
        elif isinstance(value, dict) and ("table" in value or "start" in value):
            animated[name] = _animation(table.table(name))
        elif (constant := _constant(value)) is not None:
            constants[name] = constant
        else:
            wanted = "a number, an array of numbers, or a semantic"
            table.problem("SC505", name, f"{table.full(name)} must be {wanted}, not {value!r}")
    return Uniforms(constants, semantics, animated)


def _animation(table: Table) -> Animation:
    if not table.has("table"):
        return _ramp(table)
    rows = Rows(
        path=table.file("table"),
        array=table.text("array"),
        rate=table.number("rate", 1.0),
        start=table.number("first", 0.0),
    )
    table.refuse_unknown()
    return rows


def _ramp(table: Table) -> Ramp:
    start, step = (_constant(table.values.get(key)) for key in ("start", "per_frame"))
    known = table.has("start") and table.has("per_frame")
    table.refuse_unknown()
    if not known or start is None or step is None or len(start) != len(step):
        wanted = "start and per_frame, as many numbers in each"
        table.problem("SC505", "start", f"{table.name} must have {wanted}")
        return Ramp((0.0,), (0.0,))
    return Ramp(start, step)


def _constant(value: Any) -> tuple[float, ...] | None:
    """A number, a vector, or equally long vectors one after another; None if it is neither."""
    if isinstance(value, bool) or is_number(value):
        return (float(value),)
    if not isinstance(value, list) or not value:
        return None
    if all(map(is_number, value)):
        return tuple(map(float, value))
    if not all(isinstance(row, list) and row and all(map(is_number, row)) for row in value):
        return None
    if len({len(row) for row in value}) != 1:
        return None
    return tuple(float(number) for row in value for number in row)


def read_textures(table: Table) -> dict[str, TextureSpec]:
    """``[textures.NAME]`` each; mistakes are noted in the table."""
    specs: dict[str, TextureSpec] = {}
    for name in table.values:
        entry = table.table(name)
        specs[name] = TextureSpec(
            path=entry.file("file"),
            filter=entry.text("filter", "linear", ("linear", "nearest")),
            mipmap=entry.boolean("mipmap", False),
            wrap=entry.text("wrap", "repeat", ("repeat", "clamp")),
            anisotropy=entry.number("anisotropy", 1.0),
        )
        entry.refuse_unknown()
    return specs


def read_changes(table: Table, uniforms: Uniforms) -> dict[str, str]:
    """``light = ["u_light"]`` and the like, by the names of uniforms, with what semantics and
    animations tell."""
    found = dict.fromkeys(uniforms.animated, "time") | causes(uniforms.semantics)
    for cause in CAUSES:
        names = table.values.get(cause, [])
        if table.has(cause) and not (isinstance(names, list) and all(map(is_text, names))):
            table.problem("SC505", cause, f"changes.{cause} must be an array of strings")
            continue
        found |= dict.fromkeys(names, cause)
    table.refuse_unknown()
    return found


def causes(semantics: Mapping[str, str]) -> dict[str, str]:
    """Why the uniforms with a semantic change, by name; those of the picture's size do not."""
    return {
        name: "time" if word in ("time", "time-delta", "frame") else "view"
        for name, word in semantics.items()
        if not word.startswith("resolution")
    }


def read_strings(table: Table) -> dict[str, str]:
    """A table of nothing but strings."""
    return {name: table.text(name) for name in table.values}


def is_text(value: Any) -> bool:
    """Whether a TOML value is a string."""
    return isinstance(value, str)
