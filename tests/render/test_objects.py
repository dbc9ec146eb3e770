"""Scenes of several objects: one frame, one depth buffer, one cache, each object by its shaders."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from shadercache.caching.configuration import Configuration
from shadercache.compiler import Analysis
from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.measure.subjects import subjects_of
from shadercache.render.bundle import Bundle
from shadercache.render.pass_runners import CoverageRunner, OriginalRunner, render_original
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Caching, Scene, load_scene
from shadercache.verify.verifier import Verifier
from tests.altered import altered
from tests.configured import (
    PROOF,
    bundled,
    originals,
    render_variant,
    variant,
)

pytestmark = pytest.mark.xdist_group("gl")

ALGORITHMS = ("1-pass", "2-pass", "3-pass")
NODE = "main.0-7a71c60a"  # bands(v_position)
SIZE = (96, 80)


@pytest.fixture(scope="module")
def folder(scene_folder: Path) -> Path:
    return scene_folder / "objects"


@pytest.fixture(scope="module")
def opened(folder: Path) -> tuple[Scene, Analysis]:
    return open_scene(folder / "scene.toml")


@pytest.fixture(scope="module")
def proof(opened: tuple[Scene, Analysis]) -> Bundle:
    return bundled(opened[1], opened[1].node(NODE), PROOF, unprofitable=True)


@pytest.fixture(scope="module")
def crowd(gpu: Gpu, opened: tuple[Scene, Analysis]) -> Iterator[RenderScene]:
    with RenderScene(gpu, opened[0], SIZE, "rgba32f") as made:
        yield made


def same_bits(one: np.ndarray, other: np.ndarray) -> bool:
    return one.tobytes() == other.tobytes()


def test_what_the_file_says(opened: tuple[Scene, Analysis]) -> None:
    turning, drifting, bent, plain = opened[0].objects
    assert [item.own_shader for item in opened[0].objects] == [False, False, True, False]
    assert [item.caching.on for item in opened[0].objects] == [True, True, True, False]
    assert bent.caching == Caching(node="main.0-477e72fd", period=3, block=2)
    assert "u_tint" in drifting.inputs.animated and "u_tint" not in drifting.inputs.constants
    assert "u_tint" in turning.inputs.constants
    assert [turning.cull, drifting.cull] == [False, True]
    assert plain.motion.place(3) == (0.2, -0.5, 0.5)
    assert plain.motion.place(4) == (-0.4, -0.5, 0.8)
    assert [bent.motion.is_there(frame) for frame in (0, 2, 3, 4, 5)] == [
        True, True, False, False, True,
    ]  # fmt: skip


def test_the_laws_hold_for_all_objects_together(gpu: Gpu, opened: tuple[Scene, Analysis]) -> None:
    scene, analysis = opened
    with closing(Verifier(gpu, (scene, analysis))) as verifier:
        exact = verifier.round_trip()
        assert exact is not None and exact.exact
        verdict = verifier.check(analysis.node(NODE))
        assert not verdict.broken, verdict
        assert verdict.algorithms == set(ALGORITHMS)


def test_a_scene_of_which_nothing_may_be_cached(gpu: Gpu, opened: tuple[Scene, Analysis]) -> None:
    """Whether or not objects with shaders of their own may."""
    scene, analysis = opened
    plain = [altered(item, on=item.own_shader) for item in scene.objects]
    for objects in (plain, [item for item in plain if not item.own_shader]):
        off = replace(scene, objects=tuple(objects))
        with (
            closing(Verifier(gpu, (off, analysis))) as verifier,
            pytest.raises(InputError, match="SC542"),
        ):
            verifier.check(analysis.node(NODE))
        with pytest.raises(InputError, match="SC542"):
            subjects_of(Linker(off, analysis), "bands", [Configuration(nodes=(NODE,))])


@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_every_object_reuses_something(crowd: RenderScene, proof: Bundle, algorithm: str) -> None:
    """Each alone differs from its original in motion, and only where it is cached."""
    for item in crowd.scene.objects:
        alone = replace(crowd.scene, objects=(item,))
        with RenderScene(crowd.gpu, alone, SIZE, "rgba32f") as world:
            original = render_original(world, originals(world.scene, proof), range(6))
            cached = render_variant(world, proof, algorithm, range(6), period=16)
        same = [same_bits(*pair) for pair in zip(original, cached, strict=True)]
        assert same[0], "the first frame is a reset"
        assert all(same) == (not item.caching.on), (item.name, same)


@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_the_order_of_objects_changes_nothing(
    crowd: RenderScene, proof: Bundle, algorithm: str
) -> None:
    """Also of cached and uncached objects, and of those by one shader and another."""
    turned = replace(crowd.scene, objects=crowd.scene.objects[::-1])
    with (
        RenderScene(crowd.gpu, turned, SIZE, "rgba32f") as other,
        CoverageRunner(crowd, *originals(crowd.scene, proof)) as cover,
    ):
        options = {"period": 5}
        with (
            variant(crowd, proof, algorithm, **options) as one,
            variant(other, proof, algorithm, **options) as two,
        ):
            for frame in range(8):
                ties = cover.ties(frame)
                assert ties.mean() < 1e-3
                assert same_bits(one.image(frame)[~ties], two.image(frame)[~ties]), frame


def test_objects_that_are_not_there_are_not_drawn(crowd: RenderScene, proof: Bundle) -> None:
    assert [len(crowd.drawn(frame)) for frame in (0, 2, 3, 4, 5)] == [4, 4, 3, 3, 4]
    with variant(crowd, proof, "2-pass", period=16) as runner:
        images = [runner.image(frame) for frame in range(5)]
        mask = runner.hit_mask(5)
        image = runner.image(5)
    assert len(images) == 5
    # What is back finds nothing of its own in the cache: its frame is the original's.
    (bent,) = (item for item in crowd.scene.objects if item.name == "bent")
    alone = replace(crowd.scene, objects=(bent,))
    with (
        RenderScene(crowd.gpu, alone, SIZE, "rgba32f") as world,
        OriginalRunner(world, *originals(world.scene, proof)) as shown,
    ):
        original = shown.image(5)
    seen = (image == original).all(-1) & (original[..., 3] > 0)
    assert seen.sum() > 150
    assert not (mask[seen] == proof.mask_values["hit"]).any()


def test_objects_outside_of_the_picture_are_not_drawn(
    gpu: Gpu, crowd: RenderScene, proof: Bundle
) -> None:
    turning = crowd.scene.objects[0]
    seen = []
    for x in np.linspace(-6.0, 6.0, 25):
        scene = altered(crowd.scene, target=(float(x), 0.0, 0.0), objects=(turning,))
        with RenderScene(gpu, scene, SIZE, "rgba32f") as world:
            drawn = bool(world.drawn(0))
            world.culling = False
            with CoverageRunner(world, *originals(world.scene, proof)) as runner:
                covered = runner.coverage(0).any()
        assert drawn or not covered, x
        seen.append(drawn)
    assert 5 <= sum(seen) < 20


def test_jitter_brings_in_what_lies_just_outside(gpu: Gpu, crowd: RenderScene) -> None:
    turning = crowd.scene.objects[0]

    def drawn(x: float, *places: tuple[float, float]) -> bool:
        scene = altered(crowd.scene, target=(x, 0.0, 0.0), objects=(turning,), places=places)
        with RenderScene(gpu, scene, SIZE) as world:
            return bool(world.drawn(0))

    inside, outside = 0.0, 6.0
    for _ in range(20):
        middle = (inside + outside) / 2.0
        inside, outside = (middle, outside) if drawn(middle) else (inside, middle)
    assert drawn(inside) and not drawn(outside)
    # It stands to the left of the camera, so a shift to the right brings it in.
    assert drawn(outside, (0.45, 0.0)) and not drawn(inside, (-0.45, 0.0))


@pytest.mark.parametrize("algorithm", ALGORITHMS)
def test_what_begins_anew_finds_nothing_in_the_cache_of_others(
    crowd: RenderScene, proof: Bundle, algorithm: str
) -> None:
    """A surface of the same depth was there, of an object with other values."""
    (whole,) = render_original(crowd, originals(crowd.scene, proof), [0], moving=False)[:1]
    options = {"period": 32, "moving": False, "block": 4}
    with variant(crowd, proof, algorithm, **options) as runner:
        assert same_bits(runner.image(0), whole)
        other = runner.cache().copy()
        other[..., :1] += 0.25
        runner.restore(other, 0)
        assert not same_bits(runner.image(1), whole), "nothing was there to be found"
        runner.restore(other, 0)
        for role in runner.roles:
            role.before = None
        assert same_bits(runner.image(1), whole)


def test_uncached_objects_leave_the_cache_alone(crowd: RenderScene, proof: Bundle) -> None:
    """Behind and in front of what is cached: what a texel holds is of a cached object, or empty."""
    plain = crowd.scene.objects[-1]
    alone = replace(crowd.scene, objects=(plain,))
    with (
        RenderScene(crowd.gpu, alone, SIZE, "rgba32f") as world,
        variant(world, proof, "2-pass") as runner,
    ):
        assert runner.image(0).any()
        assert (runner.cache() == proof.cache.clear[0]).all()
        assert not runner.hit_mask(1).any()


def test_one_cache_for_texels_that_are_alike(crowd: RenderScene, proof: Bundle) -> None:
    with variant(crowd, proof, "3-pass") as runner:
        assert len({id(role.caches) for role in runner.roles if role.caches}) == 1


def test_the_bones_of_the_last_frame_are_the_twin(crowd: RenderScene, proof: Bundle) -> None:
    """With them the skinned ring hits nearly everywhere; without, its swinging half misses."""
    (bent,) = (item for item in crowd.scene.objects if item.name == "bent")
    still = altered(bent, motion=crowd.scene.common.motion, period=None)
    rates = []
    for swap in (False, True):
        scene = replace(crowd.scene, objects=(still,))
        with (
            RenderScene(crowd.gpu, scene, (160, 160), "rgba32f") as world,
            variant(world, proof, "2-pass", period=65535) as runner,
        ):
            bundle = runner.roles[0].bundle
            assert bundle.manifest.previous["u_bones"].endswith("previous_u_bones")
            found = []
            for frame in range(4):
                if frame:
                    if swap:
                        runner.roles[0].before = frame
                    mask = runner.hit_mask(frame)
                    found.append((mask == bundle.mask_values["hit"]).sum() / (mask > 0).sum())
                runner.draw(frame)
            rates.append(float(np.mean(found)))
    assert rates[0] > 0.9 and rates[1] < rates[0] - 0.1, rates


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ('name = "plain"', 'name = "bent"', "names of their own"),
        ("bounds = [[-1.2", "bounds = [[2.2", "two corners of a box"),
        ('node = "cells"', "", ""),
        ("cached = false", 'node = "cells"', "only with its own shader"),
        ("visible = [[0, 3]", "visible = [[3, 0]", "pairs of frames"),
        ("scale = 0.6", "scale = 0.0", "scale must be above zero"),
        ("rate = 0.5", "rat = 0.5", "unknown key objects[2].uniforms.u_bones.rat"),
        ("per_frame = [0.0, 0.02, 0.02]", "per_frame = 1.0", "as many numbers in each"),
        ("[camera.path]", "[camera.path]\nkeys = [{frame = 3, eye = [0, 0, 1]}]", "not both"),
    ],
)  # fmt: skip
def test_one_mistake(folder: Path, old: str, new: str, words: str) -> None:
    text = (folder / "scene.toml").read_text()
    assert old in text
    path = folder / "broken.toml"
    path.write_text(text.replace(old, new, 1))
    if not words:
        assert not load_scene(path).objects[2].caching.on
        return
    with pytest.raises(InputError) as caught:
        load_scene(path)
    (found,) = caught.value.diagnostics
    assert words in found.message


def test_mistakes_stand_at_their_object(folder: Path) -> None:
    text = (folder / "scene.toml").read_text()
    path = folder / "broken.toml"
    path.write_text(text.replace("scale = 0.6", "scale = 0.0"))
    with pytest.raises(InputError) as caught:
        load_scene(path)
    line = text.splitlines().index("scale = 0.6") + 1
    assert f"broken.toml:{line}:" in caught.value.diagnostics[0].render()
