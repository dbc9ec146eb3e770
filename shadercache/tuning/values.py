"""Which values are tried: what cannot win is left out before anything is drawn."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cache, partial
from itertools import chain, zip_longest
from typing import TypeAlias

import numpy as np

from shadercache.analysed import Analysis, carrying, of_vertex_stage
from shadercache.analysis.candidates import Candidate, varyings
from shadercache.analysis.costs.savings import Saving
from shadercache.diagnostics import DiagnosticError
from shadercache.scene.camera import uniform_values
from shadercache.scene.description import Scene, SceneObject
from shadercache.tuning.groups import ShaderGroup

Changes: TypeAlias = Callable[[Candidate], frozenset[str]]

LEAST = 2
"""Values that are tried even where a look-up costs more than they save by static costs, which only
estimate what a driver makes of them."""

MOST = 24
"""Values that are tried at most."""

SET_OF = 4
"""Sets are made of so many of the values that save most."""

_FRAMES = range(0, 8)
"""Frames that show which inputs change."""


@dataclass(frozen=True, slots=True)
class Value:
    """A node, or several that are cached together, and the share of the shader that it saves at
    most, by static costs. ``changes`` with these inputs of the scene."""

    nodes: tuple[Candidate, ...]
    share: float
    changes: frozenset[str]

    @property
    def ids(self) -> tuple[str, ...]:
        """What names it."""
        return tuple(node.id for node in self.nodes)

    @property
    def text(self) -> str:
        """Its expressions."""
        return " + ".join(node.text for node in self.nodes)


@dataclass(frozen=True, slots=True)
class Pool:
    """The values of a shader that are tried, what saves most first.

    ``alike``: for each of them others that share most of its work and change with no less.
    ``left_out``: how many nodes were not tried, by why.
    """

    values: tuple[Value, ...]
    alike: dict[Value, tuple[Value, ...]]
    left_out: dict[str, int] = field(default_factory=dict)


def pool_of(group: ShaderGroup, scene: Scene) -> Pool:
    """The values of a group's shader."""
    analysis = group.analysis
    changes = _changes(analysis, changing_inputs(group, scene))
    counters = frozenset(_counters(group, scene))
    ranked = analysis.savings.ranked()
    steady = [one for one in ranked if not changes(one.node) & counters]
    worth = [one for one in steady if one.share > 0.0] or steady[:LEAST]
    telling = analysis.savings.telling(worth, changes, MOST)
    values = [_value(one, changes) for one in telling]
    others = [_value(one, changes) for one in worth if one not in telling]
    alike = {
        value: tuple(
            one for one in others if analysis.savings.are_alike(value.nodes[0], one.nodes[0])
        )
        for value in values
    }
    offered = sum(node.offered for node in analysis.nodes)
    left_out = {
        "may not be cached": len(analysis.nodes) - offered,
        "have the value of another": offered - len(ranked),
        "are another in every frame": len(ranked) - len(steady),
        "save less than a look-up costs": len(steady) - len(worth),
        "are like another that saves more": len(worth) - len(telling),
    }
    known = {reason: count for reason, count in left_out.items() if count}
    return Pool(_in_turns(values), alike, known)


def _in_turns(values: Sequence[Value]) -> tuple[Value, ...]:
    """Values that change with other inputs have other errors: the best of each kind comes first,
    what changes with least in front."""
    kinds: dict[frozenset[str], list[Value]] = {}
    for value in values:
        kinds.setdefault(value.changes, []).append(value)
    ordered = sorted(kinds.values(), key=lambda kind: len(kind[0].changes))
    rows = chain.from_iterable(zip_longest(*ordered))
    return tuple(value for value in rows if value is not None)


def _value(saving: Saving, changes: Changes) -> Value:
    return Value((saving.node,), saving.share, changes(saving.node))


def sets_of(pool: Pool, analysis: Analysis) -> Iterator[Value]:
    """Values that may be cached together: each with what spares most double work, then pairs."""
    seen = {frozenset(value.ids) for value in pool.values}
    top = pool.values[:SET_OF]
    pairs = ((*one.nodes, *other.nodes) for one in top for other in top if one is not other)
    for nodes in (*(carrying(analysis, value.nodes) for value in top), *pairs):
        ids = frozenset(node.id for node in nodes)
        if ids in seen or len(nodes) < 2 or not _go_together(analysis, nodes):
            continue
        seen.add(ids)
        members = [value for value in pool.values if set(value.ids) & ids]
        changes = frozenset[str]().union(*(value.changes for value in members))
        parts = analysis.shared_work.parts(nodes)
        share = (parts.whole - parts.remainder) / (parts.whole or 1.0)
        yield Value(tuple(nodes), share, changes)


def changing_inputs(group: ShaderGroup, scene: Scene) -> frozenset[str]:
    """The uniforms of a group's shader that really change under the scene's animation."""
    names: set[str] = set()
    for part in _parts(group, scene):
        every = [uniform_values(scene.view, part, frame, (64, 64)) for frame in _FRAMES]
        names |= {
            name
            for name, first in every[0].items()
            if not all(np.array_equal(values[name], first) for values in every[1:])
        }
        # An object that comes later has moved by then, whatever its first frames say.
        if part.motion.jumps:
            names |= {name for name, cause in group.changes.items() if cause == "view"}
    return frozenset(name.partition("[")[0].partition(".")[0] for name in names) | names


def _parts(group: ShaderGroup, scene: Scene) -> list[SceneObject]:
    return [part for part in scene.parts if part.name in group.objects]


def _counters(group: ShaderGroup, scene: Scene) -> Iterator[str]:
    """Inputs that are another thing in every frame: its number, and textures that are played."""
    for part in _parts(group, scene):
        inputs = part.inputs
        yield from (name for name, word in inputs.semantics.items() if word == "frame")
        yield from (name for name, it in inputs.played.items() if it.moves and it.rate >= 1.0)


def _changes(analysis: Analysis, moving: frozenset[str]) -> Changes:
    passed = varyings(analysis.program.module)
    through = cache(partial(of_vertex_stage, analysis))
    return lambda node: (node.inputs | through(node.inputs & passed)) & moving


def _go_together(analysis: Analysis, nodes: Sequence[Candidate]) -> bool:
    try:
        analysis.require_all(nodes)
    except DiagnosticError:
        return False
    return True
