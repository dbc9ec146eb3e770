"""Scopes: what a name means at the place that is being checked.

All visible names stand in one dictionary. A scope notes what its declarations hide, and leaving it
puts that back.
"""

from __future__ import annotations

from dataclasses import dataclass
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


class FunctionSet(dict[tuple[Type, ...], Overload]):
    """All functions of one name, by the types of their parameters."""


Entry: TypeAlias = Symbol | Type | FunctionSet
"""What a name can mean: a variable, a struct, functions."""


class Scopes:
    """A stack of scopes; the lowest is the global one.

    GLSL 1.10 has ``separate`` names for functions: they are kept with the ``function_mark`` behind.
    """

    def __init__(self, separate: bool = False) -> None:
        self.function_mark = "()" if separate else ""
        self.visible: dict[str, Entry] = {}
        # What each scope declares, with what is hidden by that.
        self._hidden: list[dict[str, Entry | None]] = [{}]

    @property
    def depth(self) -> int:
        """0 in the global scope."""
        return len(self._hidden) - 1

    def push(self) -> None:
        """Enter a scope."""
        self._hidden.append({})

    def pop(self) -> None:
        """Leave a scope: what it declared is gone, what it hid is visible again."""
        for name, entry in self._hidden.pop().items():
            if entry is None:
                del self.visible[name]
            else:
                self.visible[name] = entry

    def here(self, name: str) -> Entry | None:
        """What ``name`` was declared as in the current scope itself."""
        return self.visible[name] if name in self._hidden[-1] else None

    def declare(self, name: str, entry: Entry) -> None:
        """Give ``name`` a meaning in the current scope (replacing what it meant there)."""
        hidden = self._hidden[-1]
        # A second declaration in one scope replaces the first, and still hides what stands outside.
        if name not in hidden:
            hidden[name] = self.visible.get(name)
        self.visible[name] = entry

    def function_set(self, name: str) -> FunctionSet | Symbol | Type:
        """The global functions called ``name``, a new empty set where there are none.

        Returns whatever else the name means, if it means something else.
        """
        key = name + self.function_mark
        entry = self.visible.get(key)
        if entry is None:
            # Straight into the global scope: a function outlives the scope of its prototype.
            entry = self.visible[key] = FunctionSet()
            self._hidden[0][key] = None
        return entry

    def names(self) -> list[str]:
        """All names that mean something here (and not the keys of default precisions)."""
        return [name for name in self.visible if name.isidentifier()]
