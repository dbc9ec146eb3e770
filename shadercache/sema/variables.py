"""Declarations of variables (GLSL 3.30 section 4)."""

from __future__ import annotations

from dataclasses import replace

from shadercache.ast.nodes import (
    BlockDecl,
    Declarator,
    PrecisionDecl,
    QualifierDecl,
    VarDecl,
)
from shadercache.lang.types import VOID, Type
from shadercache.sema.facts import Kind, Symbol
from shadercache.sema.inference_context import InferenceContext
from shadercache.sema.initialisers import InitialiserChecker
from shadercache.sema.language import NEVER
from shadercache.sema.problems import ERROR
from shadercache.sema.scopes import FunctionSet
from shadercache.sema.storage import storage_of
from shadercache.sema.typespecs import TypeResolver

_WRITABLE = ("local", "global", "out")


class VariableChecker:
    """Declares variables, each after its initialiser is checked (the initialiser of ``x`` still
    sees the ``x`` outside, section 4.2.2)."""

    def __init__(self, context: InferenceContext, types: TypeResolver) -> None:
        self._context = context
        self._resolver = types
        self._initialisers = InitialiserChecker(context, types.expressions)
        self._constants = types.expressions.constants

    def declare(self, decl: VarDecl) -> None:
        """A declaration of variables, global or local."""
        base = self._resolver.declared(decl.type)
        local = self._context.scopes.depth > 0
        kind = storage_of(decl.qualifiers, self._context.language.stage, local=local)
        if base is VOID:
            base = self._context.problems.error("SC204", "a variable cannot be void", decl.type)
        for declarator in decl.declarators:
            self._declare_one(decl, declarator, base, kind)
        self._resolver.layout(decl.qualifiers)

    def _declare_one(self, decl: VarDecl, declarator: Declarator, base: Type, kind: Kind) -> None:
        declared = self._resolver.with_dims(base, declarator.dims, declarator)
        init = declarator.init
        given = None if init is None else self._initialisers.check(init, declared)
        if given is not None and given is not ERROR and declared is not ERROR:
            declared = self._initialised(declarator, declared, given, kind)
        symbol = Symbol(
            declarator.name,
            declared,
            kind,
            decl.qualifiers,
            declarator,
            self._context.scopes.depth == 0,
            kind in _WRITABLE,
        )
        self.enter(symbol, declarator)
        if init is None or init not in self._constants.expressions:
            return
        if kind == "const" and declared is not ERROR:
            self._constants.declare(symbol, init)

    def _initialised(self, node: Declarator, declared: Type, given: Type, kind: Kind) -> Type:
        """The type of a variable with an initialiser: sized by it where it has no size."""
        if kind == "uniform" and not self._context.language.at_least(120, NEVER):
            message = "this version of GLSL has no uniforms with a value"
            return self._context.problems.error("SC221", message, node)
        if declared.holds_array and not self._context.language.arrays_are_values:
            message = "this version of GLSL has no arrays with a value"
            return self._context.problems.error("SC210", message, node)
        if kind in ("in", "out"):
            message = f"'{node.name}' is an '{kind}' variable: it has no initialiser"
            return self._context.problems.error("SC221", message, node)
        sized = declared
        if declared.is_unsized and _fills(given, declared):
            sized = given
        if given is VOID or not self._context.language.conversions.converts(given, sized):
            message = f"cannot initialise '{node.name}' of type {declared} with {given}"
            return self._context.problems.error("SC210", message, node.init or node)
        return sized

    def enter(self, symbol: Symbol, node: Declarator | BlockDecl) -> None:
        """Declare a variable, unless the scope has the name; an unsized array may be given its
        size, and a built-in variable other qualifiers."""
        scopes = self._context.scopes
        if symbol.name.startswith("gl_") and not scopes.depth:
            known = self._context.language.builtin_variable(symbol.name)
            if known is not None and known.storage != "const":
                symbol = replace(symbol, kind="builtin", writable=known.storage == "out")
        before = scopes.here(symbol.name)
        if before is not None and not _may_follow(before, symbol):
            what = "a function" if isinstance(before, FunctionSet) else "declared"
            message = f"'{symbol.name}' is already {what} in this scope"
            self._context.problems.error("SC202", message, node)
        self._context.check_block_name(symbol.name, node)
        scopes.declare(symbol.name, symbol)
        self._context.tables.declared[node] = symbol

    def qualify(self, decl: QualifierDecl) -> None:
        """``invariant gl_Position;``, or ``layout(std140) uniform;`` for what follows."""
        context = self._context
        if not decl.names:
            self._resolver.layout(decl.qualifiers)
        for name in decl.names:
            entry, known = context.scopes.visible.get(name), context.language.builtin_variable(name)
            if isinstance(entry, Symbol):
                context.tables.qualified.setdefault(decl, []).append(entry)
            elif known is not None:
                symbol = Symbol(name, known.type, "builtin", writable=known.storage == "out")
                context.tables.qualified.setdefault(decl, []).append(symbol)
            else:
                context.problems.undeclared("variable", name, decl, context.known_variables)

    def declare_precision(self, decl: PrecisionDecl) -> None:
        """``precision mediump float;`` (section 4.5.3)."""
        self._resolver.resolve(decl.type)


def _may_follow(before: object, symbol: Symbol) -> bool:
    """May the same scope declare this again? A built-in variable; an array without a size, to give
    it one (section 4.1.9)."""
    if not isinstance(before, Symbol):
        return False
    if symbol.kind == "builtin":
        return True
    return (
        before.type.is_unsized
        and bool(symbol.type.dims)
        and before.type.element is symbol.type.element
    )


def _fills(given: Type, declared: Type) -> bool:
    """Is ``given`` the array ``declared`` with all its sizes?"""
    while declared.dims and len(given.dims) == len(declared.dims):
        if declared.dims[0] not in (None, given.dims[0]):
            return False
        given, declared = given.element, declared.element
    return given is declared
