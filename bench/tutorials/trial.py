"""One program: analysed, its best value rewritten, and that verified on this machine's driver."""

from __future__ import annotations

import subprocess
from collections.abc import Sequence
from contextlib import closing
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from bench.tutorials.programs import Program
from shadercache.analysed import Analysis
from shadercache.analysis.candidates import Candidate
from shadercache.analysis.refusals import Code
from shadercache.compiler import analyse
from shadercache.diagnostics import Diagnostic, InputError
from shadercache.gpu.context import Gpu, open_context
from shadercache.linking.first_scene.scene_text import Sources, first_scene
from shadercache.linking.made_scene import made_scene
from shadercache.linking.scene_shaders import open_scene, read_shader
from shadercache.scene.description import Scene
from shadercache.scene.models.load import load_model
from shadercache.verify.verdict import MAX_TIES, Verdict
from shadercache.verify.verifier import Verifier

TOOL = "glslangValidator"

_NO_VALUES = (Code.SIDE_EFFECT, Code.OPAQUE, Code.LVALUE, Code.ORDER)
"""Refusals of what is no value to begin with: assignments, samplers."""

EXACT, BROKEN, REFUSED, NOTHING = "exact", "broken", "refused", "nothing to cache"
LEFT_OUT, INVALID = "left out", "glslang rejects it"


@dataclass(frozen=True, slots=True)
class Outcome:
    """What became of a program. ``told``: code and sentence, or the laws that do not hold.

    ``offered``: is its best value offered, or cheaper than a fetch? ``scene``: what was drawn,
    ``ring``, ``sheet`` or ``full screen``.
    """

    name: str
    kind: str
    also: int = 0
    offered: bool = False
    scene: str = ""
    node: str = ""
    saves: float | None = None
    told: tuple[str, ...] = ()


def attempt(program: Program, folder: Path, models: Sequence[Path]) -> Outcome:
    """Try a program; its texts and its scene are written to the folder."""
    if program.between:
        why = "its inputs come from a geometry or tessellation shader"
        return Outcome(program.name, LEFT_OUT, program.also, told=(why,))
    if program.vertex is None:
        why = "no vertex shader beside it hands on what it reads"
        return Outcome(program.name, LEFT_OUT, program.also, told=(why,))
    folder.mkdir(parents=True, exist_ok=True)
    paths = folder / "shader.frag", folder / "shader.vert"
    for path, text in zip(paths, (program.fragment, program.vertex), strict=True):
        path.write_text(text, encoding="utf-8")
        rejected = _rejected(path)
        if rejected:
            return Outcome(program.name, INVALID, program.also, told=(rejected,))
    try:
        return _verified(program, *paths, models)
    except InputError as error:
        told = tuple(dict.fromkeys(map(_sentence, error.diagnostics)))
        # A shader without outputs has depth alone, and computes nothing.
        empty = {one.code for one in error.diagnostics} == {"SC403"}
        return Outcome(program.name, NOTHING if empty else REFUSED, program.also, told=told)


def _rejected(path: Path) -> str:
    done = subprocess.run([TOOL, str(path)], capture_output=True, text=True, check=False)
    lines = [line for line in done.stdout.splitlines() if line.startswith("ERROR")]
    return lines[0] if done.returncode and lines else ""


def _sentence(told: Diagnostic) -> str:
    hint = f" ({told.hint})" if told.hint else ""
    return f"{told.code} {told.message}{hint}"


def _verified(program: Program, fragment: Path, vertex: Path, models: Sequence[Path]) -> Outcome:
    analysis = analyse(read_shader(fragment), read_shader(vertex), None, "surface")
    for model in models:
        scene, opened, kind = _scene(fragment, vertex, model, analysis)
        best = _best(opened)
        if best is None:
            return Outcome(program.name, NOTHING, program.also, told=_why_nothing(opened))
        saves = opened.savings.of(best).share if best.offered else None
        about = program.also, best.offered, kind, best.id, saves
        try:
            with closing(Verifier(_gpu(), (scene, opened))) as verifier:
                references = verifier.references
                seen = references.covered[0].any() and references.ties <= MAX_TIES
                if seen or model is models[-1]:
                    return _outcome(program.name, verifier.check(best, plain=False), about)
        except InputError as error:
            told = tuple(map(_sentence, error.diagnostics))
            return Outcome(program.name, REFUSED, *about, told)
    raise AssertionError("there is a last model")


def _outcome(
    name: str, verdict: Verdict, about: tuple[int, bool, str, str, float | None]
) -> Outcome:
    told = (*verdict.reasons, *filter(None, [verdict.cause]))
    if verdict.broken:
        return Outcome(name, BROKEN, *about, told)
    # Algorithms that are refused are told where there is none left.
    refused = () if verdict.algorithms else tuple(dict.fromkeys(verdict.refused.values()))
    return Outcome(name, EXACT if verdict.algorithms else REFUSED, *about, told or refused)


def _best(analysis: Analysis) -> Candidate | None:
    """What saves most; of a shader where all is cheaper than a fetch, what costs most."""
    ranked = analysis.savings.ranked()
    if ranked:
        return ranked[0].node
    legal = [node for node in analysis.nodes if node.legal]
    return max(legal, key=lambda node: node.cost, default=None)


def _why_nothing(analysis: Analysis) -> tuple[str, ...]:
    """Why the dearest values are refused, each reason once."""
    dearest = sorted(analysis.nodes, key=lambda node: -node.cost)
    refusals = [node.refusal for node in dearest if node.refusal is not None]
    told = dict.fromkeys(
        f"{one.code.code} {one.code.sentence}" for one in refusals if one.code not in _NO_VALUES
    )
    return tuple(told)[:3]


def _scene(
    fragment: Path, vertex: Path, model: Path, analysis: Analysis
) -> tuple[Scene, Analysis, str]:
    """The model, turning; or a triangle over the picture, where nothing moves the vertices."""
    if not analysis.vertex_emitter.last_frame().twins:
        flat = analyse(analysis.fragment, analysis.vertex, None, "screen")
        return made_scene(fragment, flat, vertex), flat, "full screen"
    folder = fragment.parent
    text = first_scene(Sources(load_model(model), fragment, vertex), analysis, folder, folder).text
    (folder / "scene.toml").write_text(text, encoding="utf-8")
    return *open_scene(folder / "scene.toml"), model.stem


@cache
def _gpu() -> Gpu:
    return open_context()
