"""The semantic check: what every name means and which type every expression has.

``check`` goes through a module once, in source order, and fills the tables of :class:`Facts`. It
collects all mistakes; an expression that was complained about silences what depends on it.

The codes of its diagnostics:

=====  ============================================================================================
SC201  a name that is not declared (with the nearest known one as a hint)
SC202  a name that is declared twice in a scope, a function that is defined twice
SC203  a reserved name
SC204  a name of another sort than the place needs: a type, a variable, a function; misplaced void
SC205  an operator that does not apply to its operands
SC206  a call that no overload fits (with the candidates)
SC207  a call with a wrong number of arguments
SC208  an ambiguous call
SC209  a target of an assignment, or an out argument, that cannot be written
SC210  a value that does not convert to the type it is assigned to
SC211  a wrong or missing return value
SC212  a condition that is not bool
SC213  a field, swizzle or length() that does not exist
SC214  an index of a wrong type or out of range, or something without elements
SC215  a wrong array size
SC216  recursion
SC217  no main (a warning, unless one is needed), or a wrong one
SC218  discard, break or continue where there can be none
SC219  wrong arguments of a constructor
SC220  a wrong switch
SC221  a qualifier, or a kind of variable, that the place or the type does not allow
SC222  an initialiser that has to be constant
SC223  a wrong layout
SC224  declarations of a function that disagree, or a wrong result type
SC225  arrays of arrays in a version without them
SC226  an argument that has to be constant
SC227  an integer that needs more than 32 bits
SC228  a float, integer or sampler that has no precision (GLSL ES)
SC290  warning: the drivers disagree about a call of an overloaded built-in function
SC291  warning: a function that is called but not defined
SC292  warning: a name with two underscores
=====  ============================================================================================
"""

from __future__ import annotations

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
from shadercache.diagnostics import InputError, Severity
from shadercache.sema.blocks import BlockChecker
from shadercache.sema.check_context import Context, callee
from shadercache.sema.facts import Facts, Stage
from shadercache.sema.functions import FunctionChecker
from shadercache.sema.interlock import check_interlock
from shadercache.sema.statements import StatementChecker
from shadercache.sema.typespecs import TypeResolver
from shadercache.sema.variables import VariableChecker
from shadercache.source import Source

MAX_TOLD = 1_000
"""Mistakes that are told; after that many no one reads on."""


def check(
    module: Module, source: Source, stage: Stage = "fragment", *, needs_main: bool = False
) -> Facts:
    """Resolve all names and types of ``module``, which was parsed from ``source``.

    A module without ``main`` may be a part of a program: it is warned of, unless ``needs_main``.
    Raises :class:`InputError` with every mistake found (SC2xx), in source order.
    """
    return check_in(Context(module, source, stage), needs_main)


def check_in(context: Context, needs_main: bool = False) -> Facts:
    """:func:`check` with the tables of a given, fresh context."""
    with without_collector():
        return _Checker(context).run(needs_main)


class _Checker:
    """Wires the parts together and walks the global declarations."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._types = TypeResolver(context)
        self._variables = VariableChecker(context, self._types)
        self._blocks = BlockChecker(context, self._types, self._variables)
        self._functions = FunctionChecker(context, self._types)
        self._statements = StatementChecker(context, self._types, self._variables, self._functions)

    def run(self, needs_main: bool) -> Facts:
        for decl in self._context.module.decls:
            self._declaration(decl)
        self._functions.check_all(needs_main)
        check_interlock(self._context)
        found = sorted(
            self._context.diagnostics, key=lambda item: item.span.start if item.span else 0
        )
        errors = [item for item in found if item.severity is Severity.ERROR]
        if errors:
            raise InputError(found if len(found) <= MAX_TOLD else errors[:MAX_TOLD])
        context, constants = self._context, self._types.expressions.constants
        return Facts(
            types=context.types,
            symbols=context.symbols,
            declared=context.declared,
            calls={call: callee(target) for call, target in context.calls.items()},
            constants=constants.scalars(),
            constant_expressions=constants.expressions,
            functions=tuple(d for d in context.module.decls if isinstance(d, FunctionDef)),
            called={function: tuple(calls) for function, calls in context.called.items()},
            prototypes=self._functions.prototypes(),
            structs=context.structs,
            warnings=tuple(found),
        )

    def _declaration(self, decl: Decl) -> None:
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
            self._variables.check_precision(decl)
