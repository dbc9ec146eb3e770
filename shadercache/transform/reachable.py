"""Keep the declarations that ``main`` can reach, and drop the rest.

Functions nobody calls, uniforms, varyings, globals and structs nobody names, outputs nobody wants.
An output that is not wanted but is still read becomes a plain global variable.
"""

from __future__ import annotations

from dataclasses import replace

from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.walk import walk
from shadercache.lang.words import PRECISIONS


def names_in(node: n.Node) -> set[str]:
    """Every variable, function and type that the piece of program uses."""
    names: set[str] = set()
    for item in walk(node):
        if isinstance(item, n.Name | n.Call | n.TypeSpec):
            names.add(item.name)
    return names


def kept_names(node: n.Node, memo: Memo) -> frozenset[str]:
    """:func:`names_in` for nodes that other programs have as well: functions and their bodies."""
    table: dict[n.Node, frozenset[str]] = memo.table("names")
    found = table.get(node)
    if found is None:
        if isinstance(node, n.FunctionDef):
            found = kept_names(node.body, memo) | names_in(node.proto)
        else:
            found = frozenset(names_in(node))
        table[node] = found
    return found


def declared_names(decl: n.Decl) -> tuple[str, ...]:
    """The names that a global declaration introduces."""
    match decl:
        case n.FunctionDef() | n.FunctionProto():
            return (decl.name,)
        case n.VarDecl():
            struct = decl.type.struct
            named = (struct.name,) if struct and struct.name else ()
            return (*named, *(item.name for item in decl.declarators))
        case n.BlockDecl():
            if decl.instance is not None:
                return (decl.instance,)
            return tuple(item.name for field in decl.fields for item in field.declarators)
        case _:
            return ()


def keep_reachable(module: n.Module, wanted: frozenset[str], memo: Memo) -> n.Module:
    """The module without the declarations that neither ``main`` nor ``wanted`` needs."""
    needed = _needed_names(module, wanted | {"main"}, memo)
    decls: list[n.Decl] = []
    for decl in module.decls:
        kept = _keep(decl, needed, wanted)
        if kept is not None:
            decls.append(kept)
    if len(decls) == len(module.decls) and all(
        new is old for new, old in zip(decls, module.decls, strict=True)
    ):
        return module
    return replace(module, decls=tuple(decls))


def _needed_names(module: n.Module, roots: frozenset[str], memo: Memo) -> set[str]:
    declared: dict[str, list[n.Decl]] = {}
    for decl in module.decls:
        for name in declared_names(decl):
            declared.setdefault(name, []).append(decl)
    needed: set[str] = set()
    todo = list(roots)
    seen: set[n.Decl] = set()
    while todo:
        name = todo.pop()
        if name in needed:
            continue
        needed.add(name)
        for decl in declared.get(name, ()):
            if decl not in seen:
                seen.add(decl)
                todo.extend(kept_names(decl, memo))
    return needed


def _keep(decl: n.Decl, needed: set[str], wanted: frozenset[str]) -> n.Decl | None:
    match decl:
        case n.PrecisionDecl():
            return decl
        case n.QualifierDecl():
            names = tuple(name for name in decl.names if name in needed or name.startswith("gl_"))
            if decl.names and not names:
                return None
            return decl if names == decl.names else replace(decl, names=names)
        case n.VarDecl() if decl.declarators and decl.qualifiers.has("out"):
            (item,) = decl.declarators
            if item.name in wanted:
                return decl
            return _as_global(decl) if item.name in needed else None
        case _:
            return decl if needed.intersection(declared_names(decl)) else None


def _as_global(decl: n.VarDecl) -> n.VarDecl:
    """An output that is not written any more: its name stays, as a plain variable."""
    keep = tuple(word for word in decl.qualifiers.words if word in {"precise", *PRECISIONS})
    return replace(decl, qualifiers=n.Qualifiers(decl.qualifiers.span, keep))
