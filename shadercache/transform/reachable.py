"""Keep the declarations that ``main`` can reach, and drop the rest.

Functions nobody calls, uniforms, varyings, globals and structs nobody names, outputs nobody wants.
An output that is not wanted but is still read becomes a plain global variable.
"""

from __future__ import annotations

from collections.abc import Iterable, Set
from dataclasses import replace
from itertools import chain

from shadercache.analysis.dataflow import reached
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.walk import walk
from shadercache.lang.words import PRECISIONS
from shadercache.transform.trees import change_declarations


def names_in(node: n.Node) -> set[str]:
    """Every variable, function and type that the piece of program uses."""
    return {part.name for part in walk(node) if isinstance(part, n.Name | n.Call | n.TypeSpec)}


def kept_names(node: n.Node, memo: Memo) -> frozenset[str]:
    """:func:`names_in` for nodes that other programs have as well: functions and their bodies."""
    table: dict[n.Node, frozenset[str]] = memo.table("names")
    if node not in table:
        if isinstance(node, n.FunctionDef):
            # By the body, which is the same node where a pass changes the head alone.
            table[node] = kept_names(node.body, memo) | names_in(node.proto)
        else:
            table[node] = frozenset(names_in(node))
    return table[node]


def declared_names(decl: n.Decl) -> tuple[str, ...]:
    """The names that a global declaration introduces."""
    match decl:
        case n.FunctionDef() | n.FunctionProto():
            return (decl.name,)
        case n.VarDecl():
            struct = decl.type.struct
            named = (struct.name,) if struct and struct.name else ()
            return (*named, *(variable.name for variable in decl.declarators))
        case n.BlockDecl():
            if decl.instance is not None:
                return (decl.instance,)
            return tuple(variable.name for field in decl.fields for variable in field.declarators)
    return ()


def keep_reachable(module: n.Module, wanted: frozenset[str], memo: Memo) -> n.Module:
    """The module without the declarations that neither ``main`` nor ``wanted`` needs."""
    declared: dict[str, list[n.Decl]] = {}
    for decl in module.decls:
        for name in declared_names(decl):
            declared.setdefault(name, []).append(decl)

    def named_by(name: str) -> Iterable[str]:
        return chain.from_iterable(kept_names(decl, memo) for decl in declared.get(name, ()))

    needed = reached(("main", *wanted), named_by).keys()
    return change_declarations(module, lambda decl: _kept(decl, needed, wanted))


def _kept(decl: n.Decl, needed: Set[str], wanted: frozenset[str]) -> n.Decl | tuple[()]:
    match decl:
        # Defaults, like `layout(std140) uniform;`, hold for what is declared behind them.
        case n.PrecisionDecl() | n.QualifierDecl(names=()):
            return decl
        case n.QualifierDecl(names=names):
            # A built-in variable is declared nowhere: ``invariant gl_Position;``.
            kept = tuple(name for name in names if name in needed or name.startswith("gl_"))
            if not kept:
                return ()
            return decl if kept == names else replace(decl, names=kept)
        case n.VarDecl(declarators=(output,)) if decl.qualifiers.has("out"):
            if output.name in wanted:
                return decl
            return _as_global(decl) if output.name in needed else ()
    # A block stays whole: all of its members decide where those that are read lie in the buffer.
    return () if needed.isdisjoint(declared_names(decl)) else decl


def _as_global(decl: n.VarDecl) -> n.VarDecl:
    """An output that is not written any more: its name stays, as a plain variable."""
    # Layouts, `invariant` and interpolation are for what passes between stages.
    keep = tuple(word for word in decl.qualifiers.words if word in {"precise", *PRECISIONS})
    return replace(decl, qualifiers=n.Qualifiers(decl.qualifiers.span, keep))
