"""Texture fetches with implicit level of detail, split in what has to be done where neighbouring
fragments do the same, and in what may be done under a branch.

Three forms (DESIGN section 4, "Derivatives")::

    whole       v = texture(map, p);                        v
    level       v = textureQueryLod(map, p).y;              textureLod(map, p, v)
    gradient    v_x = dFdx(p); v_y = dFdy(p);               textureGrad(map, p, v_x, v_y)

The level is the same to the bit where filtering is isotropic and the driver's query is exact;
gradients are not (docs/NUMERICS.md).
"""

from __future__ import annotations

from collections.abc import Mapping

from shadercache.ast import nodes as n
from shadercache.lang.types import Type
from shadercache.options import FetchForm
from shadercache.source import NOWHERE

_SPLIT = frozenset(
    f"{kind}sampler{shape}" for kind in ("", "i", "u") for shape in ("1D", "2D", "3D", "Cube")
)
_WITH_BIAS = 3


def form_of(fetch: n.Expr, wanted: FetchForm, types: Mapping[n.Expr, Type]) -> FetchForm:
    """The wanted form where the fetch can be split so, else ``whole``."""
    if not isinstance(fetch, n.Call) or fetch.name != "texture":
        return "whole"
    if types[fetch.args[0]].name not in _SPLIT:
        return "whole"
    # A bias has no place beside gradients.
    return "whole" if wanted == "gradient" and len(fetch.args) == _WITH_BIAS else wanted


def variables_of(
    fetch: n.Expr, form: FetchForm, name: str, types: Mapping[n.Expr, Type]
) -> dict[str, str]:
    """The variables that hold what was done ahead, with their types."""
    match form, fetch:
        case "level", _:
            return {name: "float"}
        case "gradient", n.Call(args=(_, at, *_)):
            return {f"{name}_x": str(types[at]), f"{name}_y": str(types[at])}
    return {name: str(types[fetch])}


def done_ahead(fetch: n.Expr, form: FetchForm, name: str) -> dict[str, n.Expr]:
    """What each of these variables gets."""
    match form, fetch:
        case "level", n.Call(args=(sampler, at, *bias)):
            query = n.Call(NOWHERE, "textureQueryLod", (sampler, at))
            level: n.Expr = n.Member(NOWHERE, query, "y")
            for more in bias:
                level = n.Binary(NOWHERE, "+", level, more)
            return {name: level}
        case "gradient", n.Call(args=(_, at)):
            return {f"{name}_{axis}": n.Call(NOWHERE, f"dFd{axis}", (at,)) for axis in "xy"}
    return {name: fetch}


def left_over(fetch: n.Expr, form: FetchForm, name: str) -> n.Expr:
    """What stands in the place of the fetch then."""
    match form, fetch:
        case "level", n.Call(span=span, args=(sampler, at, *_)):
            return n.Call(span, "textureLod", (sampler, at, n.Name(NOWHERE, name)))
        case "gradient", n.Call(span=span, args=(sampler, at)):
            steps = (n.Name(NOWHERE, f"{name}_{axis}") for axis in "xy")
            return n.Call(span, "textureGrad", (sampler, at, *steps))
    return n.Name(fetch.span, name)
