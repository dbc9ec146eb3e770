"""Give parameters names that have none: GLSL lets them, but Mesa does not.

::

    float f(float, vec2 p) { return p.x; }   =>   float f(float sc_unnamed_0, vec2 p) { ... }
"""

from __future__ import annotations

from dataclasses import replace

from shadercache.ast import nodes as n
from shadercache.transform.trees import change_functions


def name_parameters(module: n.Module, prefix: str) -> n.Module:
    """The module in which each parameter of a function with a body has a name.

    ``prefix`` begins no name of the module.
    """

    def named(function: n.FunctionDef) -> n.FunctionDef:
        params = tuple(
            replace(param, name=f"{prefix}unnamed_{at}") if param.name is None else param
            for at, param in enumerate(function.proto.params)
        )
        if params == function.proto.params:
            return function
        return replace(function, proto=replace(function.proto, params=params))

    return change_functions(module, named)
