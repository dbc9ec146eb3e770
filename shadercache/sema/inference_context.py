"""What the parts of the inference share while they go through one module."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from shadercache.ast import nodes as n
from shadercache.lang import builtins
from shadercache.lang.builtins import Signature
from shadercache.lang.types import StructType, Type
from shadercache.sema.constants import Constants
from shadercache.sema.facts import Declares, Symbol
from shadercache.sema.language import Language
from shadercache.sema.problems import Problems
from shadercache.sema.scopes import Overload, Scopes


@dataclass(slots=True)
class Tables:
    """The side tables that are being filled.

    ``heads`` has the types of each head of a function, ``functions`` one overload for all heads of
    a function; ``specs`` the type of each specifier, ``fields`` those of the members of a block,
    ``qualified`` the variables that a declaration of qualifiers alone is about.
    """

    types: dict[n.Expr, Type] = field(default_factory=dict)
    symbols: dict[n.Name, Symbol] = field(default_factory=dict)
    declared: dict[Declares, Symbol] = field(default_factory=dict)
    calls: dict[n.Call, Overload | Signature] = field(default_factory=dict)
    called: dict[n.FunctionDef, list[n.Call]] = field(default_factory=dict)
    structs: dict[StructType, n.StructDef] = field(default_factory=dict)
    heads: dict[n.FunctionProto, Overload] = field(default_factory=dict)
    functions: dict[n.FunctionProto, Overload] = field(default_factory=dict)
    specs: dict[n.TypeSpec, Type] = field(default_factory=dict)
    fields: dict[n.BlockDecl, dict[str, Type]] = field(default_factory=dict)
    qualified: dict[n.QualifierDecl, list[Symbol]] = field(default_factory=dict)


@dataclass(slots=True)
class InferenceContext:
    """The language, the scopes, the tables that are being filled, and what is found wrong.

    ``check`` finds the type of an expression, ``function`` is the one whose body is gone through,
    ``blocks`` has the storages of the interface blocks of each name.
    """

    language: Language
    problems: Problems
    tables: Tables
    scopes: Scopes
    constants: Constants
    check: Callable[[n.Expr], Type]
    function: n.FunctionDef | None = None
    blocks: dict[str, set[str]] = field(default_factory=dict)

    def known_functions(self) -> list[str]:
        """Names of all functions that can be called here (for hints)."""
        names = builtins.function_names()
        known = [name for name in names if self.language.builtin_functions(name)]
        return self.scopes.names() + known

    def known_variables(self) -> list[str]:
        """Names of all variables that can be read here (for hints)."""
        names = builtins.variable_names()
        known = [name for name in names if self.language.builtin_variable(name)]
        return self.scopes.names() + known

    def check_block_name(self, name: str, node: Declares | n.FunctionProto | n.StructDef) -> None:
        """A global name cannot be that of an interface block too."""
        if name in self.blocks and self.scopes.depth == 0:
            self.problems.error("SC202", f"'{name}' is already the name of a block", node)
