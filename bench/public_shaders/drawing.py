"""Law 1 on shaders of others: the text as it was and our print of it render the same bits.

Each valid fragment shader is linked with a plain vertex shader and drawn once from either text, by
a child process (``painter.py``). One that hangs or crashes with the driver costs one shader.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from multiprocessing import Pool
from pathlib import Path
from typing import Any

from bench.public_shaders.plain_vertex import plain_vertex
from bench.public_shaders.shaders import Shader
from shadercache.ast import nodes as n
from shadercache.ast.large import allow_deep_trees
from shadercache.ast.walk import walk
from shadercache.sema.facts import Facts
from shadercache.source import Source
from shadercache.valid.read import read

ROOT = Path(__file__).resolve().parent.parent.parent

# Mesa runs the oldest shaders in a compatibility profile only; others take no notice of these.
ENVIRONMENT = {
    "MESA_GL_VERSION_OVERRIDE": "4.6COMPAT",
    "MESA_GLSL_VERSION_OVERRIDE": "460",
    "MESA_SHADER_CACHE_DISABLE": "true",
    "LP_NUM_THREADS": "1",
}
BATCH = 50

_FIXED_FUNCTION = re.compile(r"\bgl_(?:TexCoord|Color|SecondaryColor)\b")
_INTEGERS = re.compile(r"\b(?:int|uint|bool|[iub]vec[234])\b")
_TARGETS = 8

Job = dict[str, Any]


@dataclass(frozen=True, slots=True)
class Picture:
    """What became of drawing a shader: ``same`` is ``None`` where it cannot be drawn at all.

    ``varied``: the image has more than one colour.
    """

    same: bool | None
    varied: bool = False
    why: str = ""


def draw_all(pairs: Sequence[tuple[Shader, str]], processes: int) -> list[Picture]:
    """A picture for each shader with our print of it."""
    with Pool(processes, allow_deep_trees) as pool:
        jobs = pool.map(_job, pairs, chunksize=8)
    batches = [jobs[at : at + BATCH] for at in range(0, len(jobs), BATCH)]
    with ThreadPoolExecutor(processes) as threads:
        return [picture for found in threads.map(_draw, batches) for picture in found]


def _draw(jobs: Sequence[Job]) -> list[Picture]:
    """Where the child ends early, the job it was at is lost, and a new one goes on behind it."""
    pictures: list[Picture] = []
    while len(pictures) < len(jobs):
        done = subprocess.run(
            [sys.executable, "-m", "bench.public_shaders.painter"],
            input="".join(json.dumps(job) + "\n" for job in jobs[len(pictures) :]),
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            cwd=ROOT,
            env=os.environ | ENVIRONMENT,
            check=False,
        )
        pictures += [Picture(**json.loads(line)) for line in done.stdout.splitlines()]
        if len(pictures) < len(jobs):
            pictures.append(Picture(None, why="the driver hangs or crashes"))
    return pictures


def _job(pair: tuple[Shader, str]) -> Job:
    """What a child is asked; with ``why`` alone where there is nothing to ask."""
    shader, printed = pair
    try:
        module, facts = read(Source(shader.file, shader.text), "fragment")
        vertex = plain_vertex(module, facts, bool(_FIXED_FUNCTION.search(shader.text)))
    except Exception as error:
        return {"why": f"no vertex shader: {type(error).__name__}: {error}"}
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
                kind = facts.declared[declarator].type
                location = _location(decl.qualifiers, facts)
                first = free if location is None else location
                free = first + (kind.dims[0] or 1 if kind.is_array else 1)
                for at in range(first, min(free, _TARGETS)):
                    kinds[at] = {"int": "i", "uint": "u"}.get(kind.base or "", "f")
    return "".join(kinds)


def _location(qualifiers: n.Qualifiers, facts: Facts) -> int | None:
    for item in qualifiers.layout or ():
        if item.name == "location" and item.value is not None:
            value = facts.constants.get(item.value)
            return None if value is None else int(value)
    return None


def _has_integers(node: n.Node) -> bool:
    if not isinstance(node, n.BlockDecl | n.StructDef):
        return False
    return any(
        _INTEGERS.search(field.type.name)
        or (isinstance(node, n.BlockDecl) and field.type.struct is not None)
        for field in node.fields
    )
