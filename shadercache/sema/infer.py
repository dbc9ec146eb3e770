"""What every name means and which type every expression has.

A module is gone through once, in source order, which fills the tables of :class:`Facts`. All
mistakes that leave a name without a meaning or an expression without a type are collected; an
expression that was complained about silences what depends on it. Rules that nothing else depends
on stand in :mod:`shadercache.valid`.
"""

from __future__ import annotations

from dataclasses import dataclass

from shadercache.ast.large import without_collector
from shadercache.ast.nodes import (
    BlockDecl,
    Decl,
    FunctionDef,
    FunctionProto,
    Module,
    QualifierDecl,
    VarDecl,
)
from shadercache.lang.builtins import Signature
from shadercache.sema.blocks import BlockChecker
from shadercache.sema.constants import Constants
from shadercache.sema.facts import Callee, Facts, Stage
from shadercache.sema.functions import FunctionChecker
from shadercache.sema.inference_context import InferenceContext, Tables
from shadercache.sema.language import Language, language_of
from shadercache.sema.problems import Problems
from shadercache.sema.scopes import Overload, Scopes
from shadercache.sema.statements import StatementChecker
from shadercache.sema.typespecs import TypeResolver
from shadercache.sema.variables import VariableChecker
from shadercache.source import Source


@dataclass(frozen=True, slots=True)
class Inferred:
    """A module with its tables, and what was found wrong on the way."""

    module: Module
    language: Language
    tables: Tables
    constants: Constants
    problems: Problems

    def facts(self) -> Facts:
        """What the compiler reads.

        Raises :class:`InputError` with every mistake that was found.
        """
        warnings, tables = self.problems.warnings(), self.tables
        definitions = {proto: item.definition for proto, item in tables.functions.items()}
        return Facts(
            types=tables.types,
            symbols=tables.symbols,
            declared=tables.declared,
            calls={call: _callee(target) for call, target in tables.calls.items()},
            constants=self.constants.scalars(),
            constant_expressions=self.constants.expressions,
            functions=tuple(d for d in self.module.decls if isinstance(d, FunctionDef)),
            called={function: tuple(calls) for function, calls in tables.called.items()},
            prototypes={
                proto: function
                for proto, function in definitions.items()
                if function is not None and function.proto is not proto
            },
            structs=tables.structs,
            warnings=warnings,
        )


def infer(module: Module, source: Source, stage: Stage = "fragment") -> Facts:
    """Resolve all names and types of ``module``, which was parsed from ``source``.

    Raises :class:`InputError` with every mistake found (SC2xx), in source order.
    """
    return infer_tables(module, source, stage).facts()


def infer_tables(
    module: Module, source: Source, stage: Stage, tables: Tables | None = None
) -> Inferred:
    """:func:`infer` that keeps the mistakes, and fills the given tables."""
    language = language_of(module, stage)
    # 1.10 keeps the names of functions and of variables apart, and so do its compilers.
    scopes = Scopes(separate=language.version == 110)
    context = InferenceContext(language, Problems(source), tables or Tables(), scopes)
    walk = _Walk(context)
    with without_collector():
        for decl in module.decls:
            walk.declaration(decl)
    return Inferred(module, language, context.tables, walk.constants, context.problems)


class _Walk:
    """Wires the parts together."""

    def __init__(self, context: InferenceContext) -> None:
        types = TypeResolver(context)
        self.constants = types.expressions.constants
        self._variables = VariableChecker(context, types)
        self._blocks = BlockChecker(context, types, self._variables)
        self._functions = FunctionChecker(context, types)
        self._statements = StatementChecker(context, types, self._variables, self._functions)

    def declaration(self, decl: Decl) -> None:
        """One declaration at global scope."""
        if isinstance(decl, FunctionDef):
            self._statements.check_function(decl)
        elif isinstance(decl, VarDecl):
            self._variables.declare(decl)
        elif isinstance(decl, BlockDecl):
            self._blocks.declare(decl)
        elif isinstance(decl, FunctionProto):
            self._functions.declare(decl)
        elif isinstance(decl, QualifierDecl):
            self._variables.qualify(decl)
        else:
            self._variables.declare_precision(decl)


def _callee(target: Overload | Signature) -> Callee:
    """A definition where there is one."""
    if isinstance(target, Signature):
        return target
    return target.definition or target.proto
