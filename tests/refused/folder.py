"""The refused cost of any folder of shaders (``./dev refused --static --shaders DIR``)."""

from __future__ import annotations

from collections.abc import Sequence
from multiprocessing import Pool
from os import cpu_count
from pathlib import Path
from typing import NamedTuple

from bench.public_shaders.reading import time_limit
from bench.public_shaders.shaders import Shader, folder_shaders
from shadercache.ast.large import allow_deep_trees
from shadercache.compiler import analyse
from shadercache.diagnostics import InputError, Severity
from shadercache.source import Source

from .offers import Refused, refused_cost


class Pair(NamedTuple):
    """A fragment shader, and the vertex shader that stands beside it under the same name."""

    fragment: Shader
    vertex: Shader | None

    @property
    def name(self) -> str:
        """What the pair is called in the table."""
        return self.fragment.name


class Outcome(NamedTuple):
    """What became of a pair: its refused cost, or the code of why it is refused as a whole."""

    name: str
    cost: Refused | None
    code: str = ""


def folder_costs(folder: Path, processes: int = cpu_count() or 1) -> list[Outcome]:
    """An outcome for every fragment shader below a folder."""
    with Pool(processes, allow_deep_trees) as pool:
        return pool.map(_outcome, pairs_of(folder_shaders(folder)), chunksize=4)


def pairs_of(shaders: Sequence[Shader]) -> list[Pair]:
    """The fragment shaders, each with its vertex shader where there is one."""
    found = {_stem(shader): shader for shader in shaders if shader.stage == "vertex"}
    return [Pair(item, found.get(_stem(item))) for item in shaders if item.stage == "fragment"]


def _stem(shader: Shader) -> str:
    return shader.name.rpartition(".")[0]


def _outcome(pair: Pair) -> Outcome:
    try:
        with time_limit():
            stages = (pair.fragment, pair.vertex) if pair.vertex is not None else (pair.fragment,)
            analysis = analyse(*(Source(shader.name, shader.text) for shader in stages))
            return Outcome(pair.name, refused_cost(analysis))
    except InputError as error:
        first = next(d for d in error.diagnostics if d.severity is Severity.ERROR)
        return Outcome(pair.name, None, first.code)
    except TimeoutError:
        return Outcome(pair.name, None, "too long")
