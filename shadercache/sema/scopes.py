"""Scopes: what a name means at the place that is being checked.

All visible names stand in one dictionary; entering a scope starts a list of what its declarations
hide, and leaving it puts that back.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TypeAlias

from shadercache.ast.nodes import FunctionDef, FunctionProto
from shadercache.lang.types import Type
from shadercache.sema.facts import Symbol


@dataclass(slots=True, eq=False)
class Overload:
    """One function of the user: its head, its types, and its definition once that is seen."""

    proto: FunctionProto
    result: Type
    params: tuple[Type, ...]
    directions: tuple[str, ...]
    definition: FunctionDef | None = None


@dataclass(slots=True, eq=False)
class FunctionSet:
    """All functions of one name, by the types of their parameters."""

    name: str
    overloads: dict[tuple[Type, ...], Overload] = field(default_factory=dict)


Entry: TypeAlias = Symbol | Type | FunctionSet
"""What a name can mean: a variable, a struct, functions."""


class Scopes:
    """A stack of scopes; the lowest is the global one.

    GLSL 1.10 has ``separate`` names for functions: they are kept with the ``function_mark`` behind.
    """

    def __init__(self, separate: bool = False) -> None:
        self.function_mark = "()" if separate else ""
        self.visible: dict[str, Entry] = {}
        self._own: list[set[str]] = [set()]
        self._hidden: list[list[tuple[str, Entry | None]]] = [[]]

    @property
    def depth(self) -> int:
        """0 in the global scope."""
        return len(self._own) - 1

    def push(self) -> None:
        """Enter a scope."""
        self._own.append(set())
        self._hidden.append([])

    def pop(self) -> None:
        """Leave a scope: what it declared is gone, what it hid is visible again."""
        self._own.pop()
        for name, entry in reversed(self._hidden.pop()):
            if entry is None:
                del self.visible[name]
            else:
                self.visible[name] = entry

    def here(self, name: str) -> Entry | None:
        """What ``name`` was declared as in the current scope itself."""
        return self.visible[name] if name in self._own[-1] else None

    def declare(self, name: str, entry: Entry) -> None:
        """Give ``name`` a meaning in the current scope (replacing what it meant there)."""
        own = self._own[-1]
        if name not in own:
            own.add(name)
            self._hidden[-1].append((name, self.visible.get(name)))
        self.visible[name] = entry

    def function_set(self, name: str) -> FunctionSet | Symbol | Type:
        """The global functions called ``name``, a new empty set where there are none.

        Returns whatever else the name means, if it means something else.
        """
        key = name + self.function_mark
        entry = self.visible.get(key)
        if entry is None:
            entry = FunctionSet(name)
            # Straight into the global scope: a function outlives the scope of its prototype.
            self._own[0].add(key)
            self.visible[key] = entry
        return entry

    def names(self) -> list[str]:
        """All names that mean something here (and not the keys of default precisions)."""
        return [name for name in self.visible if name.isidentifier()]
