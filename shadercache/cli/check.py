"""``shadercache check``: is it GLSL, and if not, where and why not."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any

import typer

from shadercache.cli.io import read_source
from shadercache.cli.options import SourceOptions, StageName
from shadercache.diagnostics import Diagnostic, InputError, Severity
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source

_AT_ONCE = 50
"""Files that the reference compiler is given together: it starts slowly, and may crash."""

VERTEX_SUFFIXES = frozenset((".vert", ".vs", ".vsh"))
"""Files of every other name are fragment shaders: .frag, .fs, .fsh, .glsl, stdin."""

READ = SourceOptions()


@dataclass(frozen=True, slots=True)
class CheckedFile:
    """A file and what there is to say of it; it has no source if it cannot be read."""

    file: str
    stage: StageName
    diagnostics: tuple[Diagnostic, ...]
    source: Source | None = None

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
        checked = [_check(name, stage or _stage_of(name), options) for name in names]
        results += _with_findings(checked, options) if glslang else checked
        if not as_json:
            for item in results[first:]:
                context.obj.show(item.diagnostics)
    print(json.dumps(_to_json(results), indent=1) if as_json else summary(results))
    if any(item.count(Severity.ERROR) for item in results):
        raise typer.Exit(1)


def _stage_of(name: str) -> StageName:
    """By suffix; ``name.vert.glsl`` is a vertex shader too."""
    return "fragment" if VERTEX_SUFFIXES.isdisjoint(Path(name).suffixes) else "vertex"


def _check(name: str, stage: StageName, options: ReadOptions) -> CheckedFile:
    from shadercache.ast.large import allow_deep_trees
    from shadercache.valid.read import read

    allow_deep_trees()
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
    questions = [
        Question(item.source or Source(item.file, ""), item.stage, item.diagnostics)
        for item in checked
    ]
    return [
        replace(item, diagnostics=_in_order(item.diagnostics, findings)) if findings else item
        for item, findings in zip(checked, ask_compiler(tool, questions, options), strict=True)
    ]


def _in_order(own: Sequence[Diagnostic], more: Sequence[Diagnostic]) -> tuple[Diagnostic, ...]:
    return tuple(sorted((*own, *more), key=lambda item: item.span.start if item.span else 0))


def summary(results: Sequence[CheckedFile]) -> str:
    """``12 files: 11 ok, 1 with 3 errors, 2 warnings``, without what there is none of."""
    errors = [count for item in results if (count := item.count(Severity.ERROR))]
    warnings = sum(item.count(Severity.WARNING) for item in results)
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
                "file": item.file,
                "stage": item.stage,
                "ok": not item.count(Severity.ERROR),
                "diagnostics": [diagnostic.to_json() for diagnostic in item.diagnostics],
            }
            for item in results
        ],
        "ok": sum(not item.count(Severity.ERROR) for item in results),
        "errors": sum(item.count(Severity.ERROR) for item in results),
        "warnings": sum(item.count(Severity.WARNING) for item in results),
    }
