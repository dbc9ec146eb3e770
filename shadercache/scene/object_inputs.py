"""What a scene file gives the shaders of an object: attributes, uniforms, textures."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, fields
from difflib import get_close_matches
from functools import lru_cache
from pathlib import Path
from typing import Any, TypeAlias, TypeVar

import numpy as np
from numpy.typing import NDArray

from shadercache.diagnostics import input_error
from shadercache.scene.instances import ALONE, Instances, read_instances
from shadercache.scene.npz import load_npz
from shadercache.scene.streams import Stream
from shadercache.scene.toml_reader import Table, is_number

T = TypeVar("T")

_MATRICES = ("model", "view", "projection", "model-view", "view-projection")
INVERSES = {f"inverse-{word}": word for word in (*_MATRICES, "model-view-projection")}
"""Semantics that are the inverse of another."""

SEMANTICS = (
    *(*_MATRICES, "model-view-projection", *INVERSES),
    *("normal-matrix", "world-normal-matrix", "bones", "morph-weights"),
    *("eye", "time", "time-delta", "frame", "resolution", "resolution-aspect"),
)
"""What a uniform can be tied to; ``camera.semantic_values`` and ``uniform_values`` define each."""

_OF_TIME = ("time", "time-delta", "frame", "bones", "morph-weights")

_ANIMATED = ("semantic", "table", "start")

CAUSES = ("view", "light", "time")
"""Why a uniform may change from frame to frame."""


@dataclass(frozen=True, slots=True)
class TextureSpec:
    """A texture file and how it is sampled; a ``generated`` one has no file but a name."""

    path: Path
    filter: str
    mipmap: bool
    wrap: str
    anisotropy: float
    generated: bool = False


@dataclass(frozen=True, slots=True)
class BufferSpec:
    """What a storage buffer holds: an array of an ``.npz`` file, its bytes as they are stored."""

    path: Path
    array: str

    def content(self) -> bytes:
        """The bytes. Raises :class:`InputError` SC541 for a file without such an array."""
        arrays = load_npz(self.path, "SC541", "the buffer")
        if self.array not in arrays:
            hint = f"it has: {', '.join(sorted(arrays))}"
            message = f"the buffer {self.path} has no array {self.array!r}"
            raise input_error("SC541", message, hint=hint)
        return np.ascontiguousarray(arrays[self.array]).tobytes()


@dataclass(frozen=True, slots=True)
class Ramp:
    """Numbers that change by the same amount in every frame."""

    start: tuple[float, ...]
    per_frame: tuple[float, ...]

    def at(self, frame: int) -> NDArray[np.float64]:
        """The numbers at a frame, in the order of upload."""
        return np.asarray(self.start, np.float64) + frame * np.asarray(self.per_frame, np.float64)


@dataclass(frozen=True, slots=True)
class Rows:
    """Rows of an ``.npz`` file's array (rows, numbers in the order of upload), played in a circle.

    ``rate`` in rows a frame; between two rows the numbers are mixed. ``start`` is the row of
    frame 0.
    """

    path: Path
    array: str
    rate: float = 1.0
    start: float = 0.0

    def at(self, frame: int) -> NDArray[np.float64]:
        """The numbers at a frame. Raises InputError SC541 for a file that does not hold them."""
        rows = _rows(self.path, self.array)
        place = self.start + frame * self.rate
        # Places may be negative, where int() alone would take the row behind.
        low = int(np.floor(place))
        part = place - low
        first, second = rows[low % len(rows)], rows[(low + 1) % len(rows)]
        mixed: NDArray[np.float64] = (1.0 - part) * first + part * second
        return mixed


@dataclass(frozen=True, eq=False)
class Track:
    """The numbers of a uniform as an engine had them: one row a frame, in the order of upload.

    Behind its end it rests at the last row.
    """

    rows: NDArray[np.float64]

    @property
    def moves(self) -> bool:
        """Does it change from frame to frame?"""
        return bool((self.rows != self.rows[0]).any())

    def at(self, frame: int) -> NDArray[np.float64]:
        """The numbers at a frame."""
        row: NDArray[np.float64] = self.rows[min(frame, len(self.rows) - 1)]
        return row


Animation: TypeAlias = Ramp | Rows | Track


@dataclass(frozen=True, eq=False)
class Inputs:
    """By the names that shaders have for them: arrays of the mesh, uniforms, textures.

    ``constants`` hold the numbers of a uniform in the order of upload: the components of a vector,
    the columns of a matrix, the elements of an array. Another uniform is tied to one of
    :data:`SEMANTICS`, or ``animated``. ``played`` are textures and storage buffers of 32-bit floats
    that may change from frame to frame.
    """

    attributes: Mapping[str, str] = field(default_factory=dict)
    constants: Mapping[str, tuple[float, ...]] = field(default_factory=dict)
    semantics: Mapping[str, str] = field(default_factory=dict)
    animated: Mapping[str, Animation] = field(default_factory=dict)
    textures: Mapping[str, TextureSpec] = field(default_factory=dict)
    buffers: Mapping[str, BufferSpec] = field(default_factory=dict)
    played: Mapping[str, Stream] = field(default_factory=dict)
    instances: Instances = ALONE

    def over(self, other: Inputs) -> Inputs:
        """These, and those of ``other`` that have no value here."""
        # A uniform has one source, so a name in one group drops it from the others.
        mine = {*self.constants, *self.semantics, *self.animated}

        def rest(values: Mapping[str, T]) -> dict[str, T]:
            return {name: value for name, value in values.items() if name not in mine}

        return Inputs(
            {**other.attributes, **self.attributes},
            {**rest(other.constants), **self.constants},
            {**rest(other.semantics), **self.semantics},
            {**rest(other.animated), **self.animated},
            {**other.textures, **self.textures},
            {**other.buffers, **self.buffers},
            {**other.played, **self.played},
            other.instances if self.instances is ALONE else self.instances,
        )

    def with_aliases(self, renamed: Mapping[str, str]) -> Inputs:
        """The same, with everything also under its new name."""
        groups = {
            group.name: with_aliases(getattr(self, group.name), renamed)
            for group in fields(self)
            if group.name != "instances"
        }
        return Inputs(**groups, instances=self.instances.renamed(renamed))

    @property
    def causes(self) -> dict[str, str]:
        """Why uniforms change, by name: one of :data:`CAUSES`, which animations and semantics say.

        Those of the picture's size do not change.
        """
        by_semantic = {
            name: "time" if word in _OF_TIME else "view"
            for name, word in self.semantics.items()
            if not word.startswith("resolution")
        }
        return dict.fromkeys(self.animated, "time") | by_semantic


def root_of(name: str) -> str:
    """The variable that a uniform is part of: ``light`` of ``light.color`` and ``light[1]``."""
    return name.partition("[")[0].partition(".")[0]


def with_aliases(values: Mapping[str, T], renamed: Mapping[str, str]) -> dict[str, T]:
    """Values of which those named ``old``, ``old[0]`` or ``old.member`` have their new name too."""
    both = dict(values)
    for name, value in values.items():
        root = root_of(name)
        if root in renamed:
            both[renamed[root] + name[len(root) :]] = value
    return both


def read_inputs(table: Table) -> Inputs:
    """``[attributes]``, ``[uniforms]`` and ``[textures]`` of a table."""
    constants: dict[str, tuple[float, ...]] = {}
    semantics: dict[str, str] = {}
    animated: dict[str, Animation] = {}
    uniforms = table.table("uniforms")
    for name, value in uniforms.items():
        if isinstance(value, str) or (isinstance(value, dict) and set(value) == {"semantic"}):
            word = semantics[name] = value if isinstance(value, str) else value["semantic"]
            if word not in SEMANTICS:
                message = f"{uniforms.full(name)}: unknown semantic {word!r}"
                near = get_close_matches(str(word), SEMANTICS, 1)
                meant = f"did you mean {near[0]!r}? " if near else ""
                uniforms.problem("SC506", name, message, f"{meant}one of {', '.join(SEMANTICS)}")
        elif isinstance(value, dict) and ("table" in value or "start" in value):
            animated[name] = _read_animation(uniforms.table(name))
        elif isinstance(value, dict) and not set(value) & set(_ANIMATED):
            _refuse_dots(uniforms, name, value)
        else:
            wanted = "a number, an array of numbers, or a semantic"
            value = uniforms.checked(name, wanted, lambda v: bool(constant_of(v)), stand_in=0.0)
            constants[name] = constant_of(value)
    attributes = read_names(table.table("attributes"))
    textures, played = _textures(table.table("textures"))
    instances = read_instances(table.table("instances")) if table.has("instances") else ALONE
    buffers: dict[str, BufferSpec] = {}
    for name, entry in _tables(table.table("buffers")):
        path, array = entry.file("table"), entry.text("array")
        if entry.has("rate"):
            played[name] = Stream(path, array, entry.number("rate", 1.0), dims=1)
        else:
            buffers[name] = BufferSpec(path, array)
    return Inputs(attributes, constants, semantics, animated, textures, buffers, played, instances)


def _refuse_dots(uniforms: Table, name: str, value: dict[str, Any]) -> None:
    """A dot outside of quotes makes a table of its own."""
    member = next(iter(value), None)
    message = f"{uniforms.full(name)} must be a number, an array of numbers, or a semantic"
    if member is None:
        uniforms.problem("SC505", name, f"{message}, not an empty table")
        return
    inner = value[member]
    known = isinstance(inner, dict | str) or bool(constant_of(inner))
    hint = "what moves has start and per_frame, or table and array"
    hint = f'write "{name}.{member}" in quotes; {hint}' if known else hint
    near = get_close_matches(member, _ANIMATED, 1)
    if near:
        hint = f"did you mean {near[0]}?"
    uniforms.problem("SC505", name, f"{message}, not a table with the key {member}", hint)


def _read_animation(table: Table) -> Animation:
    if table.has("table"):
        return Rows(
            path=table.file("table"),
            array=table.text("array"),
            rate=table.number("rate", 1.0),
            start=table.number("first", 0.0),
        )
    start, step = (constant_of(table.values.get(key)) for key in ("start", "per_frame"))
    known = table.has("start") and table.has("per_frame")
    fits = known and bool(start) and len(start) == len(step)
    table.require(
        fits, "start", f"{table.name} must have start and per_frame, as many numbers in each"
    )
    return Ramp(start, step) if fits else Ramp((0.0,), (0.0,))


def constant_of(value: Any) -> tuple[float, ...]:
    """A number, a vector, or equally long vectors one after another; empty if it is neither."""
    if isinstance(value, bool) or is_number(value):
        return (float(value),)
    if not isinstance(value, list) or not value:
        return ()
    if all(map(is_number, value)):
        return tuple(map(float, value))
    if not all(isinstance(row, list) and row and all(map(is_number, row)) for row in value):
        return ()
    if len({len(row) for row in value}) != 1:
        return ()
    return tuple(float(number) for row in value for number in row)


def _tables(table: Table) -> Iterator[tuple[str, Table]]:
    return ((name, table.table(name)) for name, _ in table.items())


def _textures(table: Table) -> tuple[dict[str, TextureSpec], dict[str, Stream]]:
    """Those in files, and those that are played."""
    specs: dict[str, TextureSpec] = {}
    played: dict[str, Stream] = {}
    for name, entry in _tables(table):
        if entry.has("table"):
            rate = entry.number("rate", 1.0)
            played[name] = Stream(entry.file("table"), entry.text("array"), rate, dims=3)
            continue
        specs[name] = TextureSpec(
            path=entry.file("file"),
            filter=entry.text("filter", "linear", ("linear", "nearest")),
            mipmap=entry.boolean("mipmap", False),
            wrap=entry.text("wrap", "repeat", ("repeat", "clamp")),
            anisotropy=entry.number("anisotropy", 1.0),
        )
    return specs, played


def read_changes(table: Table, inputs: Inputs) -> dict[str, str]:
    """Why uniforms change: ``light = ["u_light"]`` and the like, beside what the inputs say."""
    changes = inputs.causes
    for cause in CAUSES:
        changes |= dict.fromkeys(table.texts(cause), cause)
    return changes


def read_names(table: Table) -> dict[str, str]:
    """A table of nothing but strings."""
    return {name: table.text(name) for name, _ in table.items()}


@lru_cache(maxsize=32)
def _rows(path: Path, name: str) -> NDArray[np.float64]:
    arrays = load_npz(path, "SC541", "the animation")
    if name not in arrays:
        hint = f"it has: {', '.join(sorted(arrays))}"
        raise input_error("SC541", f"the animation {path} has no array {name!r}", hint=hint)
    stored = arrays[name]
    if stored.dtype.kind not in "fiu" or stored.ndim < 2 or not stored.size:
        shape = f"{stored.dtype} {stored.shape}"
        raise input_error("SC541", f"array {name!r} of {path} has no rows of numbers: {shape}")
    rows: NDArray[np.float64] = stored.reshape(len(stored), -1).astype(np.float64)
    if not np.isfinite(rows).all():
        raise input_error("SC541", f"array {name!r} of {path} holds NaN or infinity")
    return rows
