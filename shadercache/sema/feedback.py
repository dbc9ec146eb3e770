"""Transform feedback: which buffer, at which offset (GLSL 4.60 section 4.4.2)."""

from __future__ import annotations

from collections.abc import Mapping

from shadercache.ast.nodes import Node
from shadercache.lang.types import Type
from shadercache.sema.check_context import Context
from shadercache.sema.layout_words import Place

_WIDE = ("double", "int64_t", "uint64_t")


class Feedback:
    """The strides of the buffers, and the buffer that is written where nothing is said."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._strides: dict[int, int] = {}
        self._default = 0
        self._block = 0

    def check(self, node: Node, values: Mapping[str, int], place: Place) -> None:
        """The ``xfb_`` words of one declaration."""
        buffer = values.get("xfb_buffer", self._default)
        if place.form == "member":
            buffer = values.get("xfb_buffer", self._block)
            if buffer != self._block:
                message = f"the block goes to the buffer {self._block}, its members too"
                self._context.error("SC223", message, node)
        elif place.form == "block":
            self._block = buffer
        elif place.form == "default":
            self._default = buffer
        stride = values.get("xfb_stride")
        if stride is not None and self._strides.setdefault(buffer, stride) != stride:
            known = self._strides[buffer]
            message = f"the stride of the buffer {buffer} was {known}, and is {stride} here"
            self._context.error("SC223", message, node)
        offset, kind = values.get("xfb_offset"), place.type
        if offset is not None and kind is not None:
            unit = 8 if _is_wide(kind) else 4
            if offset % unit:
                message = f"the offset of {kind} is a multiple of {unit}, not {offset}"
                self._context.error("SC223", message, node)


def _is_wide(kind: Type) -> bool:
    if kind.struct is not None:
        return any(_is_wide(field) for field in kind.struct.fields.values())
    return kind.base in _WIDE
