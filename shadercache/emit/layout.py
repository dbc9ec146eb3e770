"""How payloads lie in the cache: their scalars in the channels of one or two texels.

Three channels of the first texel and four of the second hold the payloads, one behind the other and
each scalar by scalar in the order of a constructor's arguments; the first texel's last channel
holds the depth. What is made of floats alone lies in floats and is filtered. As soon as there is an
integer or a boolean inside, all lies in 32-bit unsigned integers: bits of integers do not survive
in float channels, whose NaNs a driver may change and whose smallest numbers it may flush to zero
(GLSL 4.60 section 4.7.1)::

    vec4                   (x, y, z, depth) (w)
    vec2 and vec3          (x, y, x of the other, depth) (y, z)
    struct { vec2 a; bool b; }    (bits of a.x, bits of a.y, b, bits of the depth)

What a guard keeps beside the payloads (:class:`Extra`: an object's id) lies behind them, one
channel each. It is never part of what is unpacked; the look-up asks for it by name.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby

from shadercache.analysis.candidates import FIRST_TEXEL, SECOND_TEXEL
from shadercache.caching.configuration import CacheFormat, Configuration
from shadercache.lang.types import FLOAT, INT, Type

_XYZW = "xyzw"
_LOCALS = ["texel", "texel_2"]
_NARROWEST = {1: "r", 2: "rg", 3: "rgba", 4: "rgba"}


@dataclass(frozen=True)
class _Leaf:
    """A scalar or vector of a payload: how it is reached, its type, its first channel, and the
    variable that says whether there is such a payload, if one does."""

    path: str
    type: Type
    start: int
    flag: str | None


@dataclass(frozen=True, slots=True)
class Extra:
    """A scalar that each texel holds beside the payloads.

    ``value`` is what is stored: a variable of the ``.glsl`` files, without their prefix. An integer
    in a texel of floats must be small enough to survive there (:data:`MOST_IN_HALF`). The macro
    ``SC_<NAME>_IN(first, second)`` is it again, from the first and, if there is one, second texel.
    """

    name: str
    type: Type
    value: str


@dataclass(frozen=True, slots=True)
class Precision:
    """What a channel of floats holds.

    ``limit`` is the largest number that is reused: of half floats the largest there is
    (:data:`MOST_OF_HALF`); of others so much less that no filter can make infinity of several.
    ``least`` is the smallest above zero that drivers may not make zero of, ``resolution`` how much
    of itself a number is rounded by. Half floats below 2^-14 are rounded, as the format is meant
    to: by 3e-8, and payloads that change their sign have such.
    """

    limit: float
    least: float
    resolution: float


MOST_OF_HALF = 65504.0

PRECISIONS = {
    "16f": Precision(MOST_OF_HALF, 0.0, 2.0**-11),
    "32f": Precision(2.0**126, 2.0**-126, 2.0**-24),
}
"""By the end of a format's name; unsigned integers hold the bits of ``32f``."""


def precision_of(texel: str) -> Precision:
    """What a texel of that format (``rgba16f``) holds."""
    return PRECISIONS["16f" if texel.endswith("16f") else "32f"]


ID, AGE = Extra("id", INT, "object"), Extra("age", FLOAT, "age")

MOST_IN_HALF = 2**11
"""Integers up to this are exact in half floats; in floats those up to 2^24."""


def extras_of(configuration: Configuration) -> tuple[Extra, ...]:
    """What is kept in each texel beside the payloads, in the order in which it lies there."""
    kept = ((configuration.hit_test.ids, ID), (configuration.refresh.age, AGE))
    return tuple(extra for chosen, extra in kept if chosen)


@dataclass(frozen=True)
class Layout:
    """Where each scalar of the payloads lies. ``types`` have at most seven scalars in all.

    ``es``: is it for GLSL ES, where integers may have 16 bits until they are made ``highp``?
    ``precisions`` of the payloads' variables, where they have any. ``extras`` lie behind them; see
    ``fits``.
    """

    types: tuple[Type, ...]
    es: bool = False
    precisions: tuple[str | None, ...] = ()
    extras: tuple[Extra, ...] = ()

    @property
    def bits(self) -> bool:
        """Are the texels unsigned integers?"""
        return any(kind.bases != {"float"} for kind in self.types)

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
        if taken <= FIRST_TEXEL:
            return (taken,)
        return (FIRST_TEXEL, taken - FIRST_TEXEL)

    @property
    def payload_channels(self) -> tuple[int, int]:
        """How many channels of the first and of the second texel the payloads take."""
        return min(self.used, FIRST_TEXEL), max(self.used - FIRST_TEXEL, 0)

    @property
    def extra_places(self) -> dict[str, tuple[int, str]]:
        """Of each extra the number of its texel, 0 or 1, and its channel there."""
        return {
            extra.name: _place(channel)
            for channel, extra in enumerate(self.extras, start=self.used)
        }

    @property
    def places(self) -> tuple[tuple[str, str], ...]:
        """The channels of each payload: in the first texel, and in the second."""
        found: list[tuple[str, str]] = []
        start = 0
        for kind in self.types:
            end = start + kind.components_or_one
            letters = (_XYZW[:FIRST_TEXEL] + _XYZW)[start:end]
            split = max(0, FIRST_TEXEL - start)
            found.append((letters[:split], letters[split:]))
            start = end
        return tuple(found)

    @property
    def second(self) -> bool:
        """Is there a second texel?"""
        return len(self.channels) == 2

    @property
    def read_back(self) -> tuple[tuple[int, bool], ...]:
        """Of each scalar of the payloads its channel in what is read back of both texels, and
        whether it is an integer or a boolean. (The first texel's last channel is the depth.)"""
        leaves = self._leaves("", masked=False)
        whole = [
            leaf.type.base != "float" for leaf in leaves for _ in range(leaf.type.components_or_one)
        ]
        return tuple(
            (channel + int(channel >= FIRST_TEXEL), discrete)
            for channel, discrete in enumerate(whole)
        )

    def variables(self, name: str) -> tuple[str, ...]:
        """What is there for each payload: ``name`` itself, or in a set ``name_1``, ``name_2``..."""
        if len(self.types) == 1:
            return (name,)
        return tuple(f"{name}_{number}" for number in range(1, len(self.types) + 1))

    def formats(self, cache_format: CacheFormat) -> tuple[str, ...]:
        """The format of each texture; ``cache_format`` decides the precision of floats."""
        kind = "32ui" if self.bits else cache_format.removeprefix("rgba")
        return (f"rgba{kind}", *(_NARROWEST[n] + kind for n in self.channels[1:]))

    def macros(self, prefix: str, whole: bool = False) -> dict[str, str]:
        """The macros of the ``.glsl`` files, where all names have that prefix.

        Theirs do not have it: it is still to be put before them, in capitals. ``whole``: not every
        fragment has the payloads.
        """
        flags = self.variables(f"{prefix}valid")
        masked = whole and len(self.types) > 1
        leaves = self._leaves(prefix, masked)
        stored = [*leaves, *self._extra_leaves(prefix)]
        # A constructor must not be hidden by a variable of the function that it stands in.
        names = [f"{prefix}local_{i}" for i in (1, 2)] if self.structs else _LOCALS
        found = {
            "TARGETS": str(len(self.channels)),
            "BITS": str(int(self.bits)),
            "WHOLE": str(int(whole)),
            "MASKED": str(int(masked)),
            "DECLARE_PAYLOADS": "; ".join(self._declared(prefix)),
            "UNPACK": "; ".join(self._assigned(prefix, leaves, names)),
            "DECLARE_VALID": "; ".join(f"bool {flag} = false" for flag in flags),
            "SET_VALID(value)": "; ".join(f"{flag} = value" for flag in flags),
            "VALID": " && ".join(flags),
            **{f"LOCAL_{number}": name for number, name in enumerate(names, start=1)},
        }
        for number, (start, end) in enumerate(
            ((0, FIRST_TEXEL), (FIRST_TEXEL, FIRST_TEXEL + SECOND_TEXEL)), start=1
        ):
            taken = self.used + len(self.extras)
            padding = [self._zero(1)] * (end - max(start, min(end, taken)))
            found[f"PACKED_{number}"] = ", ".join(
                [*self._packed(stored, start, end, prefix), *padding]
            )
            any_discrete = any(_discrete(leaves, start, end))
            found[f"ANY_DISCRETE_{number}"] = str(int(any_discrete))
            marks = ("0xFFFFFFFFu" if mark else "0u" for mark in _discrete(stored, start, end))
            found[f"DISCRETE_{number}"] = f"uvec4({', '.join(marks)})"
        if len(leaves) == 1 and self.types[0].is_float and self.used <= FIRST_TEXEL:
            found["CHANNELS"] = _XYZW[: self.used]
        return found | self._extra_macros()

    def _extra_leaves(self, prefix: str) -> list[_Leaf]:
        return [
            _Leaf(prefix + extra.value, extra.type, channel, None)
            for channel, extra in enumerate(self.extras, start=self.used)
        ]

    def _extra_macros(self) -> dict[str, str]:
        """How each extra is read again from two texels."""
        found: dict[str, str] = {}
        for extra in self.extras:
            texel, channel = self.extra_places[extra.name]
            text = f"{('first', 'second')[texel]}.{channel}"
            if extra.type.base == "float":
                text = f"uintBitsToFloat({text})" if self.bits else text
            else:
                text = f"int({text})"
            found[f"{extra.name.upper()}_IN(first, second)"] = text
        return found

    def _leaves(self, prefix: str, masked: bool) -> list[_Leaf]:
        found: list[_Leaf] = []
        start = 0
        names = zip(
            self.variables(f"{prefix}payload"), self.variables(f"{prefix}valid"), strict=True
        )
        for kind, (name, flag) in zip(self.types, names, strict=True):
            found += _leaves(kind, name, start, flag if masked else None)
            start += kind.components_or_one
        return found

    def _declared(self, prefix: str) -> Iterator[str]:
        """The declaration of each payload's variable."""
        names = self.variables(f"{prefix}payload")
        precisions = self.precisions or (None,) * len(names)
        for kind, name, precision in zip(self.types, names, precisions, strict=True):
            # GLSL ES 3.00 section 4.5.2: only numbers have a precision.
            takes = precision and kind.base in ("float", "int", "uint")
            yield f"{precision} {kind} {name}" if takes else f"{kind} {name}"

    def _assigned(self, prefix: str, leaves: list[_Leaf], names: list[str]) -> Iterator[str]:
        """The assignment of each payload from the texels."""
        rest = iter(leaves)
        for kind, name in zip(self.types, self.variables(f"{prefix}payload"), strict=True):
            yield f"{name} = {self._unpacked(kind, rest, names)}"

    @cached_property
    def structs(self) -> tuple[str, ...]:
        """The names of the structs that the payloads are made of."""
        return tuple(dict.fromkeys(name for kind in self.types for name in _structs(kind)))

    def _packed(self, leaves: list[_Leaf], start: int, end: int, prefix: str) -> list[str]:
        """The channels from ``start`` to ``end``, those of one vector together."""
        parts: list[str] = []
        for leaf in leaves:
            count = leaf.type.components_or_one
            inside = [i for i in range(count) if start <= leaf.start + i < end]
            if not inside:
                continue
            text = leaf.path
            if len(inside) < count:
                text += "." + "".join(_XYZW[i] for i in inside)
            if self.es and leaf.type.base == "int":
                text = f"{prefix}wide_{len(inside)}({text})"
            text = self._to_channel(text, leaf.type.base, len(inside))
            parts.append(f"{leaf.flag} ? {text} : {self._zero(len(inside))}" if leaf.flag else text)
        return parts

    def _zero(self, count: int) -> str:
        """What lies in so many channels that hold nothing."""
        zero, vector = ("0u", "uvec") if self.bits else ("0.0", "vec")
        return zero if count == 1 else f"{vector}{count}({zero})"

    def _to_channel(self, text: str, base: str | None, count: int) -> str:
        if not self.bits:
            return text if base == "float" else f"float({text})"
        if base == "uint":
            return text
        if base == "float":
            return f"floatBitsToUint({text})"
        return f"uint({text})" if count == 1 else f"uvec{count}({text})"

    def _unpacked(self, kind: Type, leaves: Iterator[_Leaf], names: list[str]) -> str:
        """An expression of ``kind`` from the texels, for the next of the leaves."""
        if kind.is_array:
            parts = [self._unpacked(kind.element, leaves, names) for _ in range(kind.dims[0] or 0)]
            return f"{kind}({', '.join(parts)})"
        if kind.struct is not None:
            parts = [self._unpacked(field, leaves, names) for field in kind.struct.fields.values()]
            return f"{kind}({', '.join(parts)})"
        found = [self._fetched(next(leaves), names) for _ in range(kind.cols)]
        parts = [part for column in found for part in column]
        # Only floats and unsigned integers need no conversion from what a channel holds.
        plain = kind.cols == len(parts) == 1 and kind.base in ("float", "uint")
        return parts[0] if plain else f"{kind}({', '.join(parts)})"

    def _fetched(self, leaf: _Leaf, names: list[str]) -> list[str]:
        parts: list[str] = []
        channels = range(leaf.start, leaf.start + leaf.type.components_or_one)
        for number, group in groupby(channels, key=lambda channel: int(channel >= FIRST_TEXEL)):
            first = FIRST_TEXEL if number else 0
            text = f"{names[number]}.{''.join(_XYZW[channel - first] for channel in group)}"
            as_float = self.bits and leaf.type.base == "float"
            parts.append(f"uintBitsToFloat({text})" if as_float else text)
        return parts


def _place(channel: int) -> tuple[int, str]:
    """The texel of a channel, 0 or 1, and the channel's name in it."""
    if channel < FIRST_TEXEL:
        return 0, _XYZW[channel]
    return 1, _XYZW[channel - FIRST_TEXEL]


def _discrete(leaves: list[_Leaf], start: int, end: int) -> list[bool]:
    """Which channels of a texel hold integers or booleans."""
    marks = [False] * 4
    for leaf in leaves:
        for channel in range(leaf.start, leaf.start + leaf.type.components_or_one):
            if start <= channel < end:
                marks[channel - start] = leaf.type.base != "float"
    return marks


def _leaves(kind: Type, path: str, start: int, flag: str | None) -> Iterator[_Leaf]:
    """The scalars and vectors (of a matrix: its columns) inside a value, in order."""
    if kind.is_array or kind.is_matrix:
        count = kind.dims[0] or 0 if kind.is_array else kind.cols
        inner = [(kind.element, f"{path}[{i}]") for i in range(count)]
    elif kind.struct is not None:
        inner = [(field, f"{path}.{name}") for name, field in kind.struct.fields.items()]
    else:
        yield _Leaf(path, kind, start, flag)
        return
    for field, below in inner:
        yield from _leaves(field, below, start, flag)
        start += field.components_or_one


def _structs(kind: Type) -> Iterator[str]:
    if kind.struct is not None:
        for field in kind.struct.fields.values():
            yield from _structs(field)
        yield kind.name
