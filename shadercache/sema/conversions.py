"""Implicit conversions (GLSL 3.30 section 4.1.10, 4.00 section 4.1.10)."""

from __future__ import annotations

from collections.abc import Mapping

from shadercache.lang.types import Type

_NONE: Mapping[str, tuple[str, ...]] = {}
_DESKTOP: Mapping[str, tuple[str, ...]] = {"int": ("float",), "uint": ("float",)}
_SINCE_400: Mapping[str, tuple[str, ...]] = {
    "int": ("uint", "int64_t", "uint64_t", "float", "double"),
    "uint": ("uint64_t", "float", "double"),
    "int64_t": ("uint64_t", "double"),
    "uint64_t": ("double",),
    "float": ("double",),
}
_FROM_SMALL: Mapping[str, tuple[str, ...]] = {
    "float16_t": ("float", "double"),
    "int16_t": ("uint16_t", "int", "uint", "int64_t", "uint64_t", "float16_t", "float", "double"),
    "uint16_t": ("int", "uint", "int64_t", "uint64_t", "float16_t", "float", "double"),
    "int8_t": (
        *("uint8_t", "int16_t", "uint16_t", "int", "uint", "int64_t", "uint64_t"),
        *("float16_t", "float", "double"),
    ),
    "uint8_t": (
        *("int16_t", "uint16_t", "int", "uint", "int64_t", "uint64_t"),
        *("float16_t", "float", "double"),
    ),
}
"""Conversions of numbers of 8 and 16 bits (GL_EXT_shader_explicit_arithmetic_types)."""

_ARITHMETIC = "GL_EXT_shader_explicit_arithmetic_types"
_CONVERTED = {
    "GL_AMD_gpu_shader_half_float": ("float16_t",),
    "GL_AMD_gpu_shader_int16": ("int16_t", "uint16_t"),
}
_PROMOTED = {
    **dict.fromkeys(("int8_t", "uint8_t", "int16_t", "uint16_t"), "int"),
    **dict.fromkeys(("float16_t", "float"), "double"),
}
"""What a number is promoted to: that is better than any other conversion."""


class Conversions:
    """The implicit conversions of one language version.

    GLSL 1.10 and GLSL ES have none; from 1.20 on integers become floats; 4.00 adds ``int`` to
    ``uint`` and everything to ``double``. Vectors and matrices convert like their components.
    Extensions add numbers of 8 and 16 bits.
    """

    def __init__(
        self, version: int, es: bool = False, extensions: frozenset[str] = frozenset()
    ) -> None:
        self._explicit = any(name.startswith(_ARITHMETIC) for name in extensions)
        self.ranked = (version >= 400 and not es) or self._explicit
        """Are conversions ranked when an overload is chosen (4.00 section 6.1)?"""
        if es or version < 120:
            self._widened = _SINCE_400 if self._explicit else _NONE
        else:
            self._widened = _SINCE_400 if version >= 400 or self._explicit else _DESKTOP
        if self._explicit:
            of_uint = ("int64_t", *self._widened["uint"])
            self._widened = {**self._widened, **_FROM_SMALL, "uint": of_uint}
        for name in extensions & _CONVERTED.keys():
            rows = {base: _FROM_SMALL[base] for base in _CONVERTED[name]}
            self._widened = {**self._widened, **rows}

    def rank(self, given: Type, wanted: Type) -> int:
        """How good the conversion of an argument is, the best first (section 6.1)."""
        if given is wanted:
            return 0
        if self._explicit:
            return 1 if _PROMOTED.get(given.base or "") == wanted.base else 2
        if given.base == "float" and wanted.base == "double":
            return 1
        # From an int, uint is no nearer than float (4.00 section 6.1).
        return 3 if wanted.base == "double" else 2

    def common_base(self, left: str, right: str) -> str | None:
        """The scalar that both scalars become in an operation, or ``None``."""
        if left == right or left in self._widened.get(right, ()):
            return left
        return right if right in self._widened.get(left, ()) else None

    def converts(self, source: Type, target: Type) -> bool:
        """Can a value of type ``source`` stand where ``target`` is wanted?"""
        if source is target:
            return True
        return (
            source.base is not None
            and target.base in self._widened.get(source.base, ())
            and source.rows == target.rows
            and source.cols == target.cols
            and not source.dims
            and not target.dims
        )

    def common(self, left: Type, right: Type) -> Type | None:
        """The one of two types that the other converts to."""
        if self.converts(right, left):
            return left
        return right if self.converts(left, right) else None
