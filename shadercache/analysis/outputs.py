"""The outputs of a fragment shader: what each is, and at which render targets it stands."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from math import prod

from shadercache.ast import nodes as n
from shadercache.diagnostics import Diagnostic, InputError
from shadercache.lang.types import Type
from shadercache.sema.facts import Facts
from shadercache.source import Source, Span

MOST_TARGETS = 8
"""Render targets of a pass: GL_MAX_DRAW_BUFFERS is 8 or more (OpenGL 4.6 table 23.67)."""


@dataclass(frozen=True, slots=True)
class Output:
    """One output of the user's. It takes the ``targets`` from ``location`` on: an array as many as
    it has elements."""

    name: str
    type: Type
    location: int

    @property
    def targets(self) -> int:
        """How many render targets it takes."""
        return prod(size or 1 for size in self.type.dims)

    @property
    def places(self) -> range:
        """The locations that it takes."""
        return range(self.location, self.location + self.targets)


def targets_of(outputs: Iterable[Output]) -> int:
    """How many render targets some outputs take."""
    return sum(output.targets for output in outputs)


def outputs_of(module: n.Module, facts: Facts, source: Source) -> tuple[Output, ...]:
    """The outputs in the order of their locations.

    Those without a location take the lowest that are free, in order of declaration (GLSL leaves
    that to the linker: 4.60 section 4.4.2).

    Raises :class:`InputError` SC403: there is none, one is no float or integer, one is a second
    source of blending, they take too many targets, or a location is left out.
    """
    declared = [
        (decl, variable)
        for decl in module.decls
        if isinstance(decl, n.VarDecl) and decl.qualifiers.has("out")
        for variable in decl.declarators
    ]
    problems = list(_problems(declared, facts, source))
    if problems:
        raise InputError(problems)
    outputs = _placed(declared, facts)
    taken = targets_of(outputs)
    last = outputs[-1]
    if last.location + last.targets != taken:
        free = next(at for at, output in _starts(outputs) if output.location != at)
        message = f"no output is at location {free}, but '{last.name}' is at {last.location}"
        hint = "number the outputs from 0 on, without gaps"
        raise InputError(Diagnostic("SC403", message, source, _span(declared, last), hint))
    if taken > MOST_TARGETS:
        message = f"the outputs take {taken} render targets"
        hint = f"OpenGL promises {MOST_TARGETS} (GL_MAX_DRAW_BUFFERS)"
        raise InputError(Diagnostic("SC403", message, source, _span(declared, last), hint))
    return outputs


Declared = Sequence[tuple[n.VarDecl, n.Declarator]]


def _problems(declared: Declared, facts: Facts, source: Source) -> Iterator[Diagnostic]:
    if not declared:
        yield Diagnostic("SC403", "a shader to cache in has an output, and this has none", source)
    for decl, variable in declared:
        kind = facts.declared[variable].type
        if kind.base not in ("float", "int", "uint") or kind.cols != 1:
            message = f"the output '{variable.name}' is a {kind}"
            hint = "outputs are floats, integers, vectors of these, or arrays"
            yield Diagnostic("SC403", message, source, variable.span, hint)
        if _number(decl, "component", facts):
            message = f"'{variable.name}' shares a render target with another output"
            yield Diagnostic("SC403", message, source, variable.span, "make one output of both")
        if _number(decl, "index", facts):
            message = f"'{variable.name}' is the second source of blending"
            hint = "variants are drawn without blending, so that it would be lost"
            yield Diagnostic("SC403", message, source, variable.span, hint)


def _placed(declared: Declared, facts: Facts) -> tuple[Output, ...]:
    # One that is alone may have any location: its passes bind one target.
    alone = len(declared) == 1
    located: list[Output] = []
    others: list[Output] = []
    for decl, variable in declared:
        at = None if alone else _number(decl, "location", facts)
        output = Output(variable.name, facts.declared[variable].type, at or 0)
        (others if at is None else located).append(output)
    taken = {at for output in located for at in output.places}
    for output in others:
        placed = replace(output, location=_free(taken, output.targets))
        taken.update(placed.places)
        located.append(placed)
    return tuple(sorted(located, key=lambda output: output.location))


def _free(taken: set[int], count: int) -> int:
    at = 0
    while not taken.isdisjoint(range(at, at + count)):
        at += 1
    return at


def _starts(outputs: Sequence[Output]) -> Iterator[tuple[int, Output]]:
    """Where each output would stand without gaps."""
    at = 0
    for output in outputs:
        yield at, output
        at += output.targets


def _number(decl: n.VarDecl, word: str, facts: Facts) -> int | None:
    """What a word of the layout says; the last one counts (GLSL 4.60 section 4.4)."""
    for item in reversed(decl.qualifiers.layout or ()):
        if item.name == word and item.value is not None:
            return int(facts.constants[item.value])
    return None


def _span(declared: Declared, output: Output) -> Span:
    return next(variable.span for _, variable in declared if variable.name == output.name)
