"""Which values stand for all where there is no time to verify every one."""

from __future__ import annotations

from collections.abc import Hashable, Sequence

from shadercache.analysis.candidates import Candidate
from shadercache.analysis.costs.savings import Saving, Savings

MOST = 20
"""Values of a quick verification: those of 100 lines take less than 30 s on two cores."""

_TELLING = 10
"""Of these the ones that ``shadercache nodes`` shows."""


def quick_choice(savings: Savings, nodes: Sequence[Candidate], most: int = MOST) -> list[Candidate]:
    """At most so many of the nodes, in their order.

    One of each type and of each kind of place, the ones that tell the shader's values apart, and
    otherwise those that save most.
    """
    if len(nodes) <= most:
        return list(nodes)
    ranked = sorted(map(savings.of, nodes), key=lambda saving: -saving.share)
    telling = savings.telling(ranked, lambda node: node.inputs, _TELLING)
    wanted = [saving.node for saving in (*_one_of_each(ranked), *telling, *ranked)]
    chosen = frozenset(list(dict.fromkeys(wanted))[:most])
    return [node for node in nodes if node in chosen]


def _one_of_each(ranked: Sequence[Saving]) -> list[Saving]:
    """The first of each type and of each kind of place."""
    seen = set[Hashable]()
    firsts = []
    for saving in ranked:
        marks = {("type", saving.node.type.name), ("place", _place(saving.node))}
        if not marks <= seen:
            firsts.append(saving)
            seen |= marks
    return firsts


def _place(node: Candidate) -> tuple[bool, bool, bool]:
    """Is it in a function that is called, not in every fragment, in a loop that was taken apart?"""
    called = node.instance is not None and node.instance.parent is not None
    unrolled = node.place is not None and bool(node.place.trip)
    return called, node.unsure, unrolled
