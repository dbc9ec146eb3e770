"""glslangValidator as a second opinion on GLSL."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from collections.abc import Iterable
from pathlib import Path

import pytest

TOOL = shutil.which("glslangValidator")

needs_glslang = pytest.mark.skipif(TOOL is None, reason="glslangValidator is not installed")

_ERROR = re.compile(r"ERROR: (?:0|[^:]*):(\d+): (.*)")


def lines_of(files: Iterable[Path]) -> dict[Path, list[str]]:
    """All lines about each file, judged alone."""
    by_name = {str(file): file for file in files}
    said: dict[Path, list[str]] = {file: [] for file in by_name.values()}
    about: list[str] = []
    # -C: all errors of a file, not the first alone.
    for line in _run(["-C", *by_name]).splitlines():
        if line in by_name:
            about = said[by_name[line]]
        elif line.strip():
            about.append(line)
    return said


def errors_of(files: Iterable[Path]) -> dict[Path, list[str]]:
    """The errors of each file, judged alone."""
    return {
        file: [line for line in lines if line.startswith("ERROR")]
        for file, lines in lines_of(files).items()
    }


def objections(texts: Iterable[tuple[str, str]], folder: Path) -> list[str]:
    """Every error and warning about some shaders, each with its text; nothing without glslang.

    The name of a shader ends in its stage; equal ones are judged once.
    """
    if TOOL is None:
        return []
    files = {
        folder / f"{number}{suffix}": text
        for number, (suffix, text) in enumerate(
            dict.fromkeys((Path(name).suffix, text) for name, text in texts)
        )
    }
    for file, text in files.items():
        file.write_text(text, encoding="utf-8")
    return [
        f"{line}\n{files[file]}"
        for file, lines in lines_of(files).items()
        for line in lines
        if line.startswith(("ERROR", "WARNING"))
    ]


def vulkan_errors(file: Path) -> list[str]:
    """What is wrong with one shader of Vulkan GLSL."""
    return [
        line
        for line in _run(["-V", "-C", "-o", os.devnull, str(file)]).splitlines()
        if "ERROR" in line
    ]


def bad_lines(file: Path) -> dict[int, str]:
    """Line numbers of one file with the error that is reported there."""
    matches = (_ERROR.match(line) for line in lines_of([file])[file])
    return {int(match[1]): match[2] for match in matches if match}


def _run(args: list[str]) -> str:
    assert TOOL is not None
    done = subprocess.run([TOOL, *args], capture_output=True, encoding="latin-1", check=False)
    assert done.returncode in (0, 2), done.stderr
    return done.stdout


PROBED = (
    *("float", "int", "uint", "bool"),
    *(f"{prefix}vec{n}" for prefix in ("", "i", "u", "b") for n in (2, 3, 4)),
    *("mat2", "mat2x3", "mat2x4", "mat3x2", "mat3", "mat3x4", "mat4x2", "mat4x3", "mat4"),
)
"""Types that :data:`PROBES` can tell apart."""

PROBES = "".join(
    f"struct sc_M_{t} {{ {t} v; }};\n"
    f"sc_M_{t} sc_id({t} v) {{ return sc_M_{t}(v); }}\n"
    f"{t} sc_{t}(sc_M_{t} m) {{ return m.v; }}\n"
    for t in PROBED
)
"""Functions for the probe ``sc_T(sc_id(e))``: ``e``, if its type is exactly T, else an error.

``sc_id`` has an overload for each type, which wins by exact match; the struct it returns converts
to nothing else.
"""


def probe(expression: str, kind: str) -> str:
    """An expression that only compiles if ``expression`` has exactly the type ``kind``."""
    return f"sc_{kind}(sc_id({expression}))"
