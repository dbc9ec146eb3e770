"""What the programs say of the payloads of one layout: their variables, how they are packed into
texels and unpacked again. GLSL text, which is parsed once for each layout.

Names in capitals are filled in where they stand (:mod:`shadercache.caching.fill`).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby

from shadercache.analysis.refusals import FIRST_TEXEL
from shadercache.caching.layout import FLOATING, HALVINGS, TEXELS, XYZW, Layout, Leaf, place
from shadercache.lang.types import Type


def payload_text(layout: Layout, prefix: str, whole: bool, numbers: tuple[str, str, str]) -> str:
    """The declarations, where all names have that prefix.

    ``whole``: not every fragment has the payloads. ``numbers``: depths that match nothing, of an
    empty texel, of one that must not be reused, and of one that this frame is yet to compute.
    """
    text, p = _Text(layout, prefix, whole, numbers), prefix
    channel = "uint" if layout.bits else "float"
    set_valid = " ".join(f"{flag} = value;" for flag in text.flags)
    lines = [
        f"const {channel} {p}missed_depth = {numbers[2]};"
        "  // of a texel that this frame is yet to compute",
        f"const {channel} {p}no_depth = {numbers[0]};  // of an empty texel: it matches nothing",
        f"const {channel} {p}poison_depth = {numbers[1]};  // depth of what must not be reused",
        *text.masks(),
        *text.variables(),
        f"void {p}UNPACK() {{ {text.unpacked()} }}",
        f"void {p}TAKE() {{ {text.taken()} }}",
        f"void {p}VALUE() {{ {text.value()} }}",
        f"bool {p}VALID() {{ return {text.valid}; }}",
        f"void {p}SET_VALID(bool value) {{ {set_valid} }}",
        *text.packing(),
        *text.extras(),
        *text.changes(),
    ]
    return "\n".join(lines)


_SIGNED = ("int", "int16_t", "int8_t")
_HUGE = "3.0e38"
"""More than any bound of a change."""


def recalled(layout: Layout, prefix: str) -> dict[str, str]:
    """The variables, with their types, in which a look-up leaves what adapting periods need."""
    if HALVINGS not in layout.extras:
        return {}
    old = {f"{prefix}old_{at}": "float" for at in range(layout.used)}
    return {f"{prefix}halvings": "float", f"{prefix}refreshed": "bool", **old}


def _as_float(text: str, base: str | None, bits: bool) -> str:
    """A channel of a payload's type as a float."""
    if not bits:
        return text
    if base in FLOATING:
        return f"uintBitsToFloat({text})"
    return f"float(int({text}))" if base in _SIGNED else f"float({text})"


def _widened(text: str, base: str | None, count: int = 1) -> str:
    """Half floats as floats, by their values."""
    if base != "float16_t":
        return text
    return f"float({text})" if count == 1 else f"vec{count}({text})"


def _largest(texts: Sequence[str]) -> str:
    """An expression of the largest of some."""
    largest, *rest = texts
    for text in rest:
        largest = f"max({largest}, {text})"
    return largest


class _Text:
    def __init__(
        self, layout: Layout, prefix: str, whole: bool, numbers: tuple[str, str, str]
    ) -> None:
        self.layout, self.prefix, self.whole, self.numbers = layout, prefix, whole, numbers
        self.masked = whole and len(layout.types) > 1
        self.payloads = layout.variables(f"{prefix}payload")
        self.flags = layout.variables(f"{prefix}valid")
        self.valid = " && ".join(self.flags)
        self.texels = [f"{prefix}texel", f"{prefix}texel_2"]
        self.vector = "uvec4" if layout.bits else "vec4"

    def variables(self) -> Iterator[str]:
        """The payloads, and where not every fragment has them, whether it has."""
        precisions = self.layout.precisions or (None,) * len(self.payloads)
        for kind, name, precision in zip(self.layout.types, self.payloads, precisions, strict=True):
            # GLSL ES 3.00 section 4.5.2: only numbers have a precision.
            takes = precision and kind.base in ("float", "int", "uint")
            yield f"{precision} {kind} {name};" if takes else f"{kind} {name};"
        if self.whole:
            for flag in self.flags:
                yield f"bool {flag} = false;  // is there a payload to store?"

    def masks(self) -> Iterator[str]:
        """The channels that hold integers or booleans."""
        for texel, name in enumerate(("discrete", "discrete_2") if self.layout.bits else ()):
            marks = self.layout.integers(texel)
            parts = ", ".join("0xFFFFFFFFu" if mark else "0u" for mark in marks)
            mask = f"uvec4({parts})" if any(marks) else "uvec4(0u)"
            yield f"const uvec4 {self.prefix}{name} = {mask};  // bits that are no float's"

    def unpacked(self) -> str:
        """The assignment of each payload from the texels."""
        rest = iter(self.layout.leaves(self.prefix))
        pairs = zip(self.layout.types, self.payloads, strict=True)
        return " ".join(f"{name} = {self._unpacked(kind, rest)};" for kind, name in pairs)

    def taken(self) -> str:
        """The same from what this frame has stored at the pixel."""
        # Not filtered: beside a NaN a bilinear fetch may give NaN at the very centre of a texel.
        at = f"texelFetch({self.prefix}payloads, {self.prefix}OWN_TEXEL(), 0)"
        one = len(self.layout.leaves("")) == 1 and self.layout.types[0].is_float
        if one and self.layout.used <= FIRST_TEXEL:
            return f"{self.payloads[0]} = {at}.{XYZW[: self.layout.used]};"
        return f"{self.prefix}TEXELS {self.texels[0]} = {at}; {self.unpacked()}"

    def _unpacked(self, kind: Type, leaves: Iterator[Leaf]) -> str:
        """An expression of ``kind`` from the texels, for the next of the leaves."""
        if kind.is_array or kind.struct is not None:
            fields = kind.struct.fields.values() if kind.struct is not None else ()
            inside = [kind.element] * (kind.dims[0] or 0) if kind.is_array else fields
            parts = [self._unpacked(part, leaves) for part in inside]
        else:
            columns = [self._fetched(next(leaves)) for _ in range(kind.cols)]
            parts = [part for column in columns for part in column]
            # Only floats and unsigned integers need no conversion from what a channel holds.
            if kind.cols == len(parts) == 1 and kind.base in ("float", "uint"):
                return parts[0]
        return f"{kind}({', '.join(parts)})"

    def _fetched(self, leaf: Leaf) -> list[str]:
        parts: list[str] = []
        # A vector may lie across both texels, as a `vec4` alone does.
        for texel, channels in groupby(map(place, leaf.channels), key=lambda where: where[0]):
            text = f"{self.texels[texel]}.{''.join(channel for _, channel in channels)}"
            as_float = self.layout.bits and leaf.type.base in FLOATING
            parts.append(f"uintBitsToFloat({text})" if as_float else text)
        return parts

    def extras(self) -> Iterator[str]:
        """Functions that read each extra again from two texels: ``sc_ID(first, second)``."""
        p, params = self.prefix, f"{self.vector} first, {self.vector} second"
        for channel, extra in zip(XYZW, self.layout.tucked, strict=False):
            words = f"{extra.type} {p}{extra.name.upper()}({params})"
            kind = "NUMBER" if extra.type.base == "int" else "OFFSET"
            yield f"{words} {{ return {p}{kind}_IN(first.{channel}); }}"
        for extra in self.layout.extras:
            target, channel = self.layout.extra_places[extra.name]
            text = f"{('first', 'second')[target]}.{channel}"
            if extra.type.base != "float":
                text = f"int({text})"
            elif self.layout.bits:
                text = f"uintBitsToFloat({text})"
            yield f"{extra.type} {p}{extra.name.upper()}({params}) {{ return {text}; }}"

    def changes(self) -> Iterator[str]:
        """What keeps a payload that was found, and tells how far the new one is from it."""
        if HALVINGS not in self.layout.extras:
            return
        p, old = self.prefix, f"{self.prefix}old_"
        channels = range(self.layout.used)
        kinds = [leaf.type.base for leaf in self.layout.leaves(p) for _ in leaf.channels]
        yield from (f"float {old}{at};" for at in channels)
        kept = (
            f"{old}{at} = {_as_float(self._channel(at), base, self.layout.bits)};"
            for at, base in enumerate(kinds)
        )
        yield f"void {p}REMEMBER() {{ {' '.join(kept)} }}"
        now = [
            f"{leaf.path}{f'.{XYZW[i]}' if len(leaf.channels) > 1 else ''}"
            for leaf in self.layout.leaves(p)
            for i in range(len(leaf.channels))
        ]
        # An integer or a boolean that is another has changed, however much.
        apart = [
            f"abs({_widened(text, base)} - {old}{at})"
            if base in FLOATING
            else f"(float({text}) == {old}{at} ? 0.0 : {_HUGE})"
            for at, (text, base) in enumerate(zip(now, kinds, strict=True))
        ]
        yield f"float {p}change_of() {{ return {_largest(apart)}; }}"

    def _channel(self, at: int) -> str:
        texel, channel = place(at)
        return f"{self.texels[texel]}.{channel}"

    def packing(self) -> Iterator[str]:
        """Functions that make the texels to store, and words for them without the depth."""
        # A texel without payloads is empty and matches nothing. So does one that lacks one of
        # several: a later pass takes from it what there is, but the next frame needs all of them.
        p, vector, first, second = self.prefix, self.vector, self.packed(0), self.packed(1)
        depth, zero = f"{p}KEPT_DEPTH()", self._zero(1)
        empty = zero if self.numbers[0] == zero else f"{zero}, {zero}, {zero}, {p}no_depth"
        if self.masked:
            depth = f"{self.valid} ? {depth} : {p}no_depth"
        fails = f"if (!({self.valid})) {{ return {vector}(%s); }} "
        one, two = ("", "") if self.masked or not self.whole else (fails % empty, fails % zero)
        yield f"// What is stored of the payloads{', if there are any' if self.whole else ''}."
        texel = f"{vector}({first}, {depth})"
        texel = f"{p}tucked({texel})" if self.layout.tucked else texel
        yield f"{vector} {p}pack() {{ {one}return {texel}; }}"
        yield f"{vector} {p}pack_2() {{ {two}return {vector}({second}); }}"
        yield f"{vector} {p}PACKED() {{ return {vector}({first}, 0); }}"
        yield f"{vector} {p}PACKED_2() {{ return {vector}({second}); }}"

    def value(self) -> str:
        """Statements that write the payloads in place of the colour."""
        p, first, second = self.prefix, self.packed(0), self.packed(1)
        bits = self.layout.bits
        texel = f"vec4(uvec4({first}, 1u))" if bits else f"vec4({first}, 1.0)"
        more = f" {p}value += vec4({self.vector}({second}));" if self.layout.second else ""
        return f"{p}value = {texel};{more}"

    def packed(self, target: int) -> str:
        """The channels of a texel, those of one vector together, and zeros behind them."""
        taken = self.layout.used + len(self.layout.extras)
        padding = [self._zero(1) for channel in TEXELS[target] if channel >= taken]
        return ", ".join([*self._parts(TEXELS[target]), *padding])

    def _parts(self, channels: range) -> Iterator[str]:
        for leaf in self.layout.stored(self.prefix, self.masked):
            inside = [i for i, channel in enumerate(leaf.channels) if channel in channels]
            if not inside:
                continue
            text = leaf.path
            if len(inside) < len(leaf.channels):
                text += "." + "".join(XYZW[i] for i in inside)
            # In GLSL ES a `mediump int` may have 16 bits, and its sign in another place.
            if self.layout.es and leaf.type.base == "int":
                text = f"{self.prefix}wide_{len(inside)}({text})"
            text = self._to_channel(text, leaf.type.base, len(inside))
            yield f"{leaf.flag} ? {text} : {self._zero(len(inside))}" if leaf.flag else text

    def _zero(self, count: int) -> str:
        """What lies in so many channels that hold nothing."""
        zero, vector = ("0u", "uvec") if self.layout.bits else ("0.0", "vec")
        return zero if count == 1 else f"{vector}{count}({zero})"

    def _to_channel(self, text: str, base: str | None, count: int) -> str:
        text = _widened(text, base, count)
        if not self.layout.bits:
            return text if base in FLOATING else f"float({text})"
        if base == "uint":
            return text
        if base in FLOATING:
            return f"floatBitsToUint({text})"
        return f"uint({text})" if count == 1 else f"uvec{count}({text})"
