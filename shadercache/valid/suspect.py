"""What the rules judge, and what they find wrong."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple, TypeAlias, TypeVar, cast

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.lang.types import Type
from shadercache.sema.constants import Constants
from shadercache.sema.facts import Kind
from shadercache.sema.fold import Value
from shadercache.sema.inference_context import Tables
from shadercache.sema.language import Language
from shadercache.sema.storage import storage_of

_NodeT = TypeVar("_NodeT", bound=n.Node)


class Finding(NamedTuple):
    """A mistake, or with ``warning`` something legal but doubtful."""

    code: str
    message: str
    node: n.Node
    hint: str | None = None
    warning: bool = False


@dataclass(frozen=True)
class Suspect:
    """A module on trial, with the tables of the inference."""

    module: n.Module
    language: Language
    tables: Tables
    constants: Constants

    def is_constant(self, expr: n.Expr) -> bool:
        """Is it a constant expression?"""
        return expr in self.constants.expressions

    def value(self, expr: n.Expr) -> Value | None:
        """The value of a constant expression, where it is known."""
        return self.constants.values.get(expr)

    def type_of(self, expr: n.Expr) -> Type:
        """The type of an expression; :data:`ERROR` where it was complained about."""
        return self.tables.types[expr]

    @cached_property
    def _by_class(self) -> Mapping[type[n.Node], list[n.Node]]:
        # One walk for all rules: most of them look at few nodes.
        by_class: dict[type[n.Node], list[n.Node]] = defaultdict(list)
        for node in walk(self.module):
            by_class[type(node)].append(node)
        return by_class

    def nodes(self, kind: type[_NodeT]) -> list[_NodeT]:
        """All nodes of a class, in the order of the source."""
        return cast("list[_NodeT]", self._by_class.get(kind, []))

    @cached_property
    def nested(self) -> frozenset[n.Node]:
        """The declarations inside of functions."""
        return frozenset(stmt.decl for stmt in self.nodes(n.DeclStmt))

    @cached_property
    def variables(self) -> tuple[tuple[n.VarDecl, bool], ...]:
        """The declarations of variables, fields left out, and whether each is local."""
        stated = (stmt.decl for stmt in self.nodes(n.DeclStmt))
        loops: list[n.For | n.While] = [*self.nodes(n.For), *self.nodes(n.While)]
        conditions = (loop.condition for loop in loops)
        return (
            *((decl, False) for decl in self.module.decls if isinstance(decl, n.VarDecl)),
            *((decl, True) for decl in (*stated, *conditions) if isinstance(decl, n.VarDecl)),
        )

    def storage(self, qualifiers: n.Qualifiers, local: bool = False) -> Kind:
        """How something with these qualifiers is stored."""
        return storage_of(qualifiers, self.language.stage, local=local)

    @cached_property
    def _places(self) -> tuple[dict[n.Node, int], dict[tuple[str, n.Node | None], int]]:
        """The place of each node, and that of the first use of each global variable."""
        places: dict[n.Node, int] = {}
        uses: dict[tuple[str, n.Node | None], int] = {}
        for place, node in enumerate(walk(self.module)):
            places[node] = place
            symbol = self.tables.symbols.get(node) if isinstance(node, n.Name) else None
            if symbol is not None and symbol.is_global:
                uses.setdefault((symbol.name, symbol.node), place)
        return places, uses

    def is_used_before(self, node: n.Node, name: str, declaration: n.Node | None) -> bool:
        """Is the global variable ``name`` used in front of a node?"""
        places, uses = self._places
        return uses.get((name, declaration), places[node]) < places[node]


Rule: TypeAlias = Callable[[Any, Suspect], Iterator[Finding]]
"""What is wrong with a node of the class that the rule is for."""
