"""Putting a program together: the user's declarations, the runtime's, and a ``main``."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from shadercache.ast import nodes as n
from shadercache.source import NOWHERE
from shadercache.transform.reachable import declared_names


@dataclass(frozen=True, slots=True)
class Shader:
    """A finished shader stage as a tree, with what an engine has to know of it.

    ``inputs`` are varyings of a fragment shader or attributes of a vertex shader.
    """

    module: n.Module
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    uniforms: tuple[str, ...]


def merge(module: n.Module, user: Iterable[n.Decl], *parts: Iterable[n.Decl]) -> n.Module:
    """One module: the runtime's variables, then the user's declarations, then the functions.

    The runtime's variables come first because the user's (cloned) functions may use them. Where
    several parts declare the same variable the first declaration stands. A variable of a struct
    of the user's comes right behind that struct.
    """
    seen: set[str] = set()
    variables: list[n.Decl] = []
    functions: list[n.Decl] = []
    for decl in (item for part in parts for item in part):
        names = declared_names(decl)
        if seen.issuperset(names):
            continue
        seen.update(names)
        (functions if isinstance(decl, n.FunctionDef) else variables).append(decl)
    # Default precisions govern everything behind them.
    precision = [d for d in user if isinstance(d, n.PrecisionDecl)]
    rest: list[n.Decl] = []
    for decl in user:
        if not isinstance(decl, n.PrecisionDecl):
            rest.append(decl)
        if (struct := _defined(decl)) is not None:
            rest += [item for item in variables if _type_name(item) == struct]
            variables = [item for item in variables if _type_name(item) != struct]
    return replace(module, decls=(*precision, *variables, *rest, *functions))


def _defined(decl: n.Decl) -> str | None:
    """The name of the struct that a declaration defines, if it does."""
    struct = decl.type.struct if isinstance(decl, n.VarDecl) else None
    return struct.name if struct is not None else None


def _type_name(decl: n.Decl) -> str | None:
    return decl.type.name if isinstance(decl, n.VarDecl) else None


def without_main(module: n.Module) -> tuple[n.Decl, ...]:
    """The module's declarations except ``main``."""
    return tuple(
        d
        for d in module.decls
        if not (isinstance(d, n.FunctionDef | n.FunctionProto) and _name(d) == "main")
    )


def _name(decl: n.FunctionDef | n.FunctionProto) -> str:
    return decl.name


def with_locations(module: n.Module, locations: dict[str, int]) -> n.Module:
    """The module with ``layout(location = n)`` on the given outputs."""
    decls: list[n.Decl] = []
    for decl in module.decls:
        if isinstance(decl, n.VarDecl) and decl.qualifiers.has("out"):
            names = [item.name for item in decl.declarators]
            if names and names[0] in locations:
                decl = _located(decl, locations[names[0]])
        decls.append(decl)
    return replace(module, decls=tuple(decls))


def _located(decl: n.VarDecl, location: int) -> n.VarDecl:
    others = tuple(i for i in decl.qualifiers.layout or () if i.name != "location")
    item = n.LayoutItem(NOWHERE, "location", n.Literal(NOWHERE, str(location)))
    return replace(decl, qualifiers=replace(decl.qualifiers, layout=(item, *others)))


def interface(module: n.Module) -> Shader:
    """The module with the names of its inputs, outputs and uniforms (blocks and buffers too), in
    order of declaration."""
    inputs: list[str] = []
    outputs: list[str] = []
    uniforms: list[str] = []
    for decl in module.decls:
        if isinstance(decl, n.VarDecl):
            names = [item.name for item in decl.declarators]
        elif isinstance(decl, n.BlockDecl):
            names = [decl.name]
        else:
            continue
        if decl.qualifiers.has("in"):
            inputs += names
        elif decl.qualifiers.has("out"):
            outputs += names
        elif decl.qualifiers.has("uniform", "buffer"):
            uniforms += names
    return Shader(module, tuple(inputs), tuple(outputs), tuple(uniforms))


def variable(kind: str, name: str, precision: str | None = None) -> n.VarDecl:
    """A plain global variable."""
    words = n.Qualifiers(NOWHERE, (precision,)) if precision else n.NO_QUALIFIERS
    return n.VarDecl(NOWHERE, words, n.TypeSpec(NOWHERE, kind), (n.Declarator(NOWHERE, name),))


def call_all(name: str, callees: Iterable[str]) -> n.FunctionDef:
    """A function without parameters or result that calls others like it."""
    calls = tuple(n.ExprStmt(NOWHERE, n.Call(NOWHERE, callee, ())) for callee in callees)
    proto = n.FunctionProto(NOWHERE, n.NO_QUALIFIERS, n.TypeSpec(NOWHERE, "void"), name, ())
    return n.FunctionDef(NOWHERE, proto, n.Block(NOWHERE, calls))
