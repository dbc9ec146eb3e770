"""The makers of two passes: hits are shaded and misses discarded; then misses are computed."""

from __future__ import annotations

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.emit.assemble import Shader
from shadercache.emit.builder import PassBuilder
from shadercache.transform.specialise import CutKind


def hit(builder: PassBuilder) -> Shader:
    """Shade hits; misses are discarded, where it matters at the end."""
    template = "here" if builder.whole else "hit"
    kind: CutKind = "need" if builder.whole else "use"
    early = builder.build(template, [builder.cut(kind)], builder.colors_and_stores)
    if not discards_late(builder, early):
        return early
    late: CutKind = "lack" if builder.whole else "use"
    return builder.build(f"{template}_late", [builder.cut(late)], builder.colors_and_stores)


def miss(builder: PassBuilder) -> Shader:
    """The original, keeping the payload."""
    kind: CutKind = "keep" if builder.whole else "store"
    return builder.build("miss", [builder.cut(kind)], builder.colors_and_stores)


def discards_late(builder: PassBuilder, early: Shader) -> bool:
    """Must a pass that shades what has its payload discard the rest at its very end?"""
    # Behind a discard derivatives are undefined (GLSL 4.60 section 8.14.1), and whether a loop that
    # waits for a payload ends is the driver's affair.
    return (
        builder.takes_derivatives(early.module)
        or _loops_over_arrays(early.module)
        or builder.decides_loops
    )


def _loops_over_arrays(module: n.Module) -> bool:
    """Does a loop use an element of something?"""
    # llvmpipe writes elements wrongly in a loop behind a discard. What a function writes, or a part
    # of, is not told from what is read.
    loops = (node for node in walk(module) if isinstance(node, n.For | n.While | n.DoWhile))
    return any(isinstance(node, n.Index) for loop in loops for node in walk(loop))
