"""What every name means and which type every expression has.

A module is gone through once, in source order, which fills the tables of :class:`Facts`. All
mistakes that leave a name without a meaning or an expression without a type are collected; an
expression that was complained about silences what depends on it. Rules that nothing else depends
on stand in :mod:`shadercache.valid`.
"""

from __future__ import annotations

from shadercache.ast import nodes as n
from shadercache.ast.large import without_collector
from shadercache.lang.builtins import Signature
from shadercache.lang.types import Type
from shadercache.sema.constants import Constants
from shadercache.sema.declarations import declare
from shadercache.sema.expression_types import ExpressionChecker
from shadercache.sema.facts import Callee, Facts, Stage
from shadercache.sema.inference_context import InferenceContext, Tables
from shadercache.sema.language import language_of
from shadercache.sema.problems import Problems
from shadercache.sema.scopes import Overload, Scopes
from shadercache.sema.statements import StatementChecker
from shadercache.source import Source


def infer(module: n.Module, source: Source, stage: Stage = "fragment") -> Facts:
    """Resolve all names and types of ``module``, which was parsed from ``source``.

    Raises :class:`InputError` with every mistake found (SC2xx), in source order.
    """
    return facts_of(module, infer_tables(module, source, stage))


def infer_tables(
    module: n.Module, source: Source, stage: Stage, tables: Tables | None = None
) -> InferenceContext:
    """All that is found out about a module, mistakes kept; the given tables are filled."""
    language = language_of(module, stage)
    # 1.10 keeps the names of functions and of variables apart, and so do its compilers.
    scopes = Scopes(separate=language.version == 110)
    tables = Tables() if tables is None else tables
    constants = Constants(tables.types, language.conversions)

    # The context and the checker of expressions need each other: the context is made first.
    def check(expr: n.Expr) -> Type:
        return expressions.check(expr)

    context = InferenceContext(language, Problems(source), tables, scopes, constants, check)
    expressions = ExpressionChecker(context)
    statements = StatementChecker(context)
    with without_collector():
        for decl in module.decls:
            if isinstance(decl, n.FunctionDef):
                statements.check_function(decl)
            else:
                declare(context, decl)
    return context


def facts_of(module: n.Module, context: InferenceContext) -> Facts:
    """What the compiler reads; raises :class:`InputError` with every mistake."""
    warnings, tables = context.problems.warnings(), context.tables
    definitions = {proto: one.definition for proto, one in tables.functions.items()}
    return Facts(
        types=tables.types,
        symbols=tables.symbols,
        declared=tables.declared,
        calls={call: _callee(target) for call, target in tables.calls.items()},
        constants=context.constants.scalars(),
        constant_expressions=context.constants.expressions,
        functions=tuple(d for d in module.decls if isinstance(d, n.FunctionDef)),
        called={function: tuple(calls) for function, calls in tables.called.items()},
        prototypes={
            proto: function
            for proto, function in definitions.items()
            if function is not None and function.proto is not proto
        },
        structs=tables.structs,
        warnings=warnings,
    )


def _callee(target: Overload | Signature) -> Callee:
    """A definition where there is one."""
    if isinstance(target, Signature):
        return target
    return target.definition or target.proto
