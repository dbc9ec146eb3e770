"""Where jumps lead, for :mod:`shadercache.transform.remove_dead`: what is live there, what ends."""

from __future__ import annotations

from dataclasses import dataclass

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk

Live = frozenset[str]


@dataclass(frozen=True, slots=True)
class Jumps:
    """What is live where ``break`` and ``continue`` lead."""

    after_break: Live = frozenset()
    after_continue: Live = frozenset()
    ends: bool = False
    """Is nothing executed behind a ``break``?"""


NO_JUMPS = Jumps()


def ends_here(stmt: n.Stmt, jumps: Jumps) -> bool:
    """Is nothing executed behind a statement for sure, and nothing returned by it?"""
    return (isinstance(stmt, n.Return) and stmt.value is None) or (is_break(stmt) and jumps.ends)


def returns_nothing(stmt: n.Stmt) -> bool:
    """Does no ``return`` in a statement give a value?"""
    return all(item.value is None for item in walk(stmt) if isinstance(item, n.Return))


def is_break(stmt: n.Stmt) -> bool:
    """Is it ``break;``?"""
    return isinstance(stmt, n.Jump) and stmt.word == "break"


def is_empty(stmt: n.Stmt) -> bool:
    """Is nothing in it?"""
    return (isinstance(stmt, n.Block) and not stmt.body) or (
        isinstance(stmt, n.ExprStmt) and stmt.expr is None
    )
