"""What a writer of shaders knows: choices, scopes, functions, the flow of control."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from typing import TypeVar

from .dialects import Dialect

T = TypeVar("T")

FLOATS = ("float", "vec2", "vec3", "vec4")
WIDTH = {kind: width for width, kind in enumerate(FLOATS, 1)}
ELEMENT = {"float[3]": "float", "vec2[2]": "vec2"}
LENGTH = {"float[3]": 3, "vec2[2]": 2}
FIELDS = {"Pair": (("first", "float"), ("second", "vec3"))}

NAMES = ("a", "b", "c", "d", "e", "g", "h", "k")
"""Of locals and parameters: few, so that they shadow one another."""


@dataclass(frozen=True)
class Variable:
    """Something that can be read, and perhaps written."""

    kind: str
    writable: bool = True


@dataclass(frozen=True)
class Function:
    """A function that is written already. ``derives``: for uniform flow only.

    ``role``: what it is for, if for anything; ``carrier``: the global that it works on, with its
    type; ``left``: the global that its result is left in.
    """

    name: str
    result: str
    params: tuple[tuple[str, str], ...]
    derives: bool
    discards: bool
    role: str = ""
    carrier: tuple[str, str] = ("", "")
    left: tuple[str, str] = ("", "")


@dataclass
class Flow:
    """Where the writer stands.

    ``uniform``: all fragments of a triangle come here. ``escapes``: a jump out of the loop at hand,
    out of the function or a discard may be written. ``reach`` says which jumps there are.
    """

    uniform: bool = True
    escapes: bool = True
    loop: bool = False
    switch: bool = False


@dataclass
class State:
    """The writer's memory; ``pick(n)`` chooses one of 0 .. n-1, where 0 is the simplest."""

    pick: Callable[[int], int]
    dialect: Dialect
    tags: Counter[str] = field(default_factory=Counter)
    scopes: list[dict[str, Variable]] = field(default_factory=lambda: [{}])
    functions: list[Function] = field(default_factory=list)
    flow: Flow = field(default_factory=Flow)
    result: str = "void"
    calls_left: int = 0
    derives: bool = False
    discards: bool = False
    default_precision: bool = True
    may_discard: bool = False
    stories: int = 0
    indices_open: int = 0
    left: int = 0
    """How often fragments were let go."""

    def choose(self, items: Sequence[T]) -> T:
        """One of the items; the first is the simplest."""
        return items[self.pick(len(items))] if len(items) > 1 else items[0]

    def chance(self, one_in: int) -> bool:
        """True once in so many times."""
        return self.pick(one_in) == one_in - 1

    def tag(self, name: str) -> None:
        """Note that a construct was used."""
        self.tags[name] += 1

    def visible(self) -> dict[str, Variable]:
        """What a name means here."""
        found: dict[str, Variable] = {}
        for scope in self.scopes:
            found |= scope
        return found

    def is_global(self, place: str) -> bool:
        """Does the place belong to a global variable?"""
        name = place.split(".")[0].split("[")[0]
        return name in self.scopes[0] and not any(name in scope for scope in self.scopes[1:])

    def declare(self, name: str, kind: str, writable: bool = True) -> None:
        """Make a name known from here to the end of the scope."""
        if any(name in scope for scope in self.scopes[:-1]):
            self.tag("shadowed name")
        self.scopes[-1][name] = Variable(kind, writable)

    def new_name(self) -> str | None:
        """A name that the scope at hand has not; None if it has all."""
        free = [name for name in NAMES if name not in self.scopes[-1]]
        return self.choose(free) if free else None

    @contextmanager
    def scope(self, **changes: bool) -> Iterator[None]:
        """An inner scope with another flow; what was said of the flow before holds behind it.

        Where a jump or a discard leads out of it, only some fragments go on behind it.
        """
        before = self.flow
        self.flow = replace(before, **changes)
        self.scopes.append({})
        yield
        self.scopes.pop()
        self.flow = before

    def leave(self) -> None:
        """Some fragments have left: no more derivatives from here on in this function."""
        self.flow.uniform = False
        self.left += 1

    def typed(self, kind: str) -> str:
        """The type as a declaration has it: in GLSL ES with a precision."""
        base = kind.split("[")[0]
        if not self.dialect.es or base.startswith(("b", "P", "void")):
            return base
        if base.startswith(("i", "u")):
            return base
        if not self.default_precision:
            return f"highp {base}"
        if self.chance(6):
            self.tag("precision")
            return f"{self.choose(('highp', 'mediump', 'lowp'))} {base}"
        return base

    def variable(self, kind: str, name: str) -> str:
        """A declaration of a variable, without initialiser and semicolon."""
        count = f"[{LENGTH[kind]}]" if kind in LENGTH else ""
        return f"{self.typed(kind)} {name}{count}"
