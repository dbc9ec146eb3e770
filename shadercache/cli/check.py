"""``shadercache check``: is it GLSL, and if not, where and why not."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any, Literal, TypeAlias

import typer

from shadercache.cli.io import read_source
from shadercache.cli.options import SourceOptions
from shadercache.diagnostics import Diagnostic, InputError, Severity
from shadercache.front.foreign_shaders import CODE as FOREIGN
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source

StageName: TypeAlias = Literal["fragment", "vertex"]

_AT_ONCE = 50
"""Files that the reference compiler is given together: it starts slowly, and may crash."""

VERTEX_SUFFIXES = frozenset((".vert", ".vs", ".vsh"))
"""Files of every other name are fragment shaders: .frag, .fs, .fsh, .glsl, stdin."""

READ = SourceOptions()


@dataclass(frozen=True, slots=True)
class CheckedFile:
    """A file and what there is to say of it; it has no source if it cannot be read."""

    name: str
    stage: StageName
    diagnostics: tuple[Diagnostic, ...]
    source: Source | None = None

    @property
    def asked(self) -> Source | None:
        """What the reference compiler is asked about, if there is GLSL to ask about."""
        foreign = any(diagnostic.code == FOREIGN for diagnostic in self.diagnostics)
        return None if foreign else self.source

    def count(self, severity: Severity) -> int:
        """How many diagnostics are of this kind."""
        return sum(diagnostic.severity is severity for diagnostic in self.diagnostics)


def command(
    context: typer.Context,
    shaders: Annotated[list[str], typer.Argument(metavar="FRAG...", help="Shaders; - is stdin.")],
    stage: Annotated[
        StageName | None,
        typer.Option(help="Of all files; if left out, by suffix: .vert, .vs, .vsh."),
    ] = None,
    reading: SourceOptions = READ,
    glslang: Annotated[
        bool, typer.Option(help="Ask glslangValidator as well, where it is installed.")
    ] = True,
    as_json: Annotated[bool, typer.Option("--json", help="Print everything as JSON.")] = False,
) -> None:
    """Read shaders, check names and types, and tell every mistake in them.

    Diagnostics go to stderr and a summary to stdout; with --json all goes to stdout. Exit status 1
    if there is an error in any file.
    """
    options = reading.read_options()
    results: list[CheckedFile] = []
    for first in range(0, len(shaders), _AT_ONCE):
        names = shaders[first : first + _AT_ONCE]
        checked = [_check(name, stage, options) for name in names]
        results += _with_findings(checked, options) if glslang else checked
        if not as_json:
            for file in results[first:]:
                context.obj.show(file.diagnostics)
    print(json.dumps(_to_json(results), indent=1) if as_json else summary(results))
    if any(file.count(Severity.ERROR) for file in results):
        raise typer.Exit(1)


def _check(name: str, stage: StageName | None, options: ReadOptions) -> CheckedFile:
    from shadercache.ast.large import allow_deep_trees
    from shadercache.valid.read import read

    allow_deep_trees()
    # All suffixes count: name.vert.glsl is a vertex shader too.
    is_vertex = not VERTEX_SUFFIXES.isdisjoint(map(str.lower, Path(name).suffixes))
    stage = stage or ("vertex" if is_vertex else "fragment")
    source = None
    try:
        source = read_source(name)
        _, facts = read(source, stage, options)
    except InputError as error:
        return CheckedFile(name, stage, error.diagnostics, source)
    return CheckedFile(name, stage, facts.warnings, source)


def _with_findings(checked: Sequence[CheckedFile], options: ReadOptions) -> list[CheckedFile]:
    """The files with what the reference compiler finds as well, in the order of the source."""
    from shadercache.valid.reference_compiler import Question, ask_compiler, find_compiler

    tool = find_compiler()
    if tool is None:
        return [*checked]
    # Nothing is asked about an empty text: a file that cannot be read only keeps its place, and so
    # does one that is no GLSL.
    questions = [
        Question(file.asked or Source(file.name, ""), file.stage, file.diagnostics)
        for file in checked
    ]
    return [
        replace(file, diagnostics=_in_order(file.diagnostics, findings)) if findings else file
        for file, findings in zip(checked, ask_compiler(tool, questions, options), strict=True)
    ]


def _in_order(own: Sequence[Diagnostic], more: Sequence[Diagnostic]) -> tuple[Diagnostic, ...]:
    return tuple(sorted((*own, *more), key=lambda one: one.span.start if one.span else 0))


def summary(results: Sequence[CheckedFile]) -> str:
    """``12 files: 11 ok, 1 with 3 errors, 2 warnings``, without what there is none of."""
    errors = [count for file in results if (count := file.count(Severity.ERROR))]
    warnings = sum(file.count(Severity.WARNING) for file in results)
    parts = []
    if len(errors) < len(results):
        parts.append(f"{len(results) - len(errors)} ok")
    if errors:
        parts.append(f"{len(errors)} with {_counted(sum(errors), 'error')}")
    if warnings:
        parts.append(_counted(warnings, "warning"))
    return f"{_counted(len(results), 'file')}: {', '.join(parts)}"


def _counted(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"


def _to_json(results: Sequence[CheckedFile]) -> dict[str, Any]:
    return {
        "files": [
            {
                "file": file.name,
                "stage": file.stage,
                "ok": not file.count(Severity.ERROR),
                "diagnostics": [diagnostic.to_json() for diagnostic in file.diagnostics],
            }
            for file in results
        ],
        "ok": sum(not file.count(Severity.ERROR) for file in results),
        "errors": sum(file.count(Severity.ERROR) for file in results),
        "warnings": sum(file.count(Severity.WARNING) for file in results),
    }
