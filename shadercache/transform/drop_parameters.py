"""Drop the parameters of cloned functions that their bodies no longer read.

An argument computed for nobody would keep the code behind it alive::

    vec3 sc_marble(vec3 p) { return tint(sc_payload); }    vec3 sc_marble() { ... }
    color = sc_marble(v_position * u_scale);          =>   color = sc_marble();

Only functions that this compiler made are touched (their names are not overloaded), and only
``in`` parameters whose arguments have no side effects.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from typing import TypeVar

from shadercache.analysis.effects import EffectTable
from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.transform.reachable import names_in
from shadercache.transform.replace import replace_expressions

_T = TypeVar("_T")


def drop_parameters(module: n.Module, functions: Collection[str]) -> n.Module:
    """The module without unread parameters of the given functions (the same one if none)."""
    unread = {
        decl.name: _unread(decl)
        for decl in module.decls
        if isinstance(decl, n.FunctionDef) and decl.name in functions
    }
    impure = _impure_arguments(module, {name for name, places in unread.items() if places})
    dropped = {name: places - impure.get(name, set()) for name, places in unread.items()}
    dropped = {name: places for name, places in dropped.items() if places}
    if not dropped:
        return module

    def without(original: n.Expr, rebuilt: n.Expr) -> n.Expr:
        if isinstance(rebuilt, n.Call) and rebuilt.name in dropped:
            return replace(rebuilt, args=_keep(rebuilt.args, dropped[rebuilt.name]))
        return rebuilt

    decls: list[n.Decl] = []
    for decl in module.decls:
        if isinstance(decl, n.FunctionDef):
            decl = replace(decl, body=replace_expressions(decl.body, without))
            if decl.name in dropped:
                decl = replace(decl, proto=_without_params(decl.proto, dropped[decl.name]))
        elif isinstance(decl, n.FunctionProto) and decl.name in dropped:
            decl = _without_params(decl, dropped[decl.name])
        decls.append(decl)
    return replace(module, decls=tuple(decls))


def _unread(function: n.FunctionDef) -> set[int]:
    used = names_in(function.body)
    return {
        place
        for place, param in enumerate(function.proto.params)
        if param.name not in used and not param.writes_back
    }


def _impure_arguments(module: n.Module, functions: set[str]) -> dict[str, set[int]]:
    """For each function the argument places that have a side effect in some call."""
    table = EffectTable(module)
    found: dict[str, set[int]] = {}
    for item in walk(module):
        if isinstance(item, n.Call) and item.name in functions:
            places = {i for i, arg in enumerate(item.args) if table.of(arg).writes}
            found.setdefault(item.name, set()).update(places)
    return found


def _keep(items: tuple[_T, ...], dropped: set[int]) -> tuple[_T, ...]:
    return tuple(item for place, item in enumerate(items) if place not in dropped)


def _without_params(proto: n.FunctionProto, dropped: set[int]) -> n.FunctionProto:
    return replace(proto, params=_keep(proto.params, dropped))
