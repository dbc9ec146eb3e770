"""Checks a module that a pass of the compiler made; the tests run it after every pass.

A rewritten tree has no source text of its own. What must hold is what holds for a parsed one: all
names resolve, all types fit, no name is declared twice in a scope.
"""

from __future__ import annotations

from shadercache.ast.nodes import Module
from shadercache.diagnostics import InputError
from shadercache.sema.check import check
from shadercache.sema.facts import Facts, Stage
from shadercache.source import Source


class InternalError(AssertionError):
    """A pass of the compiler made a module that is not valid GLSL: a bug of the compiler."""


def verify_module(module: Module, stage: Stage = "fragment", after: str = "a rewrite") -> Facts:
    """Check ``module``; ``after`` names the pass that made it. Returns the new facts.

    Raises :class:`InternalError` that lists everything that is wrong.
    """
    try:
        return check(module, Source("<rewritten>", ""), stage)
    except InputError as error:
        problems = [f"{item.message} [{item.code}]" for item in error.diagnostics]
        raise InternalError(f"invalid after {after}:\n  " + "\n  ".join(problems)) from error
