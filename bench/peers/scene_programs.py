"""The programs that peers are made of: the originals, and those that know where vertices were."""

from __future__ import annotations

from dataclasses import dataclass

from shadercache.analysis.candidates import Candidate
from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.caching.configuration import Assignment, Configuration
from shadercache.compiler import Analysis
from shadercache.diagnostics import input_error
from shadercache.linking.linker import Linker
from shadercache.render.bundle import Bundle


@dataclass(frozen=True, eq=False)
class ScenePrograms:
    """Of each object, in the scene's order: its original, and the variants that cache its colour.

    The latter's vertex programs have the clip positions of this frame and of the last one, which
    peers look up by.
    """

    originals: tuple[Bundle, ...]
    moving: tuple[Bundle, ...]

    @classmethod
    def of(cls, linker: Linker) -> ScenePrograms:
        """Those of a scene.

        Raises as ``color_node`` and ``Linker.link``, and :class:`InputError` SC407 for an object
        whose points are not followed over its surface.
        """
        for part in linker.scene.parts:
            analysis = linker.analysis_of(part)
            if analysis.mapping != "surface":
                message = f"{part.name} is not reprojected: its mapping is {analysis.mapping}"
                raise input_error("SC407", message, 'in the scene, add: mapping = "surface"')
        assignment = color_assignment(linker, Configuration(), uncached=True)
        moving = tuple(linked.bundle for linked in linker.link(assignment))
        return cls(linker.originals(), moving)


def color_node(analysis: Analysis) -> Candidate:
    """The node of the colour that the shader writes last, without an alpha that is a constant.

    Raises:
        InputError: SC407, there is no such node, or it may not be cached.
    """
    # Not only what is offered: whether caching the colour pays is what is measured.
    by_expression = {node.expr: node for node in analysis.nodes if node.legal}
    written = (
        part.value
        for part in walk(analysis.program.module)
        if isinstance(part, n.Assign)
        and isinstance(part.target, n.Name)
        and part.target.name == analysis.program.colors[0]
    )
    found = [node for value in written for node in _values(value, by_expression)]
    if not found:
        name = analysis.fragment.name
        raise input_error("SC407", f"the colour that {name} writes is no value that can be cached")
    return found[-1]


def _values(value: n.Expr, legal: dict[n.Expr, Candidate]) -> list[Candidate]:
    whole = [legal[value]] if value in legal else []
    if isinstance(value, n.Construct) and len(value.args) == 2:
        color, alpha = value.args
        if color in legal and isinstance(alpha, n.Literal):
            # Three channels and the depth fit one texture; a constant needs no channel.
            return [*whole, legal[color]]
    return whole


def color_assignment(
    linker: Linker, configuration: Configuration, uncached: bool = False
) -> Assignment:
    """Every object's colour cached, of those that the scene wants cached (``uncached``: of all)."""
    return Assignment(
        tuple(
            (part.name, _with_color(linker.analysis_of(part), configuration))
            if part.caching.on or uncached
            else (part.name, None)
            for part in linker.scene.parts
        )
    )


def _with_color(analysis: Analysis, configuration: Configuration) -> Configuration:
    fields = configuration.to_json() | {"nodes": [color_node(analysis).id]}
    return Configuration.from_json(fields)
