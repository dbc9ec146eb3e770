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


class Conversions:
    """The implicit conversions of one language version.

    GLSL 1.10 and GLSL ES have none; from 1.20 on integers become floats; 4.00 adds ``int`` to
    ``uint`` and everything to ``double``. Vectors and matrices convert like their components.
    """

    def __init__(self, version: int, es: bool = False) -> None:
        self.ranked = version >= 400 and not es
        """Are conversions ranked when an overload is chosen (4.00 section 6.1)?"""
        if es or version < 120:
            self._widened = _NONE
        else:
            self._widened = _SINCE_400 if version >= 400 else _DESKTOP

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
