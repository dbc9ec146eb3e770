"""A walk backward through functions for what some nodes need, or what is left without them.

Of a statement that is needed all counts; of one that holds nodes and is not needed, these; and of
what holds a node, for what is left, all but the node.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import cast

from shadercache.analysis.call_paths import Instance
from shadercache.analysis.costs.cost import UNKNOWN_TRIPS, CostTable
from shadercache.analysis.costs.path_costs import Demand, Names, Need
from shadercache.analysis.dataflow import LOOPS, NAMES, Backward, Loop, before_cases, before_loop
from shadercache.analysis.effect_table import EffectTable, overwritten_by
from shadercache.analysis.effects import Does
from shadercache.ast import nodes as n
from shadercache.ast.walk import EXPRESSIONS, children, walk

NOTHING_READ: Names = frozenset()
NOTHING_NEEDED = Need(0.0, NOTHING_READ)


@dataclass(frozen=True, slots=True, eq=False)
class Body:
    """A function's tree: what each node stands in, its number, and that of the last inside it.

    ``beside`` keeps what :meth:`OneLevelWalker.beside` found out.
    """

    parents: dict[n.Node, n.Node]
    first: dict[n.Node, int]
    last: dict[n.Node, int]
    beside: dict[tuple[n.Node, n.Node], Names] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, eq=False)
class Holders:
    """Everything in a function's tree that holds the node of this number."""

    body: Body
    number: int

    def __contains__(self, node: n.Node) -> bool:
        return self.body.first[node] <= self.number <= self.body.last[node]


def body_of(function: n.FunctionDef) -> Body:
    """The tree of a function."""
    order = list(walk(function.body))
    parents = {child: node for node in order for child in children(node)}
    first = {node: number for number, node in enumerate(order)}
    last = dict(first)
    for node in reversed(order[1:]):
        last[parents[node]] = max(last[parents[node]], last[node])
    return Body(parents, first, last)


@dataclass(slots=True)
class Cuts:
    """The nodes in one function, and those below its calls."""

    here: set[n.Node] = field(default_factory=set)
    below: dict[n.Node, tuple[Instance, Cuts]] = field(default_factory=dict)
    touched: set[n.Node] | Holders = field(default_factory=set)
    """Everything in the function's tree that holds one of these."""


@dataclass(slots=True)
class NeedWalker(Backward[Names]):
    """Backward through the functions on the paths to some nodes.

    ``goal``: for the values of the nodes; else for what is left where these are given.
    """

    table: EffectTable
    costs: CostTable
    goal: bool
    cuts: Cuts = field(default_factory=Cuts)
    at_exit: Names = NOTHING_READ
    returns: bool = False
    """Is what the function returns wanted?"""
    in_next_round: Names = NOTHING_READ
    inside_loop: bool = False
    after: Names = NOTHING_READ
    """What is live after the calls of the statement at hand."""
    cost: float = 0.0
    reached: int = 0
    """How much that is wanted comes later in the text."""

    def function(self, instance: Instance, cuts: Cuts, at_exit: Names, returns: bool) -> Need:
        """What a function needs: its cost, and which parameters and globals it reads."""
        inner = NeedWalker(self.table, self.costs, self.goal, cuts, at_exit, returns)
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
            return NOTHING_NEEDED
        if node in self.cuts.below:
            function = self.cuts.below[node][0].places.function
            back = (
                param.name for param in function.proto.params if param.writes_back and param.name
            )
            return self.call(cast("n.Call", node), self.after.union(back), True)
        parts = _read(node)
        needs = [self.need(part) for part in parts]
        # Its own share: what the operands need may be less than all that they cost.
        cost = self.costs.of(node) - sum(self.costs.of(part) for part in parts)
        reads = NOTHING_READ.union(*(need.reads for need in needs))
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


@dataclass(slots=True, kw_only=True)
class OneLevelWalker(NeedWalker):
    """Stays in one function with one cut: what a call on the path needs is given.

    Every node of a function has such a walk. So none goes down the whole way to its node: in a long
    chain of operators that would take quadratic time.
    """

    place: n.Node
    body: Body
    given: Need = NOTHING_NEEDED
    asked: Demand | None = None
    """The context of that call, once somebody has asked for it."""
    again: bool = False

    def function(self, instance: Instance, cuts: Cuts, at_exit: Names, returns: bool) -> Need:
        """What is given."""
        self.again = self.asked is not None
        self.asked = Demand(at_exit, returns)
        return self.given

    def goals(self, node: n.Node) -> Iterable[Need]:
        self.reached += 1
        if self.place in self.cuts.below:
            yield self.call(cast("n.Call", self.place), self.after, False)
        else:
            yield self.need(self.place)

    def need(self, node: n.Node) -> Need:
        # By its name, for with slots the class that `super()` means is another.
        if node is self.place or node not in self.cuts.touched:
            return NeedWalker.need(self, node)
        inside = self.need(self.place)
        cost = self.costs.of(node) - self.costs.of(self.place) + inside.cost
        return Need(cost, inside.reads | self.beside(node))

    def beside(self, node: n.Node) -> Names:
        """What is read in a node beside the place that is cut."""
        kept, parents = self.body.beside, self.body.parents
        path: list[n.Node] = []
        at = self.place
        while at is not node and (node, at) not in kept:
            path.append(at)
            at = parents[at]
        names = NOTHING_READ if at is node else kept[node, at]
        for part in reversed(path):
            others = (other for other in _read(parents[part]) if other is not part)
            more = names.union(*(self.table.of(other).reads for other in others))
            # Chains often read nothing new: one set will do for many of their links.
            names = kept[node, part] = more if len(more) > len(names) else names
        return names


def _read(node: n.Node) -> Sequence[n.Node]:
    """What a node reads of its children: what is overwritten wholly it does not."""
    match node:
        case n.Assign(op="=", target=n.Name(), value=value):
            return (value,)
    return children(node)
