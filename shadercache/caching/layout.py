"""How payloads lie in the cache: their scalars in the channels of one or two texels.

Three channels of the first texel and four of the second hold the payloads, scalar by scalar in the
order of a constructor's arguments. The first texel's last channel holds the depth. Floats alone lie
in floats and are filtered; with an integer or a boolean all lies in 32-bit unsigned integers::

    vec4                   (x, y, z, depth) (w)
    vec2 and vec3          (x, y, x of the other, depth) (y, z)
    struct { vec2 a; bool b; }    (bits of a.x, bits of a.y, b, bits of the depth)

What is kept beside the payloads (:class:`Extra`: an object's id) lies behind them, a channel each.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property

from shadercache.analysis.refusals import FIRST_TEXEL, SECOND_TEXEL
from shadercache.caching.configuration import CacheFormat, Configuration
from shadercache.lang.types import FLOAT, INT, Type

XYZW = "xyzw"
FLOATING = frozenset(("float", "float16_t"))
"""Scalars that lie in channels of floats, by their values."""
TEXELS = (range(FIRST_TEXEL), range(FIRST_TEXEL, FIRST_TEXEL + SECOND_TEXEL))
"""The channels of payloads that lie in each texel."""

# Three channels of floats need not be a render target (OpenGL 4.6 section 8.5.1).
_NARROWEST = {1: "r", 2: "rg", 3: "rgba", 4: "rgba"}


@dataclass(frozen=True)
class Leaf:
    """A scalar or vector of a payload: how it is reached, its type, its first channel, and the
    variable that says whether there is such a payload, if one does."""

    path: str
    type: Type
    start: int
    flag: str | None

    @property
    def channels(self) -> range:
        """The channels that it takes."""
        return range(self.start, self.start + self.type.components_or_one)


@dataclass(frozen=True, slots=True)
class Extra:
    """A scalar that each texel holds beside the payloads.

    ``value`` is what is stored: a variable of the ``.glsl`` files, without their prefix. An integer
    in a texel of floats must be small enough to survive there (:data:`MOST_IN_HALF`).
    """

    name: str
    type: Type
    value: str


@dataclass(frozen=True, slots=True)
class Precision:
    """What a channel of floats holds.

    ``limit`` is the largest number that is reused, ``least`` the smallest above zero that drivers
    may not make zero of, ``resolution`` how much of itself a number is rounded by.
    """

    limit: float
    least: float
    resolution: float


MOST_OF_HALF = 65504.0

POISONED = (-MOST_OF_HALF, -(2.0**-14))
"""Depths of texels that must not be reused: mostly the first, of linear depths the second."""

PRECISIONS = {
    # Below 2^-14 half floats are rounded by 3e-8: payloads that change their sign have such.
    "16f": Precision(MOST_OF_HALF, 0.0, 2.0**-11),
    # So far below the largest that no filter can make infinity of several.
    "32f": Precision(2.0**126, 2.0**-126, 2.0**-24),
}
"""By the end of a format's name; unsigned integers hold the bits of ``32f``."""


def precision_of(texel: str) -> Precision:
    """What a texel of that format (``rgba16f``) holds."""
    return PRECISIONS["16f" if texel.endswith("16f") else "32f"]


def empty_depth(layout: Layout, configuration: Configuration) -> float:
    """What an empty texel has for a depth, in bits as an unsigned integer: it matches nothing."""
    # What is drawn has a positive depth, or with `ndc` one between -1 and 1.
    ndc = configuration.storage.depth == "ndc"
    if layout.bits:
        return float(0x40000000) if ndc else 0.0  # The bits of 2.
    if configuration.filter.marks_depths:
        return 0.0  # It has no sign, so that no slope can lead to it.
    return 2.0 if ndc else -1.0


ID, AGE = Extra("id", INT, "object"), Extra("age", FLOAT, "age")
HALVINGS = Extra("halvings", FLOAT, "halvings")
"""How often the period is halved there, a fraction on its way to the next number."""

OFFSETS = (Extra("offset_x", FLOAT, "offset.x"), Extra("offset_y", FLOAT, "offset.y"))
"""Where a carried sample lies, in pixels from the middle of its texel."""

MOST_IN_HALF = 2**11
"""Integers up to this are exact in half floats; in floats those up to 2^24."""


def extras_of(configuration: Configuration) -> tuple[Extra, ...]:
    """What is kept in each texel beside the payloads, in the order in which it lies there."""
    refresh = configuration.refresh
    kept = (
        (configuration.hit_test.ids, ID),
        (refresh.age, AGE),
        (refresh.adaptive > 0.0, HALVINGS),
    )
    offsets = OFFSETS if configuration.filter.carries else ()
    return (*(extra for chosen, extra in kept if chosen), *offsets)


# Without slots: a cached property is kept in the dictionary of the object.
@dataclass(frozen=True)
class Layout:
    """Where each scalar of the payloads lies. ``types`` have at most seven scalars in all.

    ``es``: is it for GLSL ES, where integers may have 16 bits until they are made ``highp``?
    ``precisions`` of the payloads' variables, where they have any. ``extras`` lie behind them.
    ``tucked``: what lies in the lowest bits of the first channels, one in each.
    """

    types: tuple[Type, ...]
    es: bool = False
    precisions: tuple[str | None, ...] = ()
    extras: tuple[Extra, ...] = ()
    tucked: tuple[Extra, ...] = ()

    @property
    def bits(self) -> bool:
        """Are the texels unsigned integers?"""
        # Bits of integers do not survive in floats: a driver may change NaNs and flush the smallest
        # numbers to zero (GLSL 4.60 section 4.7.1).
        return any(not kind.bases <= FLOATING for kind in self.types)

    @property
    def used(self) -> int:
        """How many channels the payloads take in all."""
        return sum(kind.components_or_one for kind in self.types)

    @property
    def fits(self) -> bool:
        """Is there room for all extras?"""
        return self.used + len(self.extras) <= FIRST_TEXEL + SECOND_TEXEL

    @property
    def channels(self) -> tuple[int, ...]:
        """How many channels of each texel are taken."""
        taken = self.used + len(self.extras)
        return (taken,) if taken <= FIRST_TEXEL else (FIRST_TEXEL, taken - FIRST_TEXEL)

    @property
    def second(self) -> bool:
        """Is there a second texel?"""
        return len(self.channels) == 2

    @property
    def extra_places(self) -> dict[str, tuple[int, str]]:
        """Of each extra the number of its texel, 0 or 1, and its channel there."""
        return {extra.name: place(at) for at, extra in enumerate(self.extras, start=self.used)}

    @property
    def places(self) -> tuple[tuple[str, str], ...]:
        """The channels of each payload: in the first texel, and in the second."""
        places: list[tuple[str, str]] = []
        start = 0
        for kind in self.types:
            texels = ["", ""]
            for texel, channel in map(place, range(start, start + kind.components_or_one)):
                texels[texel] += channel
            places.append((texels[0], texels[1]))
            start += kind.components_or_one
        return tuple(places)

    @cached_property
    def _discrete(self) -> tuple[bool, ...]:
        """Of each channel that is taken: does it hold an integer or a boolean?"""
        return tuple(
            leaf.type.base not in FLOATING for leaf in self.stored("") for _ in leaf.channels
        )

    @property
    def read_back(self) -> tuple[tuple[int, bool], ...]:
        """Of each scalar of the payloads its channel in what is read back of both texels, and
        whether it is an integer or a boolean. (The first texel's last channel is the depth.)"""
        return tuple(
            (channel + int(channel >= FIRST_TEXEL), discrete)
            for channel, discrete in enumerate(self._discrete[: self.used])
        )

    def integers(self, texel: int) -> tuple[bool, ...]:
        """Which channels of a texel, 0 or 1, hold integers or booleans."""
        held = [self._discrete[at] for at in TEXELS[texel] if at < len(self._discrete)]
        return (*held, *[False] * (4 - len(held)))

    def has_integers(self, texel: int) -> bool:
        """Are there any of the payloads in it?"""
        return any(self._discrete[at] for at in TEXELS[texel] if at < self.used)

    def has_floats(self, texel: int) -> bool:
        """Are there any floats in it? The depth is one."""
        return texel == 0 or not all(self._discrete[FIRST_TEXEL:])

    def variables(self, name: str) -> tuple[str, ...]:
        """What is there for each payload: ``name`` itself, or in a set ``name_1``, ``name_2``..."""
        if len(self.types) == 1:
            return (name,)
        return tuple(f"{name}_{number}" for number in range(1, len(self.types) + 1))

    def formats(self, cache_format: CacheFormat) -> tuple[str, ...]:
        """The format of each texture; ``cache_format`` decides the precision of floats."""
        # Floats beside integers lie there by their bits, of which they keep all.
        kind = "32ui" if self.bits else cache_format.removeprefix("rgba")
        kind = "32f" if self.tucked else kind
        # The first texel ends in the depth, so it is never narrower.
        return (f"rgba{kind}", *(_NARROWEST[n] + kind for n in self.channels[1:]))

    def leaves(self, prefix: str, masked: bool = False) -> list[Leaf]:
        """The scalars and vectors of the payloads, whose variables have that prefix.

        ``masked``: may each of them be there or not?
        """
        leaves: list[Leaf] = []
        start = 0
        flags = self.variables(f"{prefix}valid")
        for kind, name, flag in zip(
            self.types, self.variables(f"{prefix}payload"), flags, strict=True
        ):
            for path, part in _parts(kind, name):
                leaves.append(Leaf(path, part, start, flag if masked else None))
                start += part.components_or_one
        return leaves

    def stored(self, prefix: str, masked: bool = False) -> list[Leaf]:
        """The same with the extras behind them: all that lies in a texel beside the depth."""
        extras = (
            Leaf(prefix + extra.value, extra.type, channel, None)
            for channel, extra in enumerate(self.extras, start=self.used)
        )
        return [*self.leaves(prefix, masked), *extras]


def layout_of(
    types: tuple[Type, ...],
    configuration: Configuration,
    es: bool = False,
    precisions: tuple[str | None, ...] = (),
) -> Layout:
    """How payloads of these types lie in the cache of a configuration."""
    layout = Layout(types, es, precisions, extras_of(configuration))
    if not configuration.filter.carries or configuration.storage.format != "rgba16f" or layout.bits:
        return layout
    # A second texture costs more than wider texels: of a float that need not be more precise than
    # half of one, the lowest 12 bits are free. With 32 bits asked for, nothing is rounded.
    for tucked in ((), OFFSETS, (*OFFSETS, ID)):
        others = tuple(extra for extra in layout.extras if extra not in tucked)
        one = replace(layout, extras=others, tucked=tucked)
        if not one.second:
            return one
    return layout


def place(channel: int) -> tuple[int, str]:
    """The texel of a channel, 0 or 1, and the channel's name in it."""
    texel = int(channel >= FIRST_TEXEL)
    return texel, XYZW[channel - TEXELS[texel].start]


def _parts(kind: Type, path: str) -> Iterator[tuple[str, Type]]:
    """The scalars and vectors (of a matrix: its columns) inside a value, in order."""
    if kind.is_array or kind.is_matrix:
        count = kind.dims[0] or 0 if kind.is_array else kind.cols
        inside = [(f"{path}[{i}]", kind.element) for i in range(count)]
    elif kind.struct is not None:
        inside = [(f"{path}.{name}", field) for name, field in kind.struct.fields.items()]
    else:
        yield path, kind
        return
    for below, part in inside:
        yield from _parts(part, below)


def structs_in(types: Iterable[Type]) -> dict[str, None]:
    """The names of the structs that values of these types are made of, inner ones first."""
    names: dict[str, None] = {}
    for kind in types:
        if kind.struct is not None:
            names |= structs_in(kind.struct.fields.values())
            names[kind.name] = None
    return names
