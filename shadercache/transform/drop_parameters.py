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

from collections.abc import Collection, Mapping
from dataclasses import replace
from typing import TypeAlias, TypeVar

from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import root_variable
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.walk import walk
from shadercache.transform.move_arguments import fixed_places, move_arguments
from shadercache.transform.reachable import kept_names
from shadercache.transform.replace import replace_expressions

_T = TypeVar("_T")

Dropped: TypeAlias = Mapping[str, set[int]]
"""Places of the parameters that go, by function."""


def drop_parameters(
    module: n.Module, functions: Collection[str], memo: Memo | None = None
) -> n.Module:
    """The module without unread parameters of the given functions (the same one if none).

    Functions are taken in order of definition, callees first, so that a parameter which was only
    handed down goes together with the one it was handed to.
    """
    memo = Memo() if memo is None else memo
    table = EffectTable(module, memo)
    impure, bound = _impure_arguments(module, functions, table, memo)
    fixed = fixed_places(module, impure, table)
    dropped: dict[str, set[int]] = {}
    decls: list[tuple[n.Decl, int]] = []
    for decl in module.decls:
        known = len(dropped)
        if isinstance(decl, n.FunctionDef):
            decl = _without_arguments(decl, dropped, memo)
            places = _unread(decl, memo) - bound.get(decl.name, set())
            places -= fixed.get(decl.name, set())
            if places and decl.name in functions:
                dropped[decl.name] = places
                decl = replace(decl, proto=_without_params(decl.proto, places))
        decls.append((decl, known))
    if not dropped:
        return module
    moved = {name: impure[name] & places for name, places in dropped.items() if name in impure}
    if any(moved.values()):
        return drop_parameters(move_arguments(module, moved, table), functions, memo)
    finished = (_finished(decl, dropped, known, memo) for decl, known in decls)
    return replace(module, decls=tuple(finished))


def _finished(decl: n.Decl, dropped: Dropped, known: int, memo: Memo) -> n.Decl:
    """Prototypes, and calls before the definition: only the first ``known`` are done yet."""
    if isinstance(decl, n.FunctionProto) and decl.name in dropped:
        return _without_params(decl, dropped[decl.name])
    if isinstance(decl, n.FunctionDef):
        return _without_arguments(decl, dict(list(dropped.items())[known:]), memo)
    return decl


def _without_arguments(function: n.FunctionDef, dropped: Dropped, memo: Memo) -> n.FunctionDef:
    if dropped.keys().isdisjoint(kept_names(function.body, memo)):
        return function

    def without(original: n.Expr, rebuilt: n.Expr) -> n.Expr:
        if isinstance(rebuilt, n.Call) and rebuilt.name in dropped:
            return replace(rebuilt, args=_keep(rebuilt.args, dropped[rebuilt.name]))
        return rebuilt

    return replace(function, body=replace_expressions(function.body, without))


def _unread(function: n.FunctionDef, memo: Memo) -> set[int]:
    used = kept_names(function.body, memo)
    return {
        place
        for place, param in enumerate(function.proto.params)
        if param.name not in used and (not param.writes_back or param.qualifiers.has("inout"))
    }


def _impure_arguments(
    module: n.Module, functions: Collection[str], table: EffectTable, memo: Memo
) -> tuple[dict[str, set[int]], dict[str, set[int]]]:
    """For each function the argument places that have a side effect in some call, and those that
    must stay: what is given back there matters."""
    shared = {
        item.name
        for decl in module.decls
        if isinstance(decl, n.VarDecl)
        for item in decl.declarators
    }
    impure: dict[str, set[int]] = {}
    bound: dict[str, set[int]] = {}
    callers = (decl for decl in module.decls if not kept_names(decl, memo).isdisjoint(functions))
    for item in (item for decl in callers for item in walk(decl)):
        if isinstance(item, n.Call) and item.name in functions:
            params = table.functions[item.name].proto.params
            acting = {i for i, arg in enumerate(item.args) if table.of(arg).writes}
            back = {i for i in acting if params[i].writes_back}
            impure.setdefault(item.name, set()).update(acting - back)
            back |= _given_back(item, table.functions[item.name], shared)
            bound.setdefault(item.name, set()).update(back)
    return impure, bound


def _given_back(call: n.Call, function: n.FunctionDef, shared: Collection[str]) -> set[int]:
    """The places of a call whose variables the function may write to otherwise as well."""
    params = function.proto.params
    roots = {
        place: root_variable(arg)
        for place, (param, arg) in enumerate(zip(params, call.args, strict=True))
        if param.writes_back
    }
    names = list(roots.values())
    return {at for at, name in roots.items() if name in shared or names.count(name) > 1}


def _keep(items: tuple[_T, ...], dropped: set[int]) -> tuple[_T, ...]:
    return tuple(item for place, item in enumerate(items) if place not in dropped)


def _without_params(proto: n.FunctionProto, dropped: set[int]) -> n.FunctionProto:
    return replace(proto, params=_keep(proto.params, dropped))
