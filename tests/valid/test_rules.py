"""One case per rule of the language; the cases stand in ``rules/*.glsl``.

The title of a case starts with the section of the GLSL 3.30 specification that it tests. Each
verdict is compared with glslang's.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import pytest
from sema.tools import codes

from shadercache.sema.facts import Stage
from tests.glslang import errors_of, needs_glslang

RULES = Path(__file__).with_name("rules")
PRELUDE = (RULES / "prelude.glsl").read_text()


@dataclass(frozen=True)
class Case:
    """One shader, the codes it is refused with, and whether glslang takes it."""

    title: str
    text: str
    stage: Stage
    codes: tuple[str, ...]
    glslang_accepts: bool


def read_cases(file: Path) -> Iterator[Case]:
    for part in file.read_text().split("//// ")[1:]:
        head, _, body = part.partition("\n")
        title, _, verdict = head.rpartition(" | ")
        expected, _, words = verdict.rstrip("]").partition("[")
        version = re.search(r"\d+", words)
        refused = tuple(word for word in expected.split() if word != "ok")
        if not re.search(r"\bmain\b", body):
            body = f"{PRELUDE}void main() {{\n{body}}}\n"
        accepts = not refused
        number = version[0] if version else "330"
        if {"es", "100"}.intersection(words.split()):
            number = f"{version[0] if version else 300} es".removeprefix("100 es") or "100"
            body = body if "bare" in words else f"precision highp float;\n{body}"
        elif "compatibility" in words:
            number += " compatibility"
        if "glslang" in words:
            accepts = "glslang accepts" in words
        yield Case(
            f"{file.stem}: {title}",
            f"#version {number}\n{body}",
            "vertex" if "vertex" in words else "fragment",
            refused,
            accepts,
        )


CASES = [case for file in sorted(RULES.glob("*.glsl")) for case in read_cases(file)]
EVERY = pytest.mark.parametrize("case", CASES, ids=lambda case: case.title)


def test_there_are_enough_cases() -> None:
    assert len(CASES) >= 250
    assert len({case.title for case in CASES}) == len(CASES)


@EVERY
def test_rule(case: Case) -> None:
    assert tuple(codes(case.text, case.stage)) == case.codes


@pytest.fixture(scope="module")
def verdicts(tmp_path_factory: pytest.TempPathFactory) -> Mapping[str, list[str]]:
    """glslang's errors for every case, by title."""
    folder = tmp_path_factory.mktemp("rules")
    files = {}
    for i, case in enumerate(CASES):
        file = folder / f"case{i}.{case.stage[:4]}"
        file.write_text(case.text)
        files[file] = case.title
    return {files[file]: errors for file, errors in errors_of(files).items()}


@needs_glslang
@EVERY
def test_glslang_agrees(case: Case, verdicts: Mapping[str, list[str]]) -> None:
    errors = verdicts[case.title]
    assert (not errors) == case.glslang_accepts, errors
