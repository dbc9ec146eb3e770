"""Law 1 on shaders of others: the text as it was and our print of it render the same bits.

Each valid fragment shader is linked with a plain vertex shader and drawn once from either text, by
a child process: one that hangs or crashes with the driver costs one shader, no more.
"""

from __future__ import annotations

import json
import os
import re
import selectors
import subprocess
import sys
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing import Pool
from pathlib import Path
from queue import SimpleQueue
from typing import Any

from bench.public_shaders.collection import Shader
from bench.public_shaders.plain_vertex import plain_vertex
from shadercache.ast import nodes as n
from shadercache.ast.large import allow_deep_trees
from shadercache.ast.walk import walk
from shadercache.sema.facts import Facts
from shadercache.source import Source
from shadercache.valid.read import read

ROOT = Path(__file__).resolve().parent.parent.parent
SECONDS = 20
"""A shader that takes longer hangs."""

# Mesa runs the oldest shaders in a compatibility profile only; others take no notice of these.
ENVIRONMENT = {
    "MESA_GL_VERSION_OVERRIDE": "4.6COMPAT",
    "MESA_GLSL_VERSION_OVERRIDE": "460",
    "MESA_SHADER_CACHE_DISABLE": "true",
    "LP_NUM_THREADS": "1",
}

_FIXED_FUNCTION = re.compile(r"\bgl_(?:TexCoord|Color|SecondaryColor)\b")
_INTEGERS = re.compile(r"\b(?:int|uint|bool|[iub]vec[234])\b")
_TARGETS = 8


@dataclass(frozen=True, slots=True)
class Picture:
    """What became of drawing a shader: ``same`` is ``None`` where it cannot be drawn at all.

    ``varied``: the image has more than one colour.
    """

    same: bool | None
    varied: bool = False
    why: str = ""


def render_all(pairs: Sequence[tuple[Shader, str]], processes: int) -> list[Picture]:
    """A picture for each shader with our print of it."""
    with Pool(processes, allow_deep_trees) as pool:
        jobs = pool.map(_job, pairs, chunksize=8)
    idle: SimpleQueue[_Child] = SimpleQueue()
    children = [_Child() for _ in range(processes)]
    for child in children:
        idle.put(child)

    def render(job: dict[str, Any] | str) -> Picture:
        if isinstance(job, str):
            return Picture(None, why=job)
        child = idle.get()
        try:
            return child.ask(job)
        finally:
            idle.put(child)

    try:
        with ThreadPoolExecutor(processes) as threads:
            return list(threads.map(render, jobs))
    finally:
        for child in children:
            child.stop()


def _job(pair: tuple[Shader, str]) -> dict[str, Any] | str:
    """What to ask a child for, or why nothing can be asked."""
    shader, printed = pair
    try:
        module, facts = read(Source(shader.file, shader.text), "fragment")
        vertex = plain_vertex(module, facts, bool(_FIXED_FUNCTION.search(shader.text)))
    except Exception as error:
        return f"no vertex shader: {type(error).__name__}: {error}"
    return {
        "vertex": vertex,
        "fragments": [shader.text, printed],
        "formats": output_formats(module, facts),
        "integers": any(_has_integers(node) for node in walk(module)),
    }


def output_formats(module: n.Module, facts: Facts) -> str:
    """The kind of each target: ``f``, ``i`` or ``u`` for floats, signed and unsigned integers."""
    kinds = ["f"] * _TARGETS
    free = 0
    for decl in module.decls:
        if isinstance(decl, n.VarDecl) and decl.qualifiers.has("out"):
            for declarator in decl.declarators:
                symbol = facts.declared[declarator]
                location = _location(decl.qualifiers, facts)
                first = free if location is None else location
                size = symbol.type.dims[0] or 1 if symbol.type.is_array else 1
                free = first + size
                for at in range(first, min(free, _TARGETS)):
                    kinds[at] = {"int": "i", "uint": "u"}.get(symbol.type.base or "", "f")
    return "".join(kinds)


def _location(qualifiers: n.Qualifiers, facts: Facts) -> int | None:
    for item in qualifiers.layout or ():
        if item.name == "location" and item.value is not None:
            value = facts.constants.get(item.value)
            return None if value is None else int(value)
    return None


def _has_integers(node: n.Node) -> bool:
    if isinstance(node, n.BlockDecl):
        return any(_INTEGERS.search(field.type.name) or field.type.struct for field in node.fields)
    return isinstance(node, n.StructDef) and any(
        _INTEGERS.search(field.type.name) for field in node.fields
    )


class _Child:
    """A process that draws, started anew when it has died or been given up."""

    def __init__(self) -> None:
        self._process: subprocess.Popen[str] | None = None

    def ask(self, job: dict[str, Any]) -> Picture:
        process = self._running()
        try:
            assert process.stdin is not None
            process.stdin.write(json.dumps(job) + "\n")
            process.stdin.flush()
            line = self._answer(process)
        except OSError:
            line = ""
        if not line:
            self.stop()
            return Picture(None, why="the driver hangs or crashes")
        return Picture(**json.loads(line))

    def stop(self) -> None:
        """End the process."""
        if self._process is not None:
            self._process.kill()
            with suppress(OSError), self._process:  # Closes the pipes; one may hold an old job.
                pass
            self._process = None

    def _running(self) -> subprocess.Popen[str]:
        if self._process is None:
            self._process = subprocess.Popen(
                [sys.executable, "-m", "bench.public_shaders.painter"],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                text=True,
                cwd=ROOT,
                env=os.environ | ENVIRONMENT,
            )
        return self._process

    @staticmethod
    def _answer(process: subprocess.Popen[str]) -> str:
        """The next line, or nothing if there is none in time."""
        assert process.stdout is not None
        with selectors.DefaultSelector() as selector:
            selector.register(process.stdout, selectors.EVENT_READ)
            return process.stdout.readline() if selector.select(SECONDS) else ""
