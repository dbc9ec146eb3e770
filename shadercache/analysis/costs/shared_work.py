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
from dataclasses import dataclass, field
from functools import partial
from typing import cast

from shadercache.analysis.call_paths import Instance
from shadercache.analysis.candidates import Candidate
from shadercache.analysis.costs.cost import UNKNOWN_TRIPS, CostTable
from shadercache.analysis.costs.path_costs import Cut, Demand, Names, Need, PathCosts
from shadercache.analysis.dataflow import LOOPS, NAMES, Backward, Loop, before_cases, before_loop
from shadercache.analysis.effect_table import EffectTable, overwritten_by
from shadercache.analysis.effects import Does
from shadercache.ast import nodes as n
from shadercache.ast.walk import EXPRESSIONS, children, walk

_NONE: Names = frozenset()
_NOTHING = Need(0.0, _NONE)


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


@dataclass(slots=True)
class _Cuts:
    """The nodes in one function, and those below its calls."""

    here: set[n.Node] = field(default_factory=set)
    below: dict[n.Node, tuple[Instance, _Cuts]] = field(default_factory=dict)
    touched: set[n.Node] = field(default_factory=set)
    """Everything in the function's tree that holds one of these."""


class SharedWorkTable:
    """Splits one shader at any of its nodes."""

    def __init__(
        self, instances: tuple[Instance, ...], table: EffectTable, costs: CostTable, color: str
    ) -> None:
        self._main, self._table, self._costs = instances[0], table, costs
        self._outputs = frozenset((color,))
        self._parents: dict[n.FunctionDef, dict[n.Node, n.Node]] = {}
        self._mentions: dict[n.FunctionDef, Names] = {}
        self.whole = self._cost((), goal=False)
        all_, nothing = Demand(self._outputs, True), Demand(_NONE, False)
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
        function, cuts = instance.places.function, _Cuts()
        place = cut.call if isinstance(cut, Instance) else cut
        assert place is not None
        self._touch(function, place, cuts)
        if isinstance(cut, Instance):
            cuts.below[place] = (cut, _Cuts())
        else:
            cuts.here.add(place)
        walker = _OneLevelWalker(
            self._table, self._costs, goal, cuts, context.at_exit, context.returns
        )
        walker.given = given or walker.given
        live = walker.block(function.body.body, context.at_exit)
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
        walker = _NeedWalker(self._table, self._costs, goal)
        at_exit = _NONE if goal else self._outputs
        return walker.function(self._main, self._sorted(nodes), at_exit, not goal).cost

    def _sorted(self, nodes: Iterable[Candidate]) -> _Cuts:
        root = _Cuts()
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
                cuts = cuts.below.setdefault(instance.call, (instance, _Cuts()))[1]
                function = instance.places.function
            self._touch(function, node.expr, cuts)
            cuts.here.add(node.expr)
        return root

    def _touch(self, function: n.FunctionDef, expr: n.Expr, cuts: _Cuts) -> None:
        parents = self._parents.get(function)
        if parents is None:
            parents = {child: node for node in walk(function.body) for child in children(node)}
            self._parents[function] = parents
        at: n.Node | None = expr
        # Above what is touched everything is, so that many nodes of one tree take linear time.
        while at is not None and at not in cuts.touched:
            cuts.touched.add(at)
            at = parents.get(at)


@dataclass(slots=True)
class _NeedWalker(Backward[Names]):
    """Backward through the functions on the paths to some nodes.

    ``goal``: for the values of the nodes; else for what is left where these are given.
    """

    table: EffectTable
    costs: CostTable
    goal: bool
    cuts: _Cuts = field(default_factory=_Cuts)
    at_exit: Names = _NONE
    returns: bool = False
    """Is what the function returns wanted?"""
    in_next_round: Names = _NONE
    inside_loop: bool = False
    after: Names = _NONE
    """What is live after the calls of the statement at hand."""
    cost: float = 0.0
    reached: int = 0
    """How much that is wanted comes later in the text."""

    def function(self, instance: Instance, cuts: _Cuts, at_exit: Names, returns: bool) -> Need:
        """What a function needs: its cost, and which parameters and globals it reads."""
        inner = _NeedWalker(self.table, self.costs, self.goal, cuts, at_exit, returns)
        live = inner.block(instance.places.function.body.body, at_exit)
        return Need(inner.cost, live)

    def jump(self, stmt: n.Return | n.Jump, fact: Names) -> Names:
        if isinstance(stmt, n.Jump):
            # It leads to the end of the loop, of the switch or of the function, or to the next
            # round: what is live at any of these may be needed.
            return fact | self.at_exit | self.in_next_round
        return (self.taken if self.returns else self.aimed_at)(stmt, self.at_exit)

    def switch(self, stmt: n.Switch, fact: Names) -> Names:
        if self.matters(stmt, fact):
            return self.plain(stmt, fact | self.at_exit | self.in_next_round)
        if not self.goal or stmt not in self.cuts.touched:
            return self.plain(stmt, fact)

        def before(child: n.Stmt, at: Names) -> Names:
            # Each group falls through to the next, or leads to the end.
            return at if isinstance(child, n.Case) else fact | self.statement(child, at)

        return self.taken(stmt.selector, before_cases(NAMES, stmt.body, fact, before))

    def plain(self, stmt: n.Node, fact: Names) -> Names:
        """What is needed whole, or for the nodes inside it, or not at all."""
        if self.matters(stmt, fact):
            return self.taken(stmt, fact - overwritten_by(stmt, self.table))
        return self.aimed_at(stmt, fact)

    def aimed_at(self, node: n.Node, live: Names) -> Names:
        """Only the wanted nodes inside count."""
        if self.goal and node in self.cuts.touched:
            self.after = live
            for need in self.goals(node):
                self.cost += need.cost
                live |= need.reads
        return live

    def taken(self, node: n.Node, live: Names) -> Names:
        self.after = live
        need = self.need(node)
        self.cost += need.cost
        self.reached += 1
        return live | need.reads

    def branch(self, stmt: n.If, fact: Names) -> Names:
        before = self.reached
        then = self.statement(stmt.then, fact)
        other = fact if stmt.other is None else self.statement(stmt.other, fact)
        # A branch that only jumps costs nothing, but other variables are live before it than after.
        needed = self.reached > before or then != fact or other != fact
        if needed or self.leaves(stmt):
            return self.taken(stmt.condition, then | other)
        return self.plain(stmt.condition, fact)

    def loop(self, stmt: Loop, fact: Names) -> Names:
        # No node is inside a loop.
        if not self.matters(stmt, fact):
            return fact
        header = [part for part in children(stmt) if part is not stmt.body]
        around = fact.union(*(self.table.of(part).reads for part in header))
        before, outer = self.cost, (self.in_next_round, self.inside_loop)
        self.inside_loop = True

        def round_(head: Names) -> Names:
            # Every round goes through the whole body anew: only what the last one costs counts.
            self.cost, self.in_next_round = before, head | fact
            return self.statement(stmt.body, head)

        around = before_loop(NAMES, around, round_)
        inside = self.cost - before + sum(self.costs.of(part) for part in header)
        self.cost, self.reached = before + inside * UNKNOWN_TRIPS, self.reached + 1
        self.in_next_round, self.inside_loop = outer
        return around

    def matters(self, node: n.Node, live: Names) -> bool:
        """Is it needed whole?"""
        return bool(self.table.of(node).writes & live) or self.leaves(node)

    def leaves(self, node: n.Node) -> bool:
        """Does it decide whether something wanted is reached?"""
        does = self.table.of(node).does
        # A jump inside a loop or switch leads no further than its end.
        within = isinstance(node, (*LOOPS, n.Switch))
        jumps = does & Does.JUMP and self.inside_loop and not within
        # For the payload a return matters only in front of a node, for the shading everywhere.
        left = does & Does.RETURN and (self.reached > 0 or not self.goal)
        return bool(jumps or left or does & Does.DISCARD)

    def goals(self, node: n.Node) -> Iterable[Need]:
        """What the nodes inside a statement, or below its calls, need."""
        stack = [node]
        while stack:
            part = stack.pop()
            if part in self.cuts.here:
                self.reached += 1
                yield self.need(part)
            elif part in self.cuts.below:
                self.reached += 1
                yield self.call(cast("n.Call", part), self.after, False)
            elif part in self.cuts.touched:
                stack.extend(children(part))

    def need(self, node: n.Node) -> Need:
        """What evaluating an expression or a plain statement needs."""
        if node not in self.cuts.touched:
            return Need(self.costs.of(node), self.table.of(node).reads)
        if node in self.cuts.here and not self.goal:
            return _NOTHING
        if node in self.cuts.below:
            function = self.cuts.below[node][0].places.function
            back = (
                param.name for param in function.proto.params if param.writes_back and param.name
            )
            return self.call(cast("n.Call", node), self.after.union(back), True)
        parts = children(node)
        if isinstance(node, n.Assign) and node.op == "=" and isinstance(node.target, n.Name):
            parts = (node.value,)
        needs = [self.need(part) for part in parts]
        # Its own share: what the operands need may be less than all that they cost.
        cost = self.costs.of(node) - sum(self.costs.of(part) for part in parts)
        reads = _NONE.union(*(need.reads for need in needs))
        if isinstance(node, EXPRESSIONS) and not parts:
            reads |= self.table.of(node).reads
        return Need(cost + sum(need.cost for need in needs), reads)

    def call(self, call: n.Call, at_exit: Names, returns: bool) -> Need:
        """A call on the way to a node: the function as it is left, and the arguments for that."""
        instance, cuts = self.cuts.below[call]
        inside = self.function(instance, cuts, at_exit, returns)
        cost, reads = inside.cost, inside.reads
        for param, arg in zip(instance.places.function.proto.params, call.args, strict=True):
            needs = [self.need(arg)] if param.name in inside.reads else []
            # A node may stand in an argument that nothing else needs.
            if not needs and self.goal and arg in self.cuts.touched:
                needs += self.goals(arg)
            cost += sum(need.cost for need in needs)
            reads = reads.union(*(need.reads for need in needs))
        return Need(cost, reads)


@dataclass(slots=True)
class _OneLevelWalker(_NeedWalker):
    """Stays in one function: what a call on the path needs is given."""

    given: Need = _NOTHING
    asked: Demand | None = None
    """The context of that call, once somebody has asked for it."""
    again: bool = False

    def function(self, instance: Instance, cuts: _Cuts, at_exit: Names, returns: bool) -> Need:
        """What is given."""
        self.again = self.asked is not None
        self.asked = Demand(at_exit, returns)
        return self.given
