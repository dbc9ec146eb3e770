"""Which nodes are verified today: a slice that moves on every day until all have had their turn."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from datetime import date
from math import ceil

from shadercache.analysis.candidates import Candidate

VARIABLE = "SHADERCACHE_SEED"
"""Set it to the number that a failing run printed, and the same nodes are verified."""


def seed() -> int:
    """The day's ordinal, or what the environment says in its place."""
    return int(os.environ.get(VARIABLE) or date.today().toordinal())


def day_slice(nodes: Sequence[Candidate], day: int, size: int) -> list[Candidate]:
    """About ``size`` of the nodes; the slices of successive days cover all of them in turn.

    Nodes are taken at equal distances, so that a slice has something of each part of the shader.
    """
    slices = max(1, ceil(len(nodes) / size))
    return list(nodes[day % slices :: slices])


def nodes_of_day(
    legal: Sequence[Candidate], named: Mapping[str, str], day: int, size: int
) -> list[Candidate]:
    """The slice of the day and the nodes that the scene has a name for, each once."""
    wanted = {node.id for node in day_slice(legal, day, size)} | set(named.values())
    return [node for node in legal if node.id in wanted]
