"""What the payload pass and the shading pass of a node have in common.

Both are slices of one shader: the payload pass is what the values need, the shading pass what is
left to do where the values are given. Work that both need is done twice wherever a payload is
computed (Sitthi-amorn et al. 2008, figure 7)::

    vec3 n = normalize(v_normal);       // payload and shading: overlap
    float s = fbm(v_position + n);      // payload only, if s is the node
    color = vec4(s * dot(n, u_light));  // shading only

The slices are those that :mod:`transform.remove_dead` leaves: liveness, backward over structured
statements. Costs are static (:mod:`analysis.costs.cost`) and at most somewhat too high: a function
that is not on the path of a node, and a ``switch`` without one, count as a whole.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import partial

from shadercache.analysis.call_paths import Instance
from shadercache.analysis.candidates import Candidate
from shadercache.analysis.costs.cost import CostTable
from shadercache.analysis.costs.need_walker import (
    NOTHING_NEEDED,
    NOTHING_READ,
    Body,
    Cuts,
    Holders,
    NeedWalker,
    OneLevelWalker,
    body_of,
)
from shadercache.analysis.costs.path_costs import Cut, Demand, Names, Need, PathCosts
from shadercache.analysis.effect_table import EffectTable
from shadercache.ast import nodes as n


@dataclass(frozen=True, slots=True)
class Parts:
    """Static costs of the payload pass, of the shading pass, and of the shader that they make up,
    each without what it does not need."""

    payload: float
    remainder: float
    whole: float

    @property
    def overlap(self) -> float:
        """What both passes compute."""
        return max(0.0, self.payload + self.remainder - self.whole)


class SharedWorkTable:
    """Splits one shader at any of its nodes."""

    def __init__(
        self,
        instances: tuple[Instance, ...],
        table: EffectTable,
        costs: CostTable,
        outputs: Iterable[str],
    ) -> None:
        self._main, self._table, self._costs = instances[0], table, costs
        self._outputs = frozenset(outputs)
        self._bodies: dict[n.FunctionDef, Body] = {}
        self._mentions: dict[n.FunctionDef, Names] = {}
        self.whole = self._cost((), goal=False)
        all_, nothing = Demand(self._outputs, True), Demand(NOTHING_READ, False)
        self._payloads = PathCosts(nothing, partial(self._walk, True), self._mentioned)
        self._remainders = PathCosts(all_, partial(self._walk, False), self._mentioned)

    def parts(self, nodes: Sequence[Candidate]) -> Parts:
        """The costs of both passes where the values of ``nodes`` are cached together."""
        if len(nodes) == 1 and nodes[0].instance is not None:
            at = nodes[0].instance, nodes[0].expr
            payload, remainder = self._payloads.cost(*at), self._remainders.cost(*at)
            if payload is not None and remainder is not None:
                return Parts(payload, remainder, self.whole)
        return self.parts_of_set(nodes)

    def parts_of_set(self, nodes: Sequence[Candidate]) -> Parts:
        """The same, by walking the whole shader with all its cuts."""
        return Parts(self._cost(nodes, goal=True), self._cost(nodes, goal=False), self.whole)

    def _walk(
        self, goal: bool, instance: Instance, cut: Cut, context: Demand, given: Need | None
    ) -> Need:
        """One function, with one cut in it."""
        body = self._body(instance.places.function)
        place = cut.call if isinstance(cut, Instance) else cut
        assert place is not None
        cuts = Cuts(touched=Holders(body, body.first[place]))
        if isinstance(cut, Instance):
            cuts.below[place] = (cut, Cuts())
        else:
            cuts.here.add(place)
        about = self._table, self._costs, goal, cuts, context.at_exit, context.returns
        walker = OneLevelWalker(*about, place=place, body=body, given=given or NOTHING_NEEDED)
        live = walker.block(instance.places.function.body.body, context.at_exit)
        return Need(walker.cost, live, walker.asked, walker.again)

    def _mentioned(self, instance: Instance) -> Names:
        """Every name that a walk through a function may ask for."""
        function = instance.places.function
        if function not in self._mentions:
            effects = self._table.of(function.body)
            names = instance.places.reaching.local_names
            self._mentions[function] = names | effects.reads | effects.writes
        return self._mentions[function]

    def _cost(self, nodes: Iterable[Candidate], goal: bool) -> float:
        walker = NeedWalker(self._table, self._costs, goal)
        at_exit = NOTHING_READ if goal else self._outputs
        return walker.function(self._main, self._sorted(nodes), at_exit, not goal).cost

    def _sorted(self, nodes: Iterable[Candidate]) -> Cuts:
        root = Cuts()
        for node in nodes:
            path: list[Instance] = []
            at = node.instance
            while at is not None and at.parent is not None:
                path.append(at)
                at = at.parent
            cuts = root
            function = self._main.places.function
            for instance in reversed(path):
                assert instance.call is not None
                self._touch(function, instance.call, cuts)
                cuts = cuts.below.setdefault(instance.call, (instance, Cuts()))[1]
                function = instance.places.function
            self._touch(function, node.expr, cuts)
            cuts.here.add(node.expr)
        return root

    def _touch(self, function: n.FunctionDef, expr: n.Expr, cuts: Cuts) -> None:
        parents, touched = self._body(function).parents, cuts.touched
        assert isinstance(touched, set)
        at: n.Node | None = expr
        # Above what is touched everything is, so that many nodes of one tree take linear time.
        while at is not None and at not in touched:
            touched.add(at)
            at = parents.get(at)

    def _body(self, function: n.FunctionDef) -> Body:
        if function not in self._bodies:
            self._bodies[function] = body_of(function)
        return self._bodies[function]
