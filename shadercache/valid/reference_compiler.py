"""What glslangValidator, the reference compiler, finds wrong with a shader: SC240.

It is asked of what the caching never meets, so that no rule for it stands here. It is given what
the parser reads: macros expanded, files included, with the ``#version`` and the declarations that
a host adds. So it can read every dialect, and each of its lines stands for a place in the source.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryDirectory

from shadercache.diagnostics import Diagnostic, InputError, Severity
from shadercache.front.parse import preprocessed
from shadercache.front.preprocess import written_lines
from shadercache.front.read_options import ReadOptions
from shadercache.sema.facts import Stage
from shadercache.source import Source, Span

_TOOL = "glslangValidator"
_ERROR = re.compile(r"ERROR: (?:0|\S+\.(?:vert|frag)):(\d+): (?!'' : compilation terminated)(.*)")
# Where it lacks an extension or a name of one, or has limits that a driver need not have, nothing
# that it says is of use. Syntax and names are judged here already.
_LACKS = re.compile(
    r"extension not supported|not supported (?:for|with|in) this|syntax error|undeclared identifier"
    r"|no matching overloaded function|starting with \"gl_\" are reserved|gl_Max\w+|is too large"
)
_SECONDS = 20
_MAX_LEXEMES = 100_000


@dataclass(frozen=True, slots=True)
class Question:
    """A shader, and what is known to be wrong with it."""

    source: Source
    stage: Stage
    diagnostics: Sequence[Diagnostic] = ()


def find_compiler() -> str | None:
    """The path of glslangValidator, where it is installed."""
    return shutil.which(_TOOL)


def ask_compiler(
    tool: str, questions: Sequence[Question], options: ReadOptions
) -> list[tuple[Diagnostic, ...]]:
    """What the compiler finds in each shader: the first error of each line, but of no line of which
    an error is told already.

    Nothing where it cannot be asked: the shader is broken for the preprocessor or very long, or the
    compiler crashes or lacks an extension.
    """
    texts = [_readable(question.source, options) for question in questions]
    with TemporaryDirectory(prefix="shadercache-") as folder:
        files = {}
        for number, (question, (text, _)) in enumerate(zip(questions, texts, strict=True)):
            if text:
                # The ending tells the stage: the first four letters of its name.
                files[number] = Path(folder, f"{number}.{question.stage[:4]}")
                files[number].write_text(text, encoding="utf-8", newline="")
        outputs: dict[int, str] = {}
        if options.dialect == "vulkan":
            # It would link the files to one program.
            for number, file in files.items():
                outputs |= _run([tool, "-V", "-o", os.devnull], {number: file})
        elif files:
            outputs = _run([tool], files)
    return [
        _findings(question, places, outputs.get(number, ""))
        for number, (question, (_, places)) in enumerate(zip(questions, texts, strict=True))
    ]


def _run(tool: Sequence[str], files: dict[int, Path]) -> dict[int, str]:
    """What the compiler says of each file; all at once, for it starts slowly."""
    # -C: go on behind the first error.
    command = [*tool, "-C", *(file.name for file in files.values())]
    try:
        done = subprocess.run(
            command,
            # Names alone: what a path holds may be garbled on the way there and back.
            cwd=next(iter(files.values())).parent,
            capture_output=True,
            encoding="utf-8",
            errors="replace",
            timeout=_SECONDS,
            check=False,
        )
    except (OSError, subprocess.SubprocessError):
        return {}
    if done.returncode not in (0, 2):  # no verdict: a file makes it crash
        # Each by itself: only the one that makes it crash goes without a verdict.
        alone = [_run(tool, {number: file}) for number, file in files.items() if len(files) > 1]
        return {number: text for one in alone for number, text in one.items()}
    numbers = {file.name: number for number, file in files.items()}
    said: dict[int, list[str]] = {}
    lines: list[str] = []
    for line in done.stdout.splitlines():
        if line in numbers:
            lines = said.setdefault(numbers[line], [])
        lines.append(line)
    return {number: "\n".join(lines) for number, lines in said.items()}


def _findings(question: Question, places: list[Span], said: str) -> tuple[Diagnostic, ...]:
    if _LACKS.search(said):
        return ()
    source, findings = question.source, []
    errors = [
        diagnostic.span
        for diagnostic in question.diagnostics
        if diagnostic.severity is Severity.ERROR
    ]
    seen = {_line(source, span.start) for span in errors if span is not None}
    for match in _ERROR.finditer(said):
        # What is wrong at the end of the text has the number of a line more.
        span = places[min(int(match[1]), len(places)) - 1]
        if _line(source, span.start) not in seen:
            seen.add(_line(source, span.start))
            message = f"glslang: {' '.join(match[2].split())}"
            findings.append(Diagnostic("SC240", message, source, span))
    return tuple(findings)


def _readable(source: Source, options: ReadOptions) -> tuple[str, list[Span]]:
    """The shader for the compiler, without directives of the preprocessor, and the place of each
    line; an empty text where it cannot be asked."""
    try:
        prepared = preprocessed(source, options)
    except InputError:
        return "", []
    lexemes = prepared.lexemes
    if not 0 < len(lexemes.texts) <= _MAX_LEXEMES:
        return "", []
    # `#version 100` takes no word behind it.
    profile = prepared.profile if prepared.version != 100 else None
    lines = [f"#version {prepared.version} {profile or ''}".rstrip()]
    lines += written_lines(prepared)
    places = [Span(0, 0), *(directive.span for directive in prepared.directives)]
    places = places[: len(lines)]
    numbers = [_line(source, start) for start in lexemes.starts]
    breaks = [at for at, (one, two) in enumerate(pairwise(numbers), 1) if one != two]
    for first, behind in pairwise((0, *breaks, len(numbers))):
        lines.append(" ".join(lexemes.texts[first:behind]))
        places.append(Span(lexemes.starts[first], lexemes.ends[behind - 1]))
    return "\n".join([*lines, ""]), places


def _line(source: Source, offset: int) -> tuple[int, int]:
    """The file and the line of a place."""
    return source.part(offset).base, source.position(offset).line
