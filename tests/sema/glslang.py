"""glslangValidator as a second opinion on GLSL."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Iterable, Mapping
from pathlib import Path

TOOL = shutil.which("glslangValidator")

_ERROR = re.compile(r"ERROR: (?:0|[^:]*):(\d+): (.*)")


def errors_of(files: Iterable[Path]) -> Mapping[Path, list[str]]:
    """The errors of each file, judged alone."""
    by_name = {str(file): file for file in files}
    found: dict[Path, list[str]] = {file: [] for file in by_name.values()}
    current: Path | None = None
    for line in _run([*by_name]).splitlines():
        if line in by_name:
            current = by_name[line]
        elif current is not None and line.startswith("ERROR"):
            found[current].append(line)
    return found


def bad_lines(file: Path) -> dict[int, str]:
    """Line numbers of one file with the error that is reported there."""
    matches = (_ERROR.match(line) for line in _run(["-C", str(file)]).splitlines())
    return {int(found[1]): found[2] for found in matches if found}


def _run(args: list[str]) -> str:
    assert TOOL is not None
    done = subprocess.run([TOOL, *args], capture_output=True, text=True, check=False)
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
