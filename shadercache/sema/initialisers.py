"""Initialisers: expressions, and lists in braces (GLSL 4.20 section 4.1.11).

A list has no type of its own: it gets that of what it initialises, and each item that of the part
it stands for.
"""

from __future__ import annotations

from shadercache.ast.nodes import Expr, InitList
from shadercache.lang.types import VOID, Type, array_of
from shadercache.sema.inference_context import InferenceContext
from shadercache.sema.problems import ERROR


def initialiser_type(context: InferenceContext, init: Expr, wanted: Type) -> Type:
    """The type of an initialiser of something that is declared as ``wanted``."""
    if not isinstance(init, InitList):
        return context.check(init)
    # Lists nest only as deep as brackets may, so this may recurse.
    kind, count = wanted, len(init.items)
    if wanted.dims and wanted.dims[0] is None:
        kind = array_of(wanted.element, count)
    room = _room(kind, count)
    if room != count:
        takes = "no list of items" if room is None else f"{room} items"
        kind = context.problems.error("SC219", f"{kind} takes {takes} here", init)
    if kind.is_struct and kind.struct is not None:
        parts = list(kind.struct.fields.values())
    else:
        parts = [ERROR if kind is ERROR else kind.element] * count
    given = [initialiser_type(context, *pair) for pair in zip(init.items, parts, strict=True)]
    if kind is not ERROR:
        kind = _settled(context, init, kind, parts, given)
    context.tables.types[init] = kind
    if kind is not ERROR and context.constants.expressions.issuperset(init.items):
        context.constants.fold(init, init.items)
    return kind


def _room(kind: Type, count: int) -> int | None:
    """How many items a list for ``kind`` has; ``None`` where there can be no list."""
    if kind is ERROR:
        return count
    if kind.dims:
        return kind.dims[0] or count
    if kind.struct is not None:
        return len(kind.struct.fields)
    size = kind.cols if kind.is_matrix else kind.rows
    return size if size > 1 else None


def _settled(
    context: InferenceContext, node: InitList, kind: Type, parts: list[Type], given: list[Type]
) -> Type:
    """The type of the list, where every item converts to its part."""
    if ERROR in given:
        return ERROR
    if kind.dims and kind.element.is_unsized and len(set(given)) == 1:
        return array_of(given[0], len(given))
    for item, part, item_type in zip(node.items, parts, given, strict=True):
        if item_type is VOID or not context.language.conversions.converts(item_type, part):
            message = f"cannot initialise a part of type {part} with {item_type}"
            return context.problems.error("SC210", message, item)
    return kind
