"""Default precisions (GLSL ES 1.00 section 4.5.3, ES 3.00 section 4.5.4).

GLSL ES wants a precision for every float, integer and sampler; desktop GLSL takes the words and
ignores them. A fragment shader has no default for ``float``.
"""

from __future__ import annotations

from shadercache.ast.nodes import Node, PrecisionDecl, Qualifiers
from shadercache.lang.types import FLOAT, INT, Type
from shadercache.lang.words import PRECISIONS
from shadercache.sema.check_context import ERROR, Context

_ALWAYS = frozenset(("int", "sampler2D", "samplerCube", "samplerExternalOES", "atomic_uint"))


class Precisions:
    """Looks whether what is declared has a precision, its own or a default."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._given = set(_ALWAYS)
        if context.stage == "vertex":
            self._given.add("float")

    def require(self, kind: Type, qualifiers: Qualifiers, node: Node) -> None:
        """Complain about a type without a precision; once for each sort of type."""
        if not self._context.es:
            return
        sort = _sort(kind)
        if not PRECISIONS.isdisjoint(qualifiers.words):
            if sort is None and kind is not ERROR:
                self._context.error("SC221", f"{kind} has no precision", node)
            return
        if sort is None or sort in self._given or _key(sort) in self._context.scopes.visible:
            return
        self._given.add(sort)
        message = f"{kind} has no precision, and {sort} no default one"
        hint = f"write 'precision mediump {sort};' at the top"
        self._context.error("SC228", message, node, hint)

    def declare(self, decl: PrecisionDecl, kind: Type) -> None:
        """``precision mediump float;``: for float, int and opaque types, until the scope ends."""
        if kind not in (FLOAT, INT, ERROR) and not kind.is_opaque:
            message = f"there is no default precision of {kind}"
            self._context.error("SC221", message, decl.type)
        sort = _sort(kind)
        if sort is not None:
            self._context.scopes.declare(_key(sort), kind)


def _sort(kind: Type) -> str | None:
    """The type whose default precision counts for ``kind``; ``None`` where none does."""
    if kind is ERROR or kind.struct is not None or kind.is_void:
        return None
    if kind.base is None:
        return kind.name
    return {"float": "float", "int": "int", "uint": "int"}.get(kind.base)


def _key(sort: str) -> str:
    """A name no variable can have: default precisions end with their scope, as names do."""
    return f"precision {sort}"
