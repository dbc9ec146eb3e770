"""The judge: what glslangValidator says of many shaders, asked in few processes and remembered."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

from bench.public_shaders.collection import Shader, write_shaders
from bench.public_shaders.packages import FetchError

TOOL = "glslangValidator"
BATCH = 100

_ERROR = re.compile(r"ERROR: (?:[^:]*):(\d+): (.*)")


class Verdict(NamedTuple):
    """``line`` is 0 where the shader is taken, or where the judge names no line."""

    accepted: bool
    line: int = 0
    message: str = ""


class Judge:
    """Verdicts by shader; those of earlier runs come from ``memory``."""

    def __init__(self, folder: Path, memory: Path) -> None:
        if shutil.which(TOOL) is None:
            raise FetchError(f"{TOOL} is the judge, and it is not installed (glslang-tools)")
        self.folder = folder
        self._memory = memory
        self._version = _run([TOOL, "--version"]).stdout
        self._known: dict[str, Verdict] = self._read()

    def judge(self, shaders: Sequence[Shader]) -> list[Verdict]:
        """A verdict for each shader. The files are written to the judge's folder."""
        new = [shader for shader in shaders if shader.key not in self._known]
        write_shaders(shaders, self.folder)
        with ThreadPoolExecutor(2) as pool:
            for found in pool.map(self._ask, _batches(new)):
                self._known |= found
        if new:
            self._write()
        return [self._known[shader.key] for shader in shaders]

    def _ask(self, shaders: Sequence[Shader]) -> dict[str, Verdict]:
        done = _run([TOOL, "-d", *(shader.file for shader in shaders)], self.folder)
        names = {shader.file for shader in shaders}
        if done.returncode in (0, 2):
            sections = _sections(done.stdout, names)  # One file alone that is right has none.
            return {shader.key: _verdict(sections.get(shader.file, [])) for shader in shaders}
        if len(shaders) == 1:
            return {shaders[0].key: Verdict(False, 0, "the judge crashed")}
        return {key: verdict for one in shaders for key, verdict in self._ask([one]).items()}

    def _read(self) -> dict[str, Verdict]:
        try:
            stored = json.loads(self._memory.read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return {}
        if stored.get("judge") != self._version:
            return {}
        return {key: Verdict(*verdict) for key, verdict in stored["verdicts"].items()}

    def _write(self) -> None:
        self._memory.parent.mkdir(parents=True, exist_ok=True)
        stored = {"judge": self._version, "verdicts": self._known}
        self._memory.write_text(json.dumps(stored), encoding="utf-8")


def _batches(shaders: Sequence[Shader]) -> Iterator[Sequence[Shader]]:
    return (shaders[at : at + BATCH] for at in range(0, len(shaders), BATCH))


def _run(command: list[str], folder: Path | None = None) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        command, cwd=folder, capture_output=True, text=True, errors="replace", check=False
    )


def _sections(text: str, names: set[str]) -> dict[str, list[str]]:
    """The judge's lines by file; it names each file on a line of its own."""
    sections: dict[str, list[str]] = {}
    current: list[str] = []
    for line in text.splitlines():
        if line in names:
            current = sections[line] = []
        else:
            current.append(line)
    return sections


def _verdict(lines: list[str]) -> Verdict:
    errors = [line for line in lines if line.startswith("ERROR")]
    if not errors:
        return Verdict(True)
    first = _ERROR.match(errors[0])
    return Verdict(False, int(first[1]), first[2]) if first else Verdict(False, 0, errors[0])
