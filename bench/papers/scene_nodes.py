"""Which values of a scene's shader the papers' experiments cache."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from shadercache.analysis.value_numbering import one_of_each
from shadercache.ast.nodes import Expr
from shadercache.compiler import Analysis
from shadercache.scene.description import Scene


@dataclass(frozen=True, slots=True)
class NodeFacts:
    """A node and what is known of it without drawing.

    ``stands_for``: how many offered nodes, of its value or of its expression on another path.
    ``ratio`` is the static P/T; ``overlap`` the share of the shader that the payload pass and the
    shading pass both compute; ``inputs`` the names of what the value depends on.
    """

    id: str
    text: str
    path: str
    stands_for: int
    ratio: float
    overlap: float
    inputs: tuple[str, ...] = ()


def distinct_nodes(scene: Scene, analysis: Analysis) -> Sequence[NodeFacts]:
    """One node of each offered expression, in ascending static P/T.

    Of several paths to an expression that is taken which the scene has a name for, else the first.
    """
    values = one_of_each([node for node in analysis.nodes if node.offered], analysis.groups)
    named = set(scene.nodes.values())
    paths: dict[Expr, list[str]] = {}
    counts: dict[Expr, int] = {}
    for node, equal in values.items():
        paths.setdefault(node.expr, []).append(node.id)
        counts[node.expr] = counts.get(node.expr, 0) + equal
    facts = []
    for expr, ids in paths.items():
        node = analysis.node(next((one for one in ids if one in named), ids[0]))
        parts = analysis.shared_work.parts([node])
        overlap = parts.overlap / max(1e-9, parts.whole)
        inputs = tuple(sorted(node.inputs))
        facts.append(
            NodeFacts(node.id, node.text, node.path, counts[expr], node.ratio, overlap, inputs)
        )
    return sorted(facts, key=lambda fact: fact.ratio)
