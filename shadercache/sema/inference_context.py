"""What the parts of the inference share while they go through one module."""

from __future__ import annotations

from dataclasses import dataclass, field

from shadercache.ast.nodes import (
    BlockDecl,
    Call,
    Expr,
    FunctionDef,
    FunctionProto,
    Name,
    QualifierDecl,
    StructDef,
    TypeSpec,
)
from shadercache.lang import builtins
from shadercache.lang.builtins import Signature
from shadercache.lang.types import StructType, Type
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

    types: dict[Expr, Type] = field(default_factory=dict)
    symbols: dict[Name, Symbol] = field(default_factory=dict)
    declared: dict[Declares, Symbol] = field(default_factory=dict)
    calls: dict[Call, Overload | Signature] = field(default_factory=dict)
    called: dict[FunctionDef, list[Call]] = field(default_factory=dict)
    structs: dict[StructType, StructDef] = field(default_factory=dict)
    heads: dict[FunctionProto, Overload] = field(default_factory=dict)
    functions: dict[FunctionProto, Overload] = field(default_factory=dict)
    specs: dict[TypeSpec, Type] = field(default_factory=dict)
    fields: dict[BlockDecl, dict[str, Type]] = field(default_factory=dict)
    qualified: dict[QualifierDecl, list[Symbol]] = field(default_factory=dict)


@dataclass(slots=True)
class InferenceContext:
    """The language, the scopes, the tables that are being filled, and what is found wrong."""

    language: Language
    problems: Problems
    tables: Tables
    scopes: Scopes
    function: FunctionDef | None = None
    blocks: dict[str, set[str]] = field(default_factory=dict)

    def known_functions(self) -> list[str]:
        """Names of all functions that can be called here (for hints)."""
        language, own = self.language, self.scopes.names()
        names = builtins.function_names()
        return own + [name for name in names if language.builtin_functions(name)]

    def known_variables(self) -> list[str]:
        """Names of all variables that can be read here (for hints)."""
        names = builtins.variable_names()
        known = [name for name in names if self.language.builtin_variable(name)]
        return self.scopes.names() + known

    def check_block_name(self, name: str, node: Declares | FunctionProto | StructDef) -> None:
        """A global name cannot be that of an interface block too."""
        if name in self.blocks and self.scopes.depth == 0:
            self.problems.error("SC202", f"'{name}' is already the name of a block", node)
