"""A struct may have the name of a type that its version of GLSL lacks."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import pytest
from reports.in_scene import analysed, scene_of

from shadercache.gpu.context import Gpu
from shadercache.verify.verifier import Verifier
from tests.configured import PROOF, rewritten

FOLDER = Path(__file__).with_name("later_types")
PATHS = sorted(FOLDER.glob("*.frag"))
NAMED = pytest.mark.parametrize("path", PATHS, ids=lambda path: path.stem)


@NAMED
def test_variants_call_it_otherwise(path: Path) -> None:
    """Proof mode is of a later version, and the passes tell types by their names."""
    analysis = analysed(path)
    node = next(node for node in analysis.nodes if node.offered)
    for options in (None, PROOF):
        for text in rewritten(analysis, node, options).files.values():
            structs = [line.split()[1] for line in text.splitlines() if line.startswith("struct")]
            assert all(name == "f16vec2" or name.startswith("legacy_") for name in structs)


@pytest.mark.xdist_group("gl")
@NAMED
def test_the_laws_hold(path: Path, gpu: Gpu, cases_folder: Path) -> None:
    analysis = analysed(path)
    nodes = [node for node in analysis.nodes if node.offered]
    opened = scene_of(path, cases_folder), analysis
    with closing(Verifier(gpu, opened, (40, 40))) as verifier:
        every = [verifier.check(node, plain=False) for node in nodes]
    assert every
    assert not {item.text: item.failure or item.broken for item in every if item.broken}
