"""What every name means and which type every expression has.

A module is gone through once, in source order, which fills the tables of :class:`Facts`. All
mistakes that leave a name without a meaning or an expression without a type are collected; an
expression that was complained about silences what depends on it. Rules that nothing else depends
on stand in :mod:`shadercache.valid`.
"""

from __future__ import annotations

from dataclasses import dataclass

from shadercache.ast import nodes as n
from shadercache.ast.large import without_collector
from shadercache.lang.builtins import Signature
from shadercache.lang.types import Type
from shadercache.sema.constants import Constants
from shadercache.sema.declarations import declare
from shadercache.sema.expression_types import ExpressionChecker
from shadercache.sema.facts import Callee, Facts, Stage
from shadercache.sema.inference_context import InferenceContext, Tables
from shadercache.sema.language import Language, language_of
from shadercache.sema.problems import Problems
from shadercache.sema.scopes import Overload, Scopes
from shadercache.sema.statements import StatementChecker
from shadercache.source import Source


@dataclass(frozen=True, slots=True)
class Inferred:
    """A module with its tables, and what was found wrong on the way."""

    module: n.Module
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
            functions=tuple(d for d in self.module.decls if isinstance(d, n.FunctionDef)),
            called={function: tuple(calls) for function, calls in tables.called.items()},
            prototypes={
                proto: function
                for proto, function in definitions.items()
                if function is not None and function.proto is not proto
            },
            structs=tables.structs,
            warnings=warnings,
        )


def infer(module: n.Module, source: Source, stage: Stage = "fragment") -> Facts:
    """Resolve all names and types of ``module``, which was parsed from ``source``.

    Raises :class:`InputError` with every mistake found (SC2xx), in source order.
    """
    return infer_tables(module, source, stage).facts()


def infer_tables(
    module: n.Module, source: Source, stage: Stage, tables: Tables | None = None
) -> Inferred:
    """:func:`infer` that keeps the mistakes, and fills the given tables."""
    language = language_of(module, stage)
    # 1.10 keeps the names of functions and of variables apart, and so do its compilers.
    scopes = Scopes(separate=language.version == 110)
    tables = Tables() if tables is None else tables
    constants = Constants(tables.types, language.conversions)
    problems = Problems(source)

    def check(expr: n.Expr) -> Type:
        return expressions.check(expr)

    context = InferenceContext(language, problems, tables, scopes, constants, check)
    expressions = ExpressionChecker(context)
    statements = StatementChecker(context)
    with without_collector():
        for decl in module.decls:
            if isinstance(decl, n.FunctionDef):
                statements.check_function(decl)
            else:
                declare(context, decl)
    return Inferred(module, language, tables, constants, problems)


def _callee(target: Overload | Signature) -> Callee:
    """A definition where there is one."""
    if isinstance(target, Signature):
        return target
    return target.definition or target.proto
