"""Which nodes are verified: a slice that moves on with the seed until all have had their turn.

The seed is the same in every ``./dev test``; ``./dev nightly`` gives another one each day, and
larger slices.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from math import ceil

from shadercache.analysis.candidates import Candidate

VARIABLE = "SHADERCACHE_SEED"
"""Set it to the number that a failing run printed, and the same nodes are verified."""

NIGHTLY = "SHADERCACHE_NIGHTLY"
"""Set (to anything) where slices may be large."""


def seed() -> int:
    """What the environment says; ``conftest.py`` sees to it that it says something."""
    return int(os.environ[VARIABLE])


def amount(short: int, long: int) -> int:
    """How much of something is tried: in ``./dev test``, or at night."""
    return long if os.environ.get(NIGHTLY) else short


def day_slice(nodes: Sequence[Candidate], day: int, size: int) -> list[Candidate]:
    """About ``size`` of the nodes; the slices of successive days cover all of them in turn.

    Nodes are taken at equal distances, so that a slice has something of each part of the shader.
    """
    slices = max(1, ceil(len(nodes) / size))
    return list(nodes[day % slices :: slices])


def nodes_of_day(
    legal: Sequence[Candidate], named: Mapping[str, str], day: int, size: int
) -> list[Candidate]:
    """The slice of a seed and the nodes that the scene has a name for, each once."""
    wanted = {node.id for node in day_slice(legal, day, size)} | set(named.values())
    return [node for node in legal if node.id in wanted]
