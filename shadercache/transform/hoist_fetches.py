"""Texture fetches with implicit level of detail, split in what has to be done where neighbouring
fragments do the same, and in what may be done under a branch.

Two forms, so that derivatives stay defined (law 8 of CONTRIBUTING.md)::

    whole       v = texture(map, p);                        v
    level       v = textureQueryLod(map, p).y;              textureLod(map, p, v)

The level is the same to the bit where filtering is isotropic and the driver's query is exact
(docs/lab/rewriting.md).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, TypeAlias

from shadercache.ast import nodes as n
from shadercache.lang.types import FLOAT, Type
from shadercache.source import NOWHERE

FetchForm: TypeAlias = Literal["whole", "level"]
"""What one pass does ahead of its branch of a payload's texture fetch with implicit level of
detail: all of it, or its level of detail."""

# Of arrays the query takes other coordinates than the fetch (no layer), rectangles have one level,
# and not every shadow has a `textureLod`.
_SPLIT = frozenset(
    f"{kind}sampler{shape}" for kind in ("", "i", "u") for shape in ("1D", "2D", "3D", "Cube")
)


def form_of(fetch: n.Expr, wanted: FetchForm, types: Mapping[n.Expr, Type]) -> FetchForm:
    """The wanted form where the fetch can be split so, else ``whole``."""
    if not isinstance(fetch, n.Call) or fetch.name != "texture":
        return "whole"
    return wanted if types[fetch.args[0]].name in _SPLIT else "whole"


def type_ahead(fetch: n.Expr, form: FetchForm, types: Mapping[n.Expr, Type]) -> Type:
    """The type of the variable that holds what was done ahead."""
    return FLOAT if form == "level" else types[fetch]


def hoisted_part(fetch: n.Expr, form: FetchForm) -> n.Expr:
    """What this variable gets."""
    match form, fetch:
        case "level", n.Call(args=(sampler, at, *bias)):
            # x is the level that would be read, clamped already; y is what `textureLod` takes. A
            # bias is not in it.
            query = n.Call(NOWHERE, "textureQueryLod", (sampler, at))
            level: n.Expr = n.Member(NOWHERE, query, "y")
            for more in bias:
                level = n.Binary(NOWHERE, "+", level, more)
            return level
    return fetch


def remaining_part(fetch: n.Expr, form: FetchForm, name: str) -> n.Expr:
    """What stands in the place of the fetch then."""
    match form, fetch:
        case "level", n.Call(span=span, args=(sampler, at, *_)):
            return n.Call(span, "textureLod", (sampler, at, n.Name(NOWHERE, name)))
    return n.Name(fetch.span, name)
