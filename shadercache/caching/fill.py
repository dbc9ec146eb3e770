"""Filling in the words in capitals: calls that stand for what is chosen.

A name in capitals behind the prefix is never emitted. A call of one as a statement stands for the
statements of the function of that name, in whichever file is chosen, and of several files for those
of all, in order; a ``return`` among them ends the function that they are put into. As an expression
it stands for what the function returns::

    sc_TEST(place);                          bool sc_IF_OWN(bool fits) { return fits && sc_own; }
    if (sc_IF_OWN(x > 0.0)) { ... }          int sc_TEST(vec2 place) { if (...) { return 3; } }

    if (...) { return 3; }
    if (x > 0.0 && sc_own) { ... }

Variables keep their names: an ``out`` parameter is declared where it is first assigned.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TypeVar

from shadercache.ast import nodes as n
from shadercache.ast.rewriter import Rewriter, replace_expressions
from shadercache.source import NOWHERE

N = TypeVar("N", bound=n.Node)

LATE = ("PACKED", "MERGED", "ONLY_FLOATS", "ANY_FLOATS", "IF_INTEGERS")
"""Words that mean another thing for each target: see :mod:`shadercache.caching.per_target`."""

_SEVERAL = ("TEST", "RESAMPLE")
"""Words that any number of files may say something about."""


class Filler(Rewriter):
    """Fills in the words of declarations, by the functions and numbers that are chosen."""

    def __init__(self, decls: Iterable[n.Decl], numbers: Mapping[str, str], prefix: str) -> None:
        self._prefix, self._numbers = prefix, numbers
        # Of these there may be none: a filter with nothing to resample.
        self._meant: dict[str, list[n.FunctionDef]] = {name: [] for name in _SEVERAL}
        for decl in decls:
            if isinstance(decl, n.FunctionDef) and (word := self.word(decl.name)):
                self._meant.setdefault(word, []).append(decl)
        self._filled: dict[n.FunctionDef, n.FunctionDef] = {}
        self._alone: set[n.Expr] = set()
        """Calls that are statements of their own."""

    def word(self, name: str) -> str | None:
        """What stands behind the prefix, if that is in capitals."""
        rest = name.removeprefix(self._prefix)
        return rest if rest != name and rest.isupper() else None

    def stands_for(self, decl: n.Decl) -> bool:
        """Is it a function that a word stands for, and so never emitted?"""
        return isinstance(decl, n.FunctionDef) and self.word(decl.name) is not None

    def functions(self, word: str) -> list[n.FunctionDef]:
        """The functions that a word stands for, filled in: one of most, any number of some."""
        functions = self._meant[word]
        assert len(functions) == 1 or word in _SEVERAL, f"{len(functions)} meanings of {word}"
        return [self._whole(function) for function in functions]

    def _whole(self, function: n.FunctionDef) -> n.FunctionDef:
        if function not in self._filled:
            self._filled[function] = self.rewrite(function)
        return self._filled[function]

    def enter(self, node: n.Node) -> n.Node | None:
        if isinstance(node, n.ExprStmt) and isinstance(node.expr, n.Call):
            self._alone.add(node.expr)
        return None

    def statement(self, node: n.Stmt, original: n.Stmt) -> n.Stmt | Sequence[n.Stmt]:
        match node:
            case n.ExprStmt(expr=n.Call(name=name, args=args)) if word := self.word(name):
                return [s for f in self.functions(word) for s in _statements(f, args)]
        return node

    def expression(self, node: n.Expr, original: n.Expr) -> n.Expr:
        match node:
            case n.Name(name=name) if word := self.word(name):
                return n.Literal(NOWHERE, self._numbers[word])
            # One that is a statement becomes statements, above.
            case n.Call(name=name, args=args) if original not in self._alone:
                word = self.word(name)
                if word and word not in LATE:
                    (function,) = self.functions(word)
                    return returned(function, args)
        return node


def _statements(function: n.FunctionDef, args: Sequence[n.Expr]) -> Iterator[n.Stmt]:
    """The statements of a function for these arguments, which declare what it gives back."""
    params = function.proto.params
    meant = dict(zip((param.name for param in params), args, strict=True))
    new = {param.name: param.type for param in params if param.qualifiers.has("out")}
    for stmt in function.body.body:
        match stmt:
            case n.ExprStmt(
                span=span, expr=n.Assign(op="=", target=n.Name(name=name), value=value)
            ):
                if kind := new.pop(name, None):
                    variable = n.Declarator(NOWHERE, name, (), value)
                    decl = n.VarDecl(NOWHERE, n.NO_QUALIFIERS, kind, (variable,))
                    stmt = n.DeclStmt(span, decl)
        yield _with_arguments(stmt, meant)


def returned(function: n.FunctionDef, args: Sequence[n.Expr]) -> n.Expr:
    """What a function that is nothing but ``return`` returns for these arguments."""
    (statement,) = function.body.body
    assert isinstance(statement, n.Return) and statement.value is not None
    params = (param.name for param in function.proto.params)
    return _with_arguments(statement.value, dict(zip(params, args, strict=True)))


def _with_arguments(node: N, meant: Mapping[str | None, n.Expr]) -> N:
    return replace_expressions(
        node, lambda _, expr: meant.get(expr.name, expr) if isinstance(expr, n.Name) else expr
    )
