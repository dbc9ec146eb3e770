"""What the inputs of a value are: varyings, uniforms, textures, the place on the screen."""

from __future__ import annotations

from collections.abc import Iterable

from shadercache.ast import nodes as n
from shadercache.sema.facts import Facts

KINDS = ("varyings", "uniforms", "textures", "screen", "globals")
"""The kinds, as they are shown. ``screen`` is whatever the language itself gives a fragment."""


def input_kinds(module: n.Module, facts: Facts) -> dict[str, str]:
    """The kind of every global variable of a module that is declared in it, by name."""
    kinds: dict[str, str] = {}
    for decl in module.decls:
        if isinstance(decl, n.BlockDecl):
            kind = "varyings" if decl.qualifiers.has("in") else "uniforms"
            names = [member.name for field in decl.fields for member in field.declarators]
            kinds |= dict.fromkeys([decl.instance or "", *names], kind)
        elif isinstance(decl, n.VarDecl):
            for variable in decl.declarators:
                kinds[variable.name] = _kind(decl, facts.declared[variable].type.holds_opaque)
    return kinds


def _kind(decl: n.VarDecl, opaque: bool) -> str:
    if decl.qualifiers.has("in"):
        return "varyings"
    if decl.qualifiers.has("uniform"):
        return "textures" if opaque else "uniforms"
    return "globals"


def by_kind(names: Iterable[str], kinds: dict[str, str]) -> dict[str, list[str]]:
    """The names of a node's inputs, sorted, under each kind that it has any of."""
    sorted_: dict[str, list[str]] = {}
    for name in sorted(names):
        kind = "screen" if name.startswith(("gl_", "%")) else kinds.get(name, "globals")
        sorted_.setdefault(kind, []).append(name.removeprefix("%"))
    return {kind: sorted_[kind] for kind in KINDS if kind in sorted_}
