"""The equations of data flow over structured programs, solved for any lattice.

GLSL has no ``goto``, so a walk over the statements meets all of the control flow. Facts go backward
through blocks and conditionals in one pass. Only a loop has an equation that needs a fixed point,
and only a ``switch`` has paths that fall through. Facts that go forward along a relation ("what
does this flow into?") are a closure.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Hashable, Iterable, Sequence
from dataclasses import dataclass
from typing import Generic, TypeAlias, TypeVar

from shadercache.ast import nodes as n

F = TypeVar("F")
H = TypeVar("H", bound=Hashable)

Loop: TypeAlias = n.For | n.While | n.DoWhile
LOOPS = (n.For, n.While, n.DoWhile)


@dataclass(frozen=True, slots=True)
class Lattice(Generic[F]):
    """How facts meet where paths do, and whether one fact says no more than another."""

    join: Callable[[F, F], F]
    within: Callable[[F, F], bool]


NAMES: Lattice[frozenset[str]] = Lattice(frozenset.union, frozenset.issubset)
"""Sets of variables that may be live."""


class Backward(ABC, Generic[F]):
    """A walk backward through statements: from the fact behind each to the one before it."""

    def block(self, stmts: Sequence[n.Stmt], fact: F) -> F:
        """Through statements in a row."""
        for stmt in reversed(stmts):
            fact = self.statement(stmt, fact)
        return fact

    def statement(self, stmt: n.Stmt, fact: F) -> F:
        """Through one statement of whatever kind."""
        match stmt:
            case n.Block():
                return self.block(stmt.body, fact)
            case n.If():
                return self.branch(stmt, fact)
            case n.For() | n.While() | n.DoWhile():
                return self.loop(stmt, fact)
            case n.Switch():
                return self.switch(stmt, fact)
            case n.Return() | n.Jump():
                return self.jump(stmt, fact)
        return self.plain(stmt, fact)

    @abstractmethod
    def branch(self, stmt: n.If, fact: F) -> F: ...

    @abstractmethod
    def loop(self, stmt: Loop, fact: F) -> F: ...

    @abstractmethod
    def switch(self, stmt: n.Switch, fact: F) -> F: ...

    @abstractmethod
    def jump(self, stmt: n.Return | n.Jump, fact: F) -> F: ...

    @abstractmethod
    def plain(self, stmt: n.Stmt, fact: F) -> F: ...


def before_loop(lattice: Lattice[F], at_head: F, round_: Callable[[F], F]) -> F:
    """The least fact at the head of a loop that no further round adds to.

    ``at_head`` holds there anyway; ``round_`` leads backward through the body, from one head to the
    head before.
    """
    # Facts only grow, and a function has finitely many variables for them to grow by: this ends.
    while True:
        earlier = round_(at_head)
        if lattice.within(earlier, at_head):
            return at_head
        at_head = lattice.join(at_head, earlier)


def before_cases(
    lattice: Lattice[F], body: Sequence[n.Stmt], after: F, before: Callable[[n.Stmt, F], F]
) -> F:
    """The fact where a ``switch`` chooses: each group of statements falls through to the next.

    ``before`` leads backward through one statement.
    """
    # No label need fit (GLSL 4.60 section 6.2): the switch may lead straight to its end.
    head = at = after
    for stmt in reversed(body):
        if isinstance(stmt, n.Case):
            head = lattice.join(head, at)
        at = before(stmt, at)
    return head


def reached(start: Iterable[H], onward: Callable[[H], Iterable[H]]) -> dict[H, None]:
    """Everything that ``start`` leads to, itself included; an ordered set."""
    seen: dict[H, None] = {}
    todo = list(start)
    while todo:
        node = todo.pop()
        if node not in seen:
            seen[node] = None
            todo += onward(node)
    return seen
