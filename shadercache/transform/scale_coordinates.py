"""Say where a fragment would lie in the whole picture, in passes that draw a smaller one.

What the user computes of ``gl_FragCoord`` (a place in a texture, a ray) belongs to a picture of the
full size, and a texel of a smaller one lies among several of its pixels::

    vec2 uv = gl_FragCoord.xy / u_size;

    vec2 uv = vec4((gl_FragCoord.xy - sc_scale.zw) / sc_scale.xy, gl_FragCoord.zw).xy / u_size;
"""

from __future__ import annotations

from shadercache.ast import nodes as n
from shadercache.ast.rewriter import replace_expressions

COORDINATE = "gl_FragCoord"


def scale_coordinates(module: n.Module, whole: n.Expr) -> n.Module:
    """The module with ``whole`` in the place of every ``gl_FragCoord``."""

    def chosen(_: n.Expr, node: n.Expr) -> n.Expr:
        return whole if isinstance(node, n.Name) and node.name == COORDINATE else node

    return replace_expressions(module, chosen)
