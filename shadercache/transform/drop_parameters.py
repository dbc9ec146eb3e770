"""Drop the parameters of cloned functions that their bodies no longer read.

An argument computed for nobody would keep the code behind it alive::

    vec3 sc_marble(vec3 p) { return tint(sc_payload); }    vec3 sc_marble() { ... }
    color = sc_marble(v_position * u_scale);          =>   color = sc_marble();

Only functions that this compiler made are touched (their names are not overloaded). Arguments with
side effects are moved ahead of the statement (:mod:`shadercache.transform.move_arguments`); where
that might change what they see or what sees them the parameter stays. An ``inout`` parameter that
is not used gives back what it got, which matters where the function writes to the same variable by
another name: a global one, or one that it was given twice. An ``out`` parameter stays.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from typing import TypeAlias, TypeVar

from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import root_variable
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.rewriter import replace_expressions
from shadercache.ast.walk import walk
from shadercache.transform.move_arguments import (
    ActingArgument,
    acting_arguments,
    move_arguments,
)
from shadercache.transform.reachable import declared_names, kept_names
from shadercache.transform.trees import change_declarations

_T = TypeVar("_T")

Dropped: TypeAlias = Mapping[str, set[int]]
"""Places of the parameters that go, by function."""


def drop_parameters(module: n.Module, functions: Collection[str], memo: Memo) -> n.Module:
    """The module without unread parameters of the given functions (the same one if none)."""
    table = EffectTable(module, memo)
    callers = [d for d in module.decls if not kept_names(d, memo).isdisjoint(functions)]
    acting = [argument for decl in callers for argument in acting_arguments(decl, functions, table)]
    bound = _bound(module, callers, acting, table)
    dropped: dict[str, set[int]] = {}
    # Callees are defined first: what was only handed down goes with what it was handed to.
    for name, function in table.functions.items():
        if name in functions:
            places = _unread(_without(function, dropped, memo), memo) - bound[name]
            if places:
                dropped[name] = places
    moved = [a for a in acting if a.place in dropped.get(a.call.name, ())]
    # The zeros that moved arguments leave have no type. They do nothing, so the next call drops the
    # same parameters, and the zeros with them.
    if moved:
        return drop_parameters(move_arguments(module, moved), functions, memo)
    return change_declarations(module, lambda decl: _without(decl, dropped, memo))


_D = TypeVar("_D", bound=n.Decl)


def _without(decl: _D, dropped: Dropped, memo: Memo) -> _D:
    """A declaration without the parameters that go, and without their arguments."""
    match decl:
        case n.FunctionProto(name=name) if name in dropped:
            return replace(decl, params=_keep(decl.params, dropped[name]))
        case n.FunctionDef():
            proto, body = _without(decl.proto, dropped, memo), decl.body
            if not dropped.keys().isdisjoint(kept_names(body, memo)):
                body = replace_expressions(body, lambda _, node: _without_arguments(node, dropped))
            if proto is not decl.proto or body is not decl.body:
                return replace(decl, proto=proto, body=body)
    return decl


def _without_arguments(expr: n.Expr, dropped: Dropped) -> n.Expr:
    if isinstance(expr, n.Call) and expr.name in dropped:
        return replace(expr, args=_keep(expr.args, dropped[expr.name]))
    return expr


def _keep(items: tuple[_T, ...], dropped: set[int]) -> tuple[_T, ...]:
    return tuple(entry for place, entry in enumerate(items) if place not in dropped)


def _unread(function: n.FunctionDef, memo: Memo) -> set[int]:
    used = kept_names(function.body, memo)
    return {
        place
        for place, param in enumerate(function.proto.params)
        if param.name not in used and (not param.writes_back or param.qualifiers.has("inout"))
    }


def _bound(
    module: n.Module,
    callers: Sequence[n.Decl],
    acting: Sequence[ActingArgument],
    table: EffectTable,
) -> dict[str, set[int]]:
    """For each function the places that must stay: of arguments that cannot be moved, and where it
    matters what is given back."""
    globals_ = (decl for decl in module.decls if isinstance(decl, n.VarDecl))
    shared = {name for decl in globals_ for name in declared_names(decl)}
    bound: dict[str, set[int]] = {name: set() for name in table.functions}
    for call, place, stmt in acting:
        if stmt is None or table.functions[call.name].proto.params[place].writes_back:
            bound[call.name].add(place)
    for node in (node for decl in callers for node in walk(decl)):
        if isinstance(node, n.Call) and node.name in bound:
            bound[node.name] |= _given_back(node, table.functions[node.name], shared)
    return bound


def _given_back(call: n.Call, function: n.FunctionDef, shared: Collection[str]) -> set[int]:
    """The places of a call whose variables the function may write to otherwise as well."""
    # On return arguments are copied back (GLSL 3.30 section 6.1.1), over whatever the function has
    # written to the same variable by its other name.
    params = function.proto.params
    roots = {
        place: root_variable(arg)
        for place, (param, arg) in enumerate(zip(params, call.args, strict=True))
        if param.writes_back
    }
    names = list(roots.values())
    return {at for at, name in roots.items() if name in shared or names.count(name) > 1}
