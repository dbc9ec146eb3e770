"""What a node costs or leaves, found out once for all the paths on which it is the same.

A function is walked backward with one cut in it, a node or the call that leads to one
(:mod:`analysis.costs.shared_work`). What comes of that depends on the function, the cut, what is
live where the function ends, and for a call on what is needed inside: never on the path that leads
there. So sixty thousand nodes on hundreds of paths take some thousand walks.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable
from dataclasses import dataclass, replace
from typing import TypeAlias

from shadercache.analysis.call_paths import Instance
from shadercache.ast import nodes as n

Names: TypeAlias = frozenset[str]


@dataclass(frozen=True, slots=True)
class Demand:
    """What is live where a function ends, and whether what it returns is wanted."""

    at_exit: Names
    returns: bool


@dataclass(frozen=True, slots=True)
class Need:
    """What a piece of a program needs: its cost, and the variables that it reads.

    ``asked`` is the context of the cut call; ``None`` where nobody asked for it. It may be asked
    for ``again``: then what is given counts twice, and is no matter of one context.
    """

    cost: float
    reads: Names
    asked: Demand | None = None
    again: bool = False


Cut: TypeAlias = "n.Expr | Instance"
"""A node, or the instance that a cut call leads to."""

Walk: TypeAlias = Callable[[Instance, Cut, Demand, "Need | None"], Need]
"""Walks a function with one cut; a cut call needs what is given."""

_PROBE = Need(0.0, frozenset())


class PathCosts:
    """Costs of the whole shader, cut at one node at a time."""

    def __init__(self, top: Demand, walk: Walk, mentioned: Callable[[Instance], Names]) -> None:
        self._top, self._walk, self._mentioned = top, walk, mentioned
        self._apart: dict[Instance, bool] = {}
        self._contexts: dict[Instance, Demand | None] = {}
        self._walked: dict[Hashable, Need] = {}
        self._above: dict[Hashable, float] = {}

    def cost(self, instance: Instance, expr: n.Expr) -> float | None:
        """What the shader costs where it is cut at a node; ``None`` where that cannot be put
        together from walks of single functions."""
        if self._is_apart(instance):
            return None
        return self._whole(instance, self._within(instance, expr, None))

    def _is_apart(self, instance: Instance) -> bool:
        """Is one of the calls on the path asked for more than once?"""
        if instance.parent is None:
            return False
        if instance not in self._apart:
            apart = self._is_apart(instance.parent)
            if not apart:
                probe = self._within(instance.parent, instance, _PROBE)
                apart = probe is not None and probe.again
            self._apart[instance] = apart
        return self._apart[instance]

    def _whole(self, instance: Instance, inside: Need | None) -> float:
        """What the shader costs where an instance needs what is ``inside``."""
        cost = 0.0 if inside is None else inside.cost
        if instance.parent is None:
            return cost
        # The rest of the path depends on what is read inside; the cost is only added to its own.
        key = (instance, inside and (inside.reads, cost > 0.0))
        above = self._above.get(key)
        if above is None:
            outer = self._within(instance.parent, instance, inside)
            above = self._above[key] = self._whole(instance.parent, outer) - cost
        return above + cost

    def _context(self, instance: Instance) -> Demand | None:
        """The context of an instance; ``None`` where its call is not evaluated."""
        if instance.parent is None:
            return self._top
        if instance not in self._contexts:
            # What a call is asked for is settled behind it, whatever is given inside.
            outer = self._within(instance.parent, instance, _PROBE)
            self._contexts[instance] = None if outer is None else outer.asked
        return self._contexts[instance]

    def _within(self, instance: Instance, cut: Cut, given: Need | None) -> Need | None:
        context = self._context(instance)
        if context is None:
            return None
        # What the function does not mention stays live all through it.
        names = self._mentioned(instance)
        past = context.at_exit - names
        near = Demand(context.at_exit & names, context.returns)
        need = self._near(instance, cut, near, given)
        asked = need.asked and Demand(need.asked.at_exit | past, need.asked.returns)
        cost = need.cost + (0.0 if given is None or asked is None else given.cost)
        return Need(cost, need.reads | past, asked, need.again)

    def _near(self, instance: Instance, cut: Cut, context: Demand, given: Need | None) -> Need:
        """The walk of a function, with the cost of what is given taken off."""
        place = cut.call if isinstance(cut, Instance) else cut
        function = instance.places.function
        given_key = given and (given.reads, given.cost > 0.0)
        key = (function, place, context.at_exit, context.returns, given_key)
        if key not in self._walked:
            whole = self._walk(instance, cut, context, given)
            off = 0.0 if given is None or whole.asked is None else given.cost
            self._walked[key] = replace(whole, cost=whole.cost - off)
        return self._walked[key]
