"""The makers of two passes: hits are shaded and misses discarded; then misses are computed."""

from __future__ import annotations

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.emit.assemble import Shader
from shadercache.emit.builder import PassBuilder
from shadercache.transform.specialise import CutKind


def hit(builder: PassBuilder) -> Shader:
    """Shade hits. The discard comes last where the shading takes derivatives, where a loop writes
    into an array, and where the payload decides on a loop: there it is certain that fragments
    without a payload leave the loop, whatever a driver does behind a discard."""
    template = "here" if builder.whole else "hit"
    kind: CutKind = "need" if builder.whole else "use"
    early = builder.build(template, [builder.cut(kind)], builder.color_and_stores)
    if (
        not builder.takes_derivatives(early.module)
        and not _loops_over_arrays(early.module)
        and not builder.decides_loops
    ):
        return early
    late: CutKind = "lack" if builder.whole else "use"
    return builder.build(f"{template}_late", [builder.cut(late)], builder.color_and_stores)


def miss(builder: PassBuilder) -> Shader:
    """The original, keeping the payload."""
    kind: CutKind = "keep" if builder.whole else "store"
    return builder.build("miss", [builder.cut(kind)], builder.color_and_stores)


def _loops_over_arrays(module: n.Module) -> bool:
    """Does a loop use an element of something? Behind a discard llvmpipe writes it wrongly, and
    what is written by a function or in part is not told from what is read."""
    loops = (node for node in walk(module) if isinstance(node, n.For | n.While | n.DoWhile))
    return any(isinstance(node, n.Index) for loop in loops for node in walk(loop))
