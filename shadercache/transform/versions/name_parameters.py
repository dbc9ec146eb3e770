"""Give parameters names that have none: GLSL lets them, but Mesa does not.

::

    float f(float, vec2 p) { return p.x; }   =>   float f(float sc_unnamed_0, vec2 p) { ... }
"""

from __future__ import annotations

from dataclasses import replace

from shadercache.ast import nodes as n


def name_parameters(module: n.Module, prefix: str) -> n.Module:
    """The module in which each parameter of a function with a body has a name.

    ``prefix`` begins no name of the module.
    """
    decls = tuple(
        _named(decl, prefix) if isinstance(decl, n.FunctionDef) else decl for decl in module.decls
    )
    if all(one is other for one, other in zip(decls, module.decls, strict=True)):
        return module
    return replace(module, decls=decls)


def _named(function: n.FunctionDef, prefix: str) -> n.FunctionDef:
    if all(param.name is not None for param in function.proto.params):
        return function
    params = tuple(
        replace(param, name=f"{prefix}unnamed_{at}") if param.name is None else param
        for at, param in enumerate(function.proto.params)
    )
    return replace(function, proto=replace(function.proto, params=params))
