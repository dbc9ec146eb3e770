"""A picture that moves with constant velocity: how old what is reused is, how much is renewed."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from shadercache.caching.configuration import Configuration
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.render.render_scene import RenderScene
from shadercache.render.variant_runner import VariantRunner

SHADER = Path(__file__).parent / "shaders" / "pan.frag"
NODE = "vec3(u_frame, gl_FragCoord.xy) * 1.0"


@dataclass(frozen=True)
class Ages:
    """What a run shows. ``mean`` age in frames over all pixels and frames, ``worst`` of any pixel,
    ``over``: share of pixels that are older than the period; ``refreshed``: share of the pixels
    that are refreshed in each frame, ``missed``: share that is not found."""

    mean: float
    worst: float
    over: float
    refreshed: tuple[float, ...]
    missed: float


@contextmanager
def pan(
    gpu: Gpu,
    velocity: tuple[float, float],
    configuration: Configuration,
    size: tuple[int, int] = (128, 128),
    moving: bool = True,
) -> Iterator[VariantRunner]:
    """The picture, with a runner of its two-pass variant in RGBA32F."""
    scene, analysis = open_scene(SHADER, mapping="user")
    constants = {**scene.common.inputs.constants, "u_velocity": velocity}
    inputs = replace(scene.common.inputs, constants=constants)
    scene = replace(scene, common=replace(scene.common, inputs=inputs))
    node = next(node for node in analysis.nodes if node.text == NODE)
    storage = replace(configuration.storage, format="rgba32f")
    linker = Linker(scene, analysis)
    chosen = replace(configuration, nodes=(node.id,), storage=storage)
    with (
        RenderScene(gpu, scene, size, "rgba32f") as world,
        VariantRunner(world, *linker.link(linker.assign(chosen)), moving=moving) as runner,
    ):
        yield runner


def ages(runner: VariantRunner, frames: int, warm: int | None = None) -> Ages:
    """Run for so many frames; those after ``warm`` (else three periods) count."""
    period = runner.configuration.refresh.period
    start = 3 * period if warm is None else warm
    values = runner.bundle.mask_values
    on_purpose = [values[name] for name in ("refresh", "old") if name in values]
    seen: list[NDArray[np.float32]] = []
    refreshed: list[float] = []
    missed: list[float] = []
    for frame in range(start + frames):
        if frame >= start:
            mask = runner.hit_mask(frame)
            refreshed.append(float(np.isin(mask, on_purpose).mean()))
            missed.append(float(1.0 - refreshed[-1] - (mask == values["hit"]).mean()))
        image = runner.image(frame)
        if frame >= start:
            # Red is the payload: the frame in which it was computed, blended as the filter blends.
            seen.append(frame - image[..., 0])
    every = np.stack(seen)
    return Ages(
        float(every.mean()),
        float(np.max(every)),
        float((every > period + 1e-3).mean()),
        tuple(refreshed),
        float(np.mean(missed)),
    )
