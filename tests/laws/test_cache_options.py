"""Laws 2 to 4 under the options of the cache, on shaders of the corpus: some every day, and all
with ``SHADERCACHE_STRESS=deep``."""

from __future__ import annotations

import os
import random
from contextlib import closing

import pytest
from laws.slices import seed

from shadercache.analysis.candidates import Candidate
from shadercache.caching.settings import with_settings
from shadercache.gpu.context import Gpu
from shadercache.linking.scene_shaders import open_scene
from shadercache.paths import data_path
from shadercache.verify.verifier import Verifier
from tests.configured import DEFAULT

pytestmark = pytest.mark.xdist_group("gl")

DEEP = os.environ.get("SHADERCACHE_STRESS") == "deep"

OPTIONS = (
    "filter=bilinear",
    "filter=bilinear,fallback",
    "filter=nearest",
    "filter=lanczos2",
    "filter=mitchell,fallback",
    "filter=carried",
    "filter=carried,depth=linear,guard=off",
    "filter=carried,age",
    "filter=carried,ids",
    "filter=carried,adaptive=0.02",
    "guard=off",
    "guard=clamp",
    "depth=linear,tolerance=akeley-su",
    "depth=ndc,filter=bilinear",
    "depth=ndc,filter=nearest,tolerance=akeley-su",
    "tolerance=fixed",
    "ids",
    "ids,filter=bilinear",
    "magnification,mask",
    "adaptive=0.02",
    "adaptive=1e-3,ids,filter=lanczos2,refresh=random",
    "age,filter=lanczos2,fallback",
    "age,ids",
    "age,ids,mask,magnification,fallback,filter=lanczos2,depth=linear,guard=miss",
)


@pytest.fixture(scope="module", params=["dragon", "trashcan"])
def nodes(request: pytest.FixtureRequest) -> tuple[str, list[Candidate]]:
    """Some offered nodes of a scene, others each night, that leave room for an age and an id."""
    _, analysis = open_scene(data_path("corpus", request.param, "scene.toml"))
    every = [node for node in analysis.nodes if node.offered and (node.type.components or 9) <= 5]
    pick = random.Random(seed())
    return request.param, pick.sample(every, 8 if DEEP else 1)


def _todays() -> tuple[str, ...]:
    """All, or in the short form others each night."""
    if DEEP:
        return OPTIONS
    return tuple(random.Random(seed()).sample(OPTIONS, 4))


@pytest.mark.parametrize("text", _todays())
def test_the_laws_hold(gpu: Gpu, nodes: tuple[str, list[Candidate]], text: str) -> None:
    name, chosen = nodes
    scene, analysis = open_scene(data_path("corpus", name, "scene.toml"))
    cached = with_settings(DEFAULT, [text])
    with closing(Verifier(gpu, (scene, analysis), (64, 64), configuration=cached)) as verifier:
        for node in analysis.nodes:
            if any(node.id == one.id for one in chosen):
                verdict = verifier.check(node, plain=False)
                assert not verdict.broken, f"{node.id}: {verdict.broken} {verdict.failure}"
