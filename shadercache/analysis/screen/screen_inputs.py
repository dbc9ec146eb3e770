"""What binds a value to the place on the screen beside the built-in inputs.

Each use of such a thing gets a *mark*: a name that begins with ``%`` and counts as one more input
of whatever is made of it. There are varyings that carry the position
(:mod:`shadercache.analysis.screen.screen_varyings`), varyings that are interpolated on the screen,
levels of detail, and interpolation at another place of the pixel.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from shadercache.analysis.screen.screen_varyings import (
    WHOLE,
    Components,
    ScreenVaryings,
    touches,
)
from shadercache.analysis.screen.symbolic import swizzled
from shadercache.analysis.stages import Key, Pairs
from shadercache.ast import nodes as n
from shadercache.ast.walk import children, walk
from shadercache.sema.facts import Facts

Marks = Mapping[n.Node, str]
"""An expression -> the mark of what it is."""

_FUNCTIONS = frozenset(
    (
        *("textureQueryLod", "textureQueryLOD"),
        *("interpolateAtOffset", "interpolateAtSample", "interpolateAtCentroid"),
        # What an earlier subpass left at the very pixel.
        "subpassLoad",
    )
)


def screen_marks(
    module: n.Module, facts: Facts, pairs: Pairs = (), varyings: ScreenVaryings | None = None
) -> Marks:
    """The marks of a fragment shader; ``pairs``: which of its inputs are which outputs.

    Without a vertex shader nothing is known of what varyings carry.
    """
    bound = dict[Key, Components]()
    # Where no uniform moves the position, what is interpolated on the screen is always the same.
    if varyings is None or varyings.moves:
        bound.update(_interpolated_on_screen(module))
    if varyings is not None:
        for ours, theirs in pairs:
            components = varyings.components.get(theirs.key)
            if components:
                # One that is interpolated on the screen is bound as a whole already, though of a
                # position only some components are.
                bound.setdefault(ours.used, components)
    own = {decl.name for decl in module.decls if isinstance(decl, n.FunctionDef)}
    marks: dict[n.Node, str] = {}
    for parent in walk(module):
        if isinstance(parent, n.Call) and parent.name in _FUNCTIONS and parent.name not in own:
            marks[parent] = f"%{parent.name}"
        for node in children(parent) if bound else ():
            key = _used(node)
            if key in bound and _is_bound(bound[key], node, parent, facts):
                marks[node] = f"%{key[1]}"
    return marks


def _interpolated_on_screen(module: n.Module) -> Iterator[tuple[Key, Components]]:
    """``noperspective`` varyings: the same point has another value from another place."""
    for decl in module.decls:
        if not isinstance(decl, n.VarDecl | n.BlockDecl) or not decl.qualifiers.has("in"):
            continue
        owner = decl.instance if isinstance(decl, n.BlockDecl) else None
        for part in decl.fields if isinstance(decl, n.BlockDecl) else (decl,):
            if decl.qualifiers.has("noperspective") or part.qualifiers.has("noperspective"):
                yield from (((owner, variable.name), WHOLE) for variable in part.declarators)


def _used(node: n.Node) -> Key:
    """The varying that an expression names."""
    if isinstance(node, n.Name):
        return None, node.name
    if isinstance(node, n.Member):
        # All blocks of an array go by the name of their instance.
        owner = node.object.object if isinstance(node.object, n.Index) else node.object
        if isinstance(owner, n.Name):
            return owner.name, node.name
    return None, ""


def _is_bound(bound: Components, node: n.Node, parent: n.Node, facts: Facts) -> bool:
    """Is what is used of it there among the components that are bound?"""
    if isinstance(parent, n.Member):
        return any(touches(bound, part) for part in swizzled(parent, facts) or (parent.name,))
    if isinstance(parent, n.Index) and parent.object is node:
        at = facts.constants.get(parent.index)
        return at is None or touches(bound, int(at))
    return True
