"""Where atomic counters stand in their buffers (GLSL 4.60 section 4.4.6.1)."""

from __future__ import annotations

from collections.abc import Mapping
from math import prod

from shadercache.ast.nodes import Node
from shadercache.lang.types import Type
from shadercache.sema.check_context import Context

_SIZE = 4


class Counters:
    """The next free offset of each buffer, and the offsets that are taken."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._next: dict[int, int] = {}
        self._taken: dict[tuple[int, int], str] = {}

    def default(self, values: Mapping[str, int]) -> None:
        """``layout(binding = 1, offset = 4) uniform atomic_uint;``: where the next one stands."""
        if "binding" in values:
            self._next[values["binding"]] = values.get("offset", 0)

    def place(self, node: Node, name: str, kind: Type, values: Mapping[str, int]) -> None:
        """A counter, or an array of them, behind the one before, unless its layout says where."""
        context = self._context
        binding = values.get("binding")
        if binding is None:
            context.error("SC223", f"the atomic counter '{name}' needs a binding", node)
            return
        first = values.get("offset", self._next.get(binding, 0))
        if first % _SIZE:
            message = f"the offset of an atomic counter is a multiple of {_SIZE}, not {first}"
            context.error("SC223", message, node)
            return
        behind = first + _SIZE * prod(size or 1 for size in kind.dims)
        self._next[binding] = behind
        for offset in range(first, behind, _SIZE):
            other = self._taken.setdefault((binding, offset), name)
            if other != name:
                message = f"'{name}' and '{other}' share the offset {offset}"
                context.error("SC223", message, node)
                return
