"""What the rules judge: a module with the tables of the inference, its nodes by their class."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TypeVar, cast

from shadercache.ast.nodes import (
    BlockDecl,
    DeclStmt,
    Expr,
    For,
    Module,
    Name,
    Node,
    Qualifiers,
    VarDecl,
    While,
)
from shadercache.ast.walk import walk
from shadercache.lang.types import Type
from shadercache.sema.constants import Constants
from shadercache.sema.facts import Kind, Symbol
from shadercache.sema.fold import Value
from shadercache.sema.inference_context import Tables
from shadercache.sema.language import Language
from shadercache.sema.problems import Problems
from shadercache.sema.storage import storage_of

_NodeT = TypeVar("_NodeT", bound=Node)
_Variable = tuple[str, Node | None]


@dataclass(frozen=True)
class Suspect:
    """A module on trial. A rule that finds something reports it to ``problems``."""

    module: Module
    language: Language
    tables: Tables
    constants: Constants
    problems: Problems

    def is_constant(self, expr: Expr) -> bool:
        """Is it a constant expression?"""
        return expr in self.constants.expressions

    def value(self, expr: Expr) -> Value | None:
        """The value of a constant expression, where it is known."""
        return self.constants.values.get(expr)

    def type_of(self, expr: Expr) -> Type:
        """The type of an expression; :data:`ERROR` where it was complained about."""
        return self.tables.types[expr]

    @cached_property
    def _by_class(self) -> Mapping[type[Node], list[Node]]:
        # One walk for all rules: most of them look at few nodes.
        found: dict[type[Node], list[Node]] = defaultdict(list)
        for node in walk(self.module):
            found[type(node)].append(node)
        return found

    def nodes(self, kind: type[_NodeT]) -> list[_NodeT]:
        """All nodes of a class, in the order of the source."""
        return cast("list[_NodeT]", self._by_class.get(kind, []))

    @cached_property
    def variables(self) -> tuple[tuple[VarDecl, bool], ...]:
        """The declarations of variables, fields left out, and whether each is local."""
        return tuple(self._variables())

    def _variables(self) -> Iterator[tuple[VarDecl, bool]]:
        for decl in self.module.decls:
            if isinstance(decl, VarDecl):
                yield decl, False
        for statement in self.nodes(DeclStmt):
            if isinstance(statement.decl, VarDecl):
                yield statement.decl, True
        loops: list[For | While] = [*self.nodes(For), *self.nodes(While)]
        for loop in loops:
            if isinstance(loop.condition, VarDecl):
                yield loop.condition, True

    def storage(self, qualifiers: Qualifiers, local: bool = False) -> Kind:
        """How something with these qualifiers is stored."""
        return storage_of(qualifiers, self.language.stage, local=local)

    def storage_of(self, symbol: Symbol) -> Kind:
        """How a variable is declared, a built-in one that is declared again too."""
        qualifiers = (symbol.block or symbol).qualifiers
        return self.storage(qualifiers, not symbol.is_global)

    def fields(self, block: BlockDecl) -> Mapping[str, Type]:
        """The types of the members of a block."""
        return self.tables.fields[block]

    @cached_property
    def _places(self) -> tuple[dict[Node, int], dict[_Variable, int]]:
        """The place of each node, and that of the first use of each global variable."""
        places: dict[Node, int] = {}
        uses: dict[_Variable, int] = {}
        for place, node in enumerate(walk(self.module)):
            places[node] = place
            symbol = self.tables.symbols.get(node) if isinstance(node, Name) else None
            if symbol is not None and symbol.is_global:
                uses.setdefault((symbol.name, symbol.node), place)
        return places, uses

    def is_used_before(self, node: Node, name: str, declaration: Node | None) -> bool:
        """Is the global variable ``name`` used in front of a node?"""
        places, uses = self._places
        return uses.get((name, declaration), places[node]) < places[node]
