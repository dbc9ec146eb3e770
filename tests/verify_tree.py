"""Checks a module that a pass of the compiler made; the tests run it after every pass.

A rewritten tree has no source text of its own. What must hold is what holds for a parsed one: all
names resolve, all types fit, no name is declared twice in a scope. And because the side tables are
keyed by node, a node that stands at several places of the tree must mean the same at each.
"""

from __future__ import annotations

from collections import Counter
from typing import TypeVar

from shadercache.ast.nodes import Module, Name
from shadercache.diagnostics import InputError
from shadercache.sema.facts import Facts, Stage
from shadercache.sema.inference_context import Tables
from shadercache.source import Source
from shadercache.valid.validate import validate

_Key = TypeVar("_Key")
_Value = TypeVar("_Value")


class InternalError(AssertionError):
    """A pass of the compiler made a module that is not valid GLSL: a bug of the compiler."""


class _OneMeaning(dict[_Key, _Value]):
    """A table whose entries never change."""

    def __setitem__(self, key: _Key, value: _Value) -> None:
        if self.get(key, value) is not value:
            what = f"the name '{key.name}'" if isinstance(key, Name) else type(key).__name__
            raise InternalError(f"{what} stands at two places of the tree and differs in meaning")
        super().__setitem__(key, value)


def verify_module(
    module: Module,
    stage: Stage = "fragment",
    after: str = "a rewrite",
    *,
    unique_names: bool = False,
) -> Facts:
    """Check ``module``; ``after`` names the pass that made it. Returns the new facts.

    With ``unique_names`` no two variables of the module may have the same name, in whatever scopes.
    Raises :class:`InternalError` that lists everything that is wrong.
    """
    source = Source(f"<after {after}>", "")
    tables = Tables(types=_OneMeaning(), symbols=_OneMeaning())
    try:
        facts = validate(module, source, stage, tables=tables)
    except InputError as error:
        problems = [f"{item.message} [{item.code}]" for item in error.diagnostics]
        raise InternalError(f"invalid after {after}:\n  " + "\n  ".join(problems)) from error
    if unique_names:
        _verify_unique(facts, after)
    return facts


def _verify_unique(facts: Facts, after: str) -> None:
    names = [function.name for function in facts.functions]
    names += [item.name for item in facts.declared.values() if item.kind != "builtin"]
    twice = [name for name, count in Counter(names).items() if count > 1]
    if twice:
        raise InternalError(f"two things are called '{twice[0]}' after {after}")
