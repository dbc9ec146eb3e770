"""What caching a value would save of a shader, by static costs.

Where a look-up hits, the shader costs what is left to shade and the look-up; so a value saves its
own cost, less what shading computes again, less the look-up::

    vec3 n = normalize(v_normal);       // needed by both: saves nothing
    float s = fbm(v_position + n);      // saved, for a look-up
    color = vec4(s * dot(n, u_light));
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from shadercache.analysis.candidates import Candidate, Candidates
from shadercache.analysis.costs.shared_work import SharedWorkTable
from shadercache.analysis.refusals import FIRST_TEXEL
from shadercache.analysis.value_numbering import ValueGroup

LOOK_UP = 520.0
"""What look-up, refresh test and store cost by the weights of :mod:`analysis.costs.cost`: the first
of two passes as it is emitted by default, less the shading that is left (523).

Measured on the dragon they took 22 ms where shading took 138 for 3,325 units, which makes 530
(docs/lab/reuse.md).
"""

SECOND_TEXEL = 220.0
"""What they cost more for a payload that needs a second texture (739 in all)."""

ALIKE = 0.75
"""Values that have more than this share of their work in common are alike."""


def look_up_cost(channels: int) -> float:
    """The static cost of finding and keeping a payload of so many channels."""
    return LOOK_UP + (SECOND_TEXEL if channels > FIRST_TEXEL else 0.0)


@dataclass(frozen=True, slots=True)
class Saving:
    """A node, how many have its value, and the shares of the shader that caching it would save (at
    most: wherever it is found) and that are computed twice where it is not."""

    node: Candidate
    equal: int
    share: float
    twice: float


class Savings:
    """What the nodes of one shader would save."""

    def __init__(
        self,
        candidates: Candidates,
        groups: Mapping[Candidate, ValueGroup],
        work: SharedWorkTable,
    ) -> None:
        self._candidates, self._groups, self._work = candidates, groups, work

    def of(self, node: Candidate) -> Saving:
        """What a node saves that may be cached."""
        parts = self._work.parts((node,))
        whole = parts.whole or 1.0
        saved = parts.whole - parts.remainder - look_up_cost(node.type.components_or_one)
        equal = sum(one.offered for one in self._groups[node].nodes)
        return Saving(node, equal, saved / whole, parts.overlap / whole)

    def ranked(self) -> list[Saving]:
        """One of each value that is offered, what saves most first."""
        firsts = (group.first for group in dict.fromkeys(self._groups.values()))
        found = [self.of(node) for node in firsts if node.offered]
        # Of equal ones the first as written: what calls stands before what it calls.
        return sorted(found, key=lambda saving: -saving.share)

    def telling(
        self, ranked: Iterable[Saving], changes: Callable[[Candidate], frozenset[str]], most: int
    ) -> list[Saving]:
        """The first that differ: of values that are alike, the one that saves most, and those that
        change with less than any of these."""
        chosen: list[Saving] = []
        for saving in ranked:
            node = saving.node
            if not any(
                self.are_alike(one.node, node) and not changes(node) < changes(one.node)
                for one in chosen
            ):
                chosen.append(saving)
            if len(chosen) == most:
                break
        return chosen

    def are_alike(self, one: Candidate, other: Candidate) -> bool:
        """Do two values have most of their work in common?"""
        return self._common(one, other) > ALIKE * max(one.cost, other.cost)

    def _common(self, one: Candidate, other: Candidate) -> float:
        """What both values need, roughly."""
        inner, outer = sorted((one, other), key=lambda node: node.cost)
        assert inner.instance is not None and inner.place is not None
        slices, needed = self._candidates.slices, self._atoms(outer)
        step = slices.step_bits[inner.instance][inner.place.step.index]
        if step & needed or (inner.instance is outer.instance and is_inside(inner, outer)):
            return inner.cost
        return slices.atom_costs.of(self._atoms(inner) & needed)

    def _atoms(self, node: Candidate) -> int:
        assert node.instance is not None and node.place is not None
        return self._candidates.slices.value(node.instance, node.place).atoms


def is_inside(inner: Candidate, outer: Candidate) -> bool:
    """Is the text of one expression a part of the other's, or all of it?"""
    (start, end), (first, last) = outer.expr.span, inner.expr.span
    return start <= first and last <= end
