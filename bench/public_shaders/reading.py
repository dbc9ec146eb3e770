"""What glslang and the front end make of shaders, and the figures of a collection."""

from __future__ import annotations

import re
import signal
import subprocess
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from traceback import extract_tb
from typing import Any, NamedTuple, NoReturn

from bench.public_shaders.drawing import SECONDS, Picture
from bench.public_shaders.shaders import Shader
from bench.public_shaders.typing import type_differences
from shadercache.ast.nodes import Module
from shadercache.cli.tables import format_table
from shadercache.diagnostics import InputError, Severity
from shadercache.emit.printer import print_module
from shadercache.sema.facts import Facts
from shadercache.source import Source
from shadercache.valid.read import read

TOOL = "glslangValidator"
COLUMNS = (
    *("accepted", "typed", "taken again", "by glslang", "stable", "all of it", "same image"),
    *("rejected", "same line"),
)
# A number of shaders is how many count in this column.
_COUNTS = {"valid": "accepted", "drawn": "same image", "invalid": "rejected"}
_NAME = re.compile(r"'[^']*'|\d+")


class Verdict(NamedTuple):
    """The first error, if there is one, and its line, or 0 where none is named."""

    error: str
    line: int = 0


@dataclass(slots=True)
class Row:
    """A shader; by column of the table what is wrong with it, or nothing. It counts in these alone.

    ``verdicts`` are ours and glslang's; ``printed`` is our print of a shader that both accept.
    """

    shader: Shader
    problems: dict[str, str]
    verdicts: tuple[Verdict, Verdict]
    printed: str | None = None
    picture: Picture | None = None


def examine(folder: Path, shader: Shader) -> Row:
    """All of a shader but its picture. The texts are written to the folder, and stay there."""
    theirs, tree = judge(shader, folder)
    ours, checked, text = attempt(shader)
    verdicts = ours, theirs
    if theirs.error:
        crash = ours.error if ours.error.startswith("TRACEBACK") else ""
        wrong = {"rejected": crash if ours.error else "we accept what glslang rejects"}
        if ours.error and theirs.line:
            wrong["same line"] = "" if ours.line == theirs.line else "another line"
        return Row(shader, wrong, verdicts)
    if checked is None:
        return Row(shader, dict.fromkeys(COLUMNS[:5], ours.error), verdicts)
    printed = Shader(f"printed/{shader.name}", shader.stage, text)
    again, _, text_again = attempt(printed)
    problems = (
        *("", type_differences(tree, *checked), again.error, judge(printed, folder)[0].error),
        "" if text_again == text else "the print of our print is another text",
    )
    return Row(shader, dict(zip(COLUMNS, problems, strict=False)), verdicts, printed.text)


def judge(shader: Shader, folder: Path) -> tuple[Verdict, list[str]]:
    """Write a shader to the folder and ask glslang; the lines have its tree of a valid one."""
    path = folder / shader.file
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(shader.text.encode())
    # -i prints the tree; -d takes a text without #version for desktop GLSL.
    command = [TOOL, "-i", "-d", shader.file]
    done = subprocess.run(command, cwd=folder, capture_output=True, errors="replace", check=False)
    # It exits with 2 where a shader has errors.
    if done.returncode not in (0, 2):
        return Verdict("glslang crashes"), []
    lines = done.stdout.splitlines()
    # ERROR: 0:12: 'name' : what is wrong
    for error in (line for line in lines if line.startswith("ERROR")):
        _, _, line, words = (*error.split(":", 3), "", "")[:4]
        return Verdict(words.strip() or error, int(line) if line.isdecimal() else 0), lines
    return Verdict(""), lines


def attempt(shader: Shader) -> tuple[Verdict, tuple[Module, Facts] | None, str]:
    """Read, check and print a shader; whatever is raised becomes the error."""
    try:
        with time_limit():
            checked = read(Source(shader.file, shader.text), shader.stage)
            return Verdict(""), checked, print_module(checked[0])
    except InputError as error:
        first = next(d for d in error.diagnostics if d.severity is Severity.ERROR)
        source, span = first.source, first.span
        line = source.position(span.start).line if source and span else 0
        return Verdict(f"{first.code} {first.message}", line), None, ""
    except Exception as error:
        last = extract_tb(error.__traceback__)[-1]
        where = f"{last.filename}:{last.lineno}"
        return Verdict(f"TRACEBACK {type(error).__name__}: {error} ({where})"), None, ""


@contextmanager
def time_limit() -> Iterator[None]:
    """Raise :class:`TimeoutError` in what takes longer than it may."""

    def too_long(*_: object) -> NoReturn:
        raise TimeoutError(f"more than {SECONDS} s")

    signal.signal(signal.SIGALRM, too_long)
    signal.alarm(SECONDS)
    try:
        yield
    finally:
        signal.alarm(0)


def table(collections: Mapping[str, Sequence[Row]]) -> str:
    """One line for each collection."""
    rows = []
    for name, shaders in collections.items():
        counts = figures(shaders)
        numbers = [str(counts.get(column, (0, 0))[1]) for column in _COUNTS.values()]
        shares = [
            f"{counts[name][0] / counts[name][1]:.2%}" if name in counts else "-"
            for name in COLUMNS
        ]
        rows.append((name, str(len(shaders)), *numbers, *shares))
    head = ("collection", "shaders", *_COUNTS, *COLUMNS)
    return format_table(head, rows, right=" ".join(head[1:]))


def figures(rows: Sequence[Row]) -> dict[str, tuple[int, int]]:
    """By column: of how many shaders nothing is wrong, and how many count in it."""
    answers: dict[str, list[bool]] = {}
    for row in rows:
        whole = {"all of it": "".join(row.problems.values())} if "accepted" in row.problems else {}
        for column, why in (row.problems | whole).items():
            answers.setdefault(column, []).append(not why)
    return {column: (sum(good), len(good)) for column, good in answers.items()}


def to_json(rows: Sequence[Row]) -> dict[str, Any]:
    """All figures, why shaders were not drawn, and the failures with their places and words."""
    pictures = [row.picture for row in rows if row.picture is not None]
    reasons = Counter(_NAME.sub("…", picture.why) for picture in pictures if picture.same is None)
    return {
        "shaders": len(rows),
        "right, of": figures(rows),
        "varied": sum(picture.varied for picture in pictures),
        "not drawn": dict(reasons.most_common()),
        "failures": failures(rows),
    }


def failures(rows: Sequence[Row]) -> dict[str, list[str]]:
    """Place and words of each failure, by its first column and what is wrong; most first."""
    groups: dict[str, list[str]] = {}
    for row in rows:
        column, why = next((pair for pair in row.problems.items() if pair[1]), ("", ""))
        if why:
            ours, theirs = row.verdicts
            place = f"{row.shader.file}:{ours.line or theirs.line}"
            words = dict.fromkeys(filter(None, (why, ours.error, theirs.error)))
            title = _NAME.sub("…", f"{column}: {why}")
            groups.setdefault(title, []).append(" | ".join((place, *words)))
    return dict(sorted(groups.items(), key=lambda group: -len(group[1])))
