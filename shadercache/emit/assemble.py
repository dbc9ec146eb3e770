"""Putting a program together: the user's declarations, the runtime's, and a ``main``."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

from shadercache.ast import nodes as n
from shadercache.emit.packing import has_word
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

    Of several declarations of a variable the first stands.
    """
    seen: set[str] = set()
    variables: list[n.Decl] = []
    functions: list[n.Decl] = []
    for decl in (one for part in parts for one in part):
        names = declared_names(decl)
        if seen.issuperset(names):
            continue
        seen.update(names)
        (functions if isinstance(decl, n.FunctionDef) else variables).append(decl)
    # A default precision governs what is declared behind it.
    precision = [d for d in user if isinstance(d, n.PrecisionDecl)]
    rest: list[n.Decl] = []
    for decl in user:
        if not isinstance(decl, n.PrecisionDecl):
            rest.append(decl)
        # The user's functions may use the runtime's variables, and these the user's structs.
        if isinstance(decl, n.VarDecl) and decl.type.struct is not None:
            name = decl.type.struct.name
            rest += [one for one in variables if _is_of(one, name)]
            variables = [one for one in variables if not _is_of(one, name)]
    return replace(module, decls=(*precision, *variables, *rest, *functions))


def _is_of(decl: n.Decl, struct: str | None) -> bool:
    return isinstance(decl, n.VarDecl) and decl.type.name == struct


def without_main(module: n.Module) -> tuple[n.Decl, ...]:
    """The module's declarations except ``main``."""
    return tuple(
        d
        for d in module.decls
        if not isinstance(d, n.FunctionDef | n.FunctionProto) or d.name != "main"
    )


def with_locations(module: n.Module, locations: Mapping[str, int]) -> n.Module:
    """The module with ``layout(location = n)`` on the outputs that are named."""
    return replace(module, decls=tuple(_located(decl, locations) for decl in module.decls))


def _located(decl: n.Decl, locations: Mapping[str, int]) -> n.Decl:
    if not isinstance(decl, n.VarDecl) or not decl.qualifiers.has("out"):
        return decl
    names = [declarator.name for declarator in decl.declarators]
    if not names or names[0] not in locations:
        return decl
    # A pass has its targets at these places, whatever location the user's output had.
    others = tuple(i for i in decl.qualifiers.layout or () if i.name not in ("location", "index"))
    number = n.Literal(NOWHERE, str(locations[names[0]]))
    layout = (n.LayoutItem(NOWHERE, "location", number), *others)
    return replace(decl, qualifiers=replace(decl.qualifiers, layout=layout))


def interface(module: n.Module) -> Shader:
    """The module with the names of its inputs, outputs and uniforms (blocks, buffers and constants
    that are specialised too), in order of declaration."""
    inputs: list[str] = []
    outputs: list[str] = []
    uniforms: list[str] = []
    for decl in module.decls:
        if isinstance(decl, n.VarDecl):
            names = [declarator.name for declarator in decl.declarators]
        elif isinstance(decl, n.BlockDecl):
            names = [decl.name]
        else:
            continue
        if decl.qualifiers.has("in"):
            inputs += names
        elif decl.qualifiers.has("out"):
            outputs += names
        elif decl.qualifiers.has("uniform", "buffer") or has_word(decl.qualifiers, "constant_id"):
            uniforms += names
    return Shader(module, tuple(inputs), tuple(outputs), tuple(uniforms))
