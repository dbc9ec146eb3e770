"""The same scene drawn into targets of another size, which shaders can read."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from shadercache.gpu.context import Gpu
from shadercache.render.bound_pass import BoundPass, plain_inputs
from shadercache.render.bundle import NO_NAMES, Bundle
from shadercache.render.pass_runners import OriginalRunner
from shadercache.render.render_scene import RenderScene
from shadercache.scene.description import Scene
from shadercache.scene.graphics_state import GraphicsState
from shadercache.source import Source

pytestmark = pytest.mark.xdist_group("gl")

SIZE, HALF = (96, 64), (48, 32)


@pytest.mark.parametrize(("row", "column"), [(0, 0), (0, 1), (1, 0), (1, 1)])
def test_a_smaller_picture_can_have_its_samples_upon_pixels_of_the_larger(
    gpu: Gpu, scene: Scene, bundle: Bundle, row: int, column: int
) -> None:
    """A shift of the picture to the right puts the samples further to the left on it."""
    places = ((0.25 - 0.5 * column, 0.25 - 0.5 * row),)
    with (
        RenderScene(gpu, scene, SIZE, "rgba32f") as world,
        world.drawn_apart(HALF, GraphicsState(places=places)) as apart,
        OriginalRunner(world, bundle) as whole,
        OriginalRunner(apart, bundle) as part,
    ):
        for frame in (0, 3):
            wanted = whole.image(frame)[row::2, column::2]
            found = part.image(frame)
            both = (found[..., 3] > 0) & (wanted[..., 3] > 0)
            assert np.mean(both != (wanted[..., 3] > 0)) < 0.01  # an edge through a pixel's centre
            assert np.abs(found - wanted)[both].max() < 1e-3
            # The pixel beside it shows something else.
            beside = whole.image(frame)[row::2, 1 - column :: 2]
            assert np.abs(found - beside)[both].max() > 0.01


def test_places_are_taken_in_turns_in_place_of_halton() -> None:
    engine = GraphicsState(jitter=4, places=((0.1, 0.2), (-0.3, 0.4)))
    assert [engine.shift(frame) for frame in range(3)] == [(0.1, 0.2), (-0.3, 0.4), (0.1, 0.2)]
    assert engine.jittered and GraphicsState(jitter=4).jittered and not GraphicsState().jittered
    assert replace(engine, places=()).shift(0) == GraphicsState(jitter=4).shift(0)


def test_what_it_draws_can_be_read_by_shaders_of_the_world(
    gpu: Gpu, scene: Scene, bundle: Bundle
) -> None:
    source = Source("depth.frag", (
        "#version 330\nuniform sampler2D u_depth;\nout vec4 o_color;\n"
        "void main() { o_color = vec4(texelFetch(u_depth, ivec2(gl_FragCoord.xy), 0).r, "
        "gl_FragCoord.z, 0.0, 1.0); }\n"
    ))  # fmt: skip
    with RenderScene(gpu, scene, SIZE, "rgba32f") as world:
        apart = world.drawn_apart(SIZE, scene.view.engine)
        with OriginalRunner(apart, bundle) as original:
            original.draw(2)
        view = world.seen_from(scene.view.camera, scene.view.camera_path)
        drawable = view.drawables[0]
        drawable.give("u_depth", apart.targets.depth_texture)
        spec = replace(bundle.original, fragment=source)
        bound = BoundPass(view, drawable, spec, NO_NAMES)
        view.begin()
        bound.draw(plain_inputs(view, drawable, 2), None)
        seen = world.targets.image()
        covered = seen[..., 3] > 0
        # Where two triangles overlap, the nearer is in the texture and in the picture.
        assert covered.any() and np.abs(seen[..., 0] - seen[..., 1])[covered].max() < 1e-6
        bound.release()
        assert world.drawables[0].texture("u_depth") is None, "it was given to the view alone"
        apart.release()
        with OriginalRunner(world, bundle) as original:
            assert original.image(2).any(), "the world is still there"
