"""Nodes of one group have one value: their payloads are the same bits everywhere."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from shadercache.analysis.value_numbering import ValueGroup
from shadercache.gpu.context import Gpu
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import CoverageRunner
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import load_scene
from tests.altered import altered
from tests.configured import PROOF, rewritten, variant

from .cases import analysed

SIZE = (40, 40)
CASES = ("argument_side_effects", "copies", "overloads", "prototypes", "struct_parameters")
GROUPS = 4
MEMBERS = 4


def groups_of(name: str) -> list[ValueGroup]:
    """Groups with several nodes that can be cached, those with most of them first."""
    found = dict.fromkeys(analysed(name).groups.values())
    several = [group for group in found if sum(node.legal for node in group.nodes) > 1]
    return sorted(several, key=lambda group: -len(group.nodes))[:GROUPS]


def payloads(name: str, gpu: Gpu, folder: Path) -> dict[ValueGroup, list[np.ndarray]]:
    """The payload of some nodes of each group, as all fragments computed it."""
    scene = altered(load_scene(folder), fragment=folder / f"{name}.frag")
    found: dict[ValueGroup, list[np.ndarray]] = {}
    with RenderScene(gpu, scene, SIZE, color="rgba32f") as world:
        for group in groups_of(name):
            nodes = [node for node in group.nodes if node.legal]
            for node in nodes[:: max(1, len(nodes) // MEMBERS)]:
                options = PROOF
                emission = rewritten(analysed(name), node, options, unprofitable=True)
                bundle = Bundle(emission.manifest, emission.files)
                with CoverageRunner(world, bundle) as coverage:
                    covered = coverage.coverage(0)
                with variant(world, bundle, "3-pass", period=1) as runner:
                    runner.image(0)
                    found.setdefault(group, []).append(runner.cache()[covered].view(np.uint32))
    return found


@pytest.mark.xdist_group("gl")
@pytest.mark.parametrize("name", CASES)
def test_payloads_of_a_group_are_equal(name: str, gpu: Gpu, cases_folder: Path) -> None:
    found = payloads(name, gpu, cases_folder)
    assert found
    for group, images in found.items():
        texts = [node.text for node in group.nodes]
        assert len(images) > 1, texts
        assert all(np.array_equal(images[0], image) for image in images[1:]), texts
    firsts = {images[0].tobytes() for images in found.values()}
    assert len(firsts) > 1, "or everything is equal to everything"
