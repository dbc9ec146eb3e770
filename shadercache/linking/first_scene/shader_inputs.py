"""The attributes, uniforms and samplers that a pair of shaders wants to be given."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from shadercache.analysis.vertex_inputs import POSITION
from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.compiler import Analysis
from shadercache.lang.types import Type
from shadercache.linking.inputs_declared import inputs_declared
from shadercache.scene.object_inputs import root_of
from shadercache.transform.remove_dead import remove_dead


@dataclass(frozen=True, slots=True)
class Wanted:
    """An input by the user's name for it."""

    name: str
    type: Type

    @property
    def spelt(self) -> str:
        """Its type as GLSL writes it."""
        return str(self.type)


@dataclass(frozen=True, slots=True)
class ShaderInputs:
    """All that a pair of shaders wants, each once, in the order of declaration.

    ``placing``: what decides where vertices are.
    """

    attributes: tuple[Wanted, ...]
    uniforms: tuple[Wanted, ...]
    samplers: tuple[Wanted, ...]
    placing: frozenset[str] = frozenset()


def inputs_of(analysis: Analysis) -> ShaderInputs:
    """What an analysed pair of shaders wants."""
    uniforms = list(_distinct(analysis, "uniform"))
    used = _read_by_vertices(analysis)
    return ShaderInputs(
        tuple(wanted for wanted in _distinct(analysis, "in") if wanted.name in used),
        tuple(wanted for wanted in uniforms if not wanted.type.holds_opaque),
        tuple(wanted for wanted in uniforms if wanted.type.holds_opaque),
        _placing(analysis),
    )


def _placing(analysis: Analysis) -> frozenset[str]:
    if analysis.stage is None:
        return frozenset()
    old = {new: name for name, new in analysis.renamed.items()}
    sliced = remove_dead(analysis.stage.module, (POSITION,))
    return frozenset(old.get(name, name) for name in _names(sliced))


def _distinct(analysis: Analysis, word: str) -> Iterator[Wanted]:
    stages = analysis.raised if word == "uniform" else analysis.raised[1:]
    # Raised shaders have new names for some; the scene has the user's.
    old = {new: name for name, new in analysis.renamed.items()}
    known: set[str] = set()
    for name, kind in inputs_declared(stages, word, {}):
        root = root_of(name)
        told = old.get(root, root) + name[len(root) :]
        if told not in known:
            known.add(told)
            yield Wanted(told, kind)


def _read_by_vertices(analysis: Analysis) -> set[str]:
    """The names that decide where vertices are, or what the fragment shader reads of them."""
    if analysis.stage is None:
        return set()
    used = _names(analysis.program.module)
    read = {theirs.name for ours, theirs in analysis.stage.pairs if ours.name in used}
    old = {new: name for name, new in analysis.renamed.items()}
    named = _names(remove_dead(analysis.stage.module, (POSITION, *read)))
    return {old.get(name, name) for name in named}


def _names(module: n.Module) -> set[str]:
    return {node.name for node in walk(module) if isinstance(node, n.Name)}
