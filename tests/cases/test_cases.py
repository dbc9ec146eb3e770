"""Hand-written traps: what is offered of each, laws 1 to 4, and the reference compiler's word."""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import closing
from pathlib import Path
from random import Random

import pytest
from laws.random_sets import random_sets
from laws.slices import VARIABLE, amount, day_slice, seed

from shadercache.analysis.candidates import Candidate
from shadercache.caching.configuration import Mode
from shadercache.compiler import emit_original
from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from shadercache.verify.verifier import Verifier
from tests.conditioning import all_too_far
from tests.configured import configured, rewritten
from tests.conftest import Golden
from tests.glslang import needs_glslang, objections

from .cases import FOLDER, NAMES, analysed, golden_text, sources, told
from .scenery import scene_of

SIZE = (40, 40)
NODES = amount(2, 6)
"""Of each case; the slices of successive seeds cover all of them."""

MODES: tuple[Mode, ...] = ("plain", "proof")


def legal(name: str) -> list[Candidate]:
    return [node for node in told(name, analysed(name)) if node.legal]


def tried(name: str) -> list[tuple[Candidate, ...]]:
    """What is tried: some nodes, and a set of nodes."""
    sets, _ = random_sets(analysed(name), legal(name), Random(f"{seed()} {name}"), 1)
    return [*((node,) for node in day_slice(legal(name), seed(), NODES)), *sets]


def cacheable(name: str) -> bool:
    """Is the case one of which any value could be cached, or is it refused as a whole?"""
    try:
        analysed(name)
    except InputError:
        return False
    return True


CACHEABLE = [name for name in NAMES if cacheable(name)]


@pytest.mark.parametrize("name", NAMES)
def test_golden_nodes(name: str, golden: Golden) -> None:
    try:
        text = golden_text(name, analysed(name))
    except InputError as error:
        text = "".join(f"{item.render()}\n" for item in error.diagnostics)
    golden(FOLDER / f"{name}.txt", text)


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("name", CACHEABLE)
def test_laws_1_to_4(name: str, gpu: Gpu, cases_folder: Path) -> None:
    scene = scene_of(name, cases_folder)
    with closing(Verifier(gpu, (scene, analysed(name)), SIZE)) as verifier:
        found = verifier.round_trip()
        chosen = tried(name)
        verdicts = [verifier.check(nodes) for nodes in chosen]
        assert verifier.references.covered[0].mean() > 0.2
        es = analysed(name).program.module.profile == "es"  # may compute mediump in 16 bits
        far = {} if es else all_too_far(verifier, chosen, verdicts)
    assert found is not None and found.exact
    broken = {
        f"{item.path}: {item.text}": item.failure or item.broken for item in verdicts if item.broken
    }
    assert not broken, f"{VARIABLE}={seed()} repeats this"
    assert not far


@needs_glslang
@pytest.mark.parametrize("name", CACHEABLE)
def test_the_reference_compiler_says_no_more_than_of_the_original(
    name: str, tmp_path: Path
) -> None:
    analysis = analysed(name)
    shaders = {Path(source.name).suffix: source.text for source in sources(name)}
    accepted = _complaints([(f"user{suffix}", text) for suffix, text in shaders.items()], tmp_path)
    assert not any(line.startswith("ERROR") for line in accepted)
    texts = [item for mode in MODES for item in emit_original(analysis, mode).files.items()]
    for nodes in tried(name):
        for mode in MODES:
            emission = rewritten(analysis, nodes, configured(mode=mode), unprofitable=True)
            texts += emission.files.items()
    assert _complaints(texts, tmp_path) <= accepted, f"{VARIABLE}={seed()} repeats this"


def _complaints(texts: Iterable[tuple[str, str]], folder: Path) -> set[str]:
    """What glslang says of the shaders, without file and line: each text is judged alone."""
    heads = (line.partition("\n")[0].split(": ", 2) for line in objections(texts, folder))
    return {f"{word}: {rest[-1]}" for word, *rest in heads}
