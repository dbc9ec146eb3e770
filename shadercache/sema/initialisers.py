"""Initialisers: expressions, and lists in braces (GLSL 4.20 section 4.1.11).

A list has no type of its own: it gets that of what it initialises, and each item that of the part
it stands for.
"""

from __future__ import annotations

from shadercache.ast.nodes import Expr, InitList
from shadercache.lang.types import VOID, Type, array_of
from shadercache.sema.expression_types import ExpressionChecker
from shadercache.sema.inference_context import InferenceContext
from shadercache.sema.problems import ERROR


class InitialiserChecker:
    """Types of initialisers."""

    def __init__(self, context: InferenceContext, expressions: ExpressionChecker) -> None:
        self._context = context
        self._expressions = expressions

    def check(self, init: Expr, wanted: Type) -> Type:
        """The type of an initialiser of something that is declared as ``wanted``."""
        if isinstance(init, InitList):
            return self._list(init, wanted)
        return self._expressions.check(init)

    def _list(self, node: InitList, wanted: Type) -> Type:
        # Lists nest only as deep as brackets may, so this may recurse.
        kind = self._sized(node, wanted)
        count = _count(kind, len(node.items))
        if count != len(node.items):
            takes = "no list of items" if count is None else f"{count} items"
            kind = self._context.problems.error("SC219", f"{kind} takes {takes} here", node)
        parts = _parts(kind, len(node.items))
        given = [self.check(item, part) for item, part in zip(node.items, parts, strict=True)]
        if kind is not ERROR:
            kind = self._settled(node, kind, parts, given)
        self._context.tables.types[node] = kind
        constants = self._expressions.constants
        if kind is not ERROR and constants.expressions.issuperset(node.items):
            constants.construct(node)
        return kind

    def _sized(self, node: InitList, wanted: Type) -> Type:
        if wanted.dims and wanted.dims[0] is None:
            return array_of(wanted.element, len(node.items))
        return wanted

    def _settled(self, node: InitList, kind: Type, parts: list[Type], given: list[Type]) -> Type:
        """The type of the list, where every item converts to its part."""
        if ERROR in given:
            return ERROR
        if kind.dims and kind.element.is_unsized and len(set(given)) == 1:
            return array_of(given[0], len(given))
        for item, part, found in zip(node.items, parts, given, strict=True):
            if found is VOID or not self._context.language.conversions.converts(found, part):
                message = f"cannot initialise a part of type {part} with {found}"
                return self._context.problems.error("SC210", message, item)
        return kind


def _count(kind: Type, given: int) -> int | None:
    """How many items a list for ``kind`` has; ``None`` where there can be no list."""
    if kind is ERROR:
        return given
    if kind.dims:
        return kind.dims[0] or given
    if kind.struct is not None:
        return len(kind.struct.fields)
    if kind.is_matrix:
        return kind.cols
    return kind.rows if kind.is_vector else None


def _parts(kind: Type, count: int) -> list[Type]:
    """The types of the ``count`` items of a list for ``kind``."""
    if kind is ERROR:
        return [ERROR] * count
    if kind.is_struct and kind.struct is not None:
        return list(kind.struct.fields.values())
    return [kind.element] * count
