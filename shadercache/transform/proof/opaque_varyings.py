"""Proof mode: keep the driver from knowing that a varying is the same at every vertex.

What a vertex shader takes from uniforms alone need not be interpolated: Mesa 25 lets the fragment
shader read the uniform where it can, and interpolates where it cannot. The two differ by rounding,
and it need not choose alike in two programs. So each such varying seems to depend on the vertex::

    void main() { v_tint = u_tint; ... }    =>    void sc_main() { v_tint = u_tint; ... }
                                                  void main() {
                                                      sc_main();
                                                      if (gl_VertexID < 0) { v_tint = -v_tint; }
                                                  }

No vertex has a number below 0.
"""

from __future__ import annotations

from dataclasses import replace

from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.lang.types import builtin_type
from shadercache.source import NOWHERE
from shadercache.transform.reachable import names_in
from shadercache.transform.remove_dead import remove_dead
from shadercache.transform.rename import rename
from shadercache.transform.trees import assigned, change_functions

# The last two are what Vulkan calls them.
_NUMBERS = frozenset(("gl_VertexID", "gl_InstanceID", "gl_VertexIndex", "gl_InstanceIndex"))


def hide_uniform_varyings(module: n.Module, prefix: str, memo: Memo) -> n.Module:
    """The vertex shader, in which no interpolated output is known to be uniform."""
    names = [name for name in _interpolated(module) if not _varies(module, name, memo)]
    if not names:
        return module
    # Called, not extended: a `return` in the user's main must not skip what follows.
    renamed = change_functions(module, lambda function: rename(function, {"main": f"{prefix}main"}))
    call = n.ExprStmt(NOWHERE, n.Call(NOWHERE, f"{prefix}main", ()))
    below = n.Binary(NOWHERE, "<", n.Name(NOWHERE, "gl_VertexID"), n.Literal(NOWHERE, "0"))
    negated = tuple(assigned(name, n.Unary(NOWHERE, "-", n.Name(NOWHERE, name))) for name in names)
    body = n.Block(NOWHERE, (call, n.If(NOWHERE, below, n.Block(NOWHERE, negated), None)))
    main = next(d for d in module.decls if isinstance(d, n.FunctionDef) and d.name == "main")
    return replace(renamed, decls=(*renamed.decls, replace(main, body=body)))


def _interpolated(module: n.Module) -> list[str]:
    """The outputs that are scalars, vectors or matrices of floats and not ``flat``."""
    names: list[str] = []
    for decl in module.decls:
        if isinstance(decl, n.VarDecl) and decl.qualifiers.has("out"):
            kind = builtin_type(decl.type.name)
            if kind and kind.base == "float" and not decl.qualifiers.has("flat"):
                # Arrays have no negation.
                names += [variable.name for variable in decl.declarators if not variable.dims]
    return names


def _varies(module: n.Module, name: str, memo: Memo) -> bool:
    """Does an output depend on anything that vertices differ in?"""
    needed = remove_dead(module, (name,), memo)
    return not _NUMBERS.isdisjoint(names_in(needed)) or any(
        isinstance(decl, n.VarDecl | n.BlockDecl) and decl.qualifiers.has("in")
        for decl in needed.decls
    )
