"""Precisions of GLSL ES: of what the compiler adds, and of all there is in proof mode.

Fragment shaders of GLSL ES have no default precision of floats and a middling one of integers and
samplers; a look-up in the cache needs every bit. The user's own declarations stay as they are; ours
are those that have no place in the source::

    uniform sampler2D sc_cache;        =>        uniform highp sampler2D sc_cache;
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.lang.types import builtin_type
from shadercache.lang.words import PRECISIONS
from shadercache.source import NOWHERE
from shadercache.transform.trees import change_declarations, replace_nodes

# Not every type has a default precision in fragment shaders (GLSL ES 3.20 section 4.7.4).
_DEFAULTS = ("float", "int", "sampler2D", "samplerCube")


def with_precisions(module: n.Module, memo: Memo) -> n.Module:
    """The module with ``highp`` on the declarations that are not the user's, if it is GLSL ES."""
    return _each(module, _ours_precise, memo) if module.profile == "es" else module


def all_highp(module: n.Module, memo: Memo) -> n.Module:
    """The module with ``highp`` in the place of every other precision, the default ones too."""
    defaults = (n.PrecisionDecl(NOWHERE, "highp", n.TypeSpec(NOWHERE, kind)) for kind in _DEFAULTS)
    precise = _each(module, _precise, memo)
    return replace(precise, decls=(*defaults, *precise.decls))


def _each(module: n.Module, choose: Callable[[n.Node, n.Node], n.Node], memo: Memo) -> n.Module:
    """The module with every declaration rewritten, each by itself: other programs have it too."""
    known: dict[n.Decl, n.Decl] = memo.table(choose.__name__)

    def changed(decl: n.Decl) -> n.Decl:
        if decl not in known:
            known[decl] = replace_nodes(decl, choose)
        return known[decl]

    return change_declarations(module, changed)


def _precise(_: n.Node, node: n.Node) -> n.Node:
    match node:
        case n.PrecisionDecl():
            return replace(node, precision="highp")
        case n.Qualifiers(words=words) if not PRECISIONS.isdisjoint(words):
            highp = ("highp" if word in PRECISIONS else word for word in words)
            return replace(node, words=tuple(highp))
    return node


def _ours_precise(_: n.Node, node: n.Node) -> n.Node:
    if not isinstance(node, n.VarDecl | n.Param | n.FunctionProto):
        return node
    kind = builtin_type(node.type.name)
    # Structs, `void` and booleans have no precision.
    plain = kind is None or kind.is_void or kind.base == "bool"
    # The user's own declarations have a place in the source.
    if node.span.start >= 0 or plain or node.qualifiers.has(*PRECISIONS):
        return node
    words = (*node.qualifiers.words, "highp")
    return replace(node, qualifiers=replace(node.qualifiers, words=words))
