"""The judge: what glslangValidator says of many shaders, asked in few processes."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path
from typing import NamedTuple

from bench.public_shaders.shaders import Shader, write_shaders

TOOL = "glslangValidator"
BATCH = 100

_ERROR = re.compile(r"ERROR: (?:[^:]*):(\d+): (.*)")


class Verdict(NamedTuple):
    """``line`` is 0 where the shader is taken, or where the judge names no line."""

    accepted: bool
    line: int = 0
    message: str = ""


def judge(shaders: Sequence[Shader], folder: Path) -> list[Verdict]:
    """A verdict for each shader. The files are written to the folder, and stay there."""
    write_shaders(shaders, folder)
    batches = [shaders[at : at + BATCH] for at in range(0, len(shaders), BATCH)]
    with ThreadPoolExecutor(2) as pool:
        return [verdict for found in pool.map(partial(_ask, folder), batches) for verdict in found]


def _ask(folder: Path, shaders: Sequence[Shader]) -> list[Verdict]:
    command = [TOOL, "-d", *(shader.file for shader in shaders)]
    done = subprocess.run(command, cwd=folder, capture_output=True, errors="replace", check=False)
    if done.returncode not in (0, 2):  # A file makes it crash.
        if len(shaders) == 1:
            return [Verdict(False, 0, "the judge crashed")]
        return [verdict for one in shaders for verdict in _ask(folder, [one])]
    sections: dict[str, list[str]] = {shader.file: [] for shader in shaders}
    lines: list[str] = []
    for line in done.stdout.splitlines():  # It names each file on a line of its own.
        lines = sections.get(line, lines)
        lines.append(line)
    return [_verdict(sections[shader.file]) for shader in shaders]


def _verdict(lines: list[str]) -> Verdict:
    errors = [line for line in lines if line.startswith("ERROR")]
    if not errors:
        return Verdict(True)
    first = _ERROR.match(errors[0])
    return Verdict(False, int(first[1]), first[2]) if first else Verdict(False, 0, errors[0])
