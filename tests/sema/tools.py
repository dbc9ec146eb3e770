"""Shorthand for tests of the checker."""

from __future__ import annotations

from shadercache.ast.nodes import Declarator, Expr, Module
from shadercache.ast.walk import walk
from shadercache.diagnostics import InputError, Severity
from shadercache.front.parse import parse
from shadercache.sema.facts import Facts, Stage
from shadercache.source import Source
from shadercache.valid.validate import validate


def checked(text: str, stage: Stage = "fragment") -> tuple[Module, Facts]:
    """The module of a whole shader, and its facts."""
    source = Source("test.glsl", text)
    module = parse(source)
    return module, validate(module, source, stage, needs_main=True)


def codes(text: str, stage: Stage = "fragment") -> list[str]:
    """Codes of the errors in a whole shader, in the order in which they are told."""
    try:
        checked(text, stage)
    except InputError as error:
        return [item.code for item in error.diagnostics if item.severity is Severity.ERROR]
    return []


def message(text: str, stage: Stage = "fragment") -> str:
    """What the user sees for a shader that is wrong."""
    try:
        checked(text, stage)
    except InputError as error:
        return str(error)
    raise AssertionError("the shader was accepted")


def initialisers(module: Module) -> dict[str, Expr]:
    """The initialiser of each variable that has one, by the variable's name."""
    return {
        node.name: node.init
        for node in walk(module)
        if isinstance(node, Declarator) and node.init is not None
    }
