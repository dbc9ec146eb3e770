"""Run functions without letting them change the shader's global variables.

The payload's code in a one-pass variant runs before the shader proper, which must find every
global as it was::

    float g = 1.0;                             void sc_compute() {
    void sc_compute_only() {                       float sc_kept_1 = g;
        g *= 2.0; sc_payload = ...;      =>        sc_compute_only();
    }                                              g = sc_kept_1;
                                               }
"""

from __future__ import annotations

from collections.abc import Iterable

from shadercache.ast import nodes as n
from shadercache.emit.assemble import call_all
from shadercache.sema.facts import Symbol
from shadercache.source import NOWHERE


def call_keeping(
    name: str, callees: Iterable[str], kept: Iterable[Symbol], prefix: str
) -> n.FunctionDef:
    """A function that calls others and then gives the ``kept`` variables their old values."""
    function = call_all(name, callees)
    before: list[n.Stmt] = []
    after: list[n.Stmt] = []
    for number, symbol in enumerate(kept, start=1):
        local = f"{prefix}kept_{number}"
        before.append(_copy(local, symbol))
        value = n.Assign(NOWHERE, "=", n.Name(NOWHERE, symbol.name), n.Name(NOWHERE, local))
        after.append(n.ExprStmt(NOWHERE, value))
    body = n.Block(NOWHERE, (*before, *function.body.body, *after))
    return n.FunctionDef(NOWHERE, function.proto, body)


def _copy(local: str, symbol: Symbol) -> n.DeclStmt:
    dims = tuple(n.Literal(NOWHERE, str(size)) for size in symbol.type.dims)
    item = n.Declarator(NOWHERE, local, dims, n.Name(NOWHERE, symbol.name))
    kind = n.TypeSpec(NOWHERE, symbol.type.name)
    return n.DeclStmt(NOWHERE, n.VarDecl(NOWHERE, n.NO_QUALIFIERS, kind, (item,)))
