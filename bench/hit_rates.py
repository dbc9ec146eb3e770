"""Hit rates by frame of the scenes with several objects, with the options that change them.

``python -m bench.hit_rates --size 1024 -o DIR`` prints a table and writes a plot each.
Nothing is timed. Frames lie as far apart as they do in the scene; ``--frames`` shortens the path.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from shadercache.caching.configuration import Configuration, Refresh
from shadercache.files import write_bytes
from shadercache.gpu.context import open_context
from shadercache.linking.cache_settings import configured
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import open_scene
from shadercache.measure.measure import outcome_curves
from shadercache.measure.measurement import Curve
from shadercache.measure.subjects import subjects_of
from shadercache.paths import data_path
from shadercache.render.render_scene import RenderScene
from shadercache.report.plots import plot_curves

SCENES = ("heroine", "colonnade")
CHOICES = ("ids=on", "ids=on,filter=bilinear", "ids=on,filter=bilinear,fallback=on", "ids=off")


def curves_of(name: str, options: argparse.Namespace) -> dict[str, Curve]:
    """A curve for each of ``CHOICES``, over the scene's whole path or its first frames."""
    scene, analysis = open_scene(data_path("corpus", name, "scene.toml"))
    (node,) = scene.nodes.values()
    frames = min(scene.common.motion.frames, options.frames or scene.common.motion.frames)
    linker = Linker(scene, analysis)
    curves: dict[str, Curve] = {}
    base = Configuration((node,), refresh=Refresh(period=options.period))
    size = (options.size, options.size)
    with open_context() as gpu, RenderScene(gpu, linker.scene, size) as world:
        for choice in CHOICES:
            subjects = subjects_of(linker, choice, [configured(scene, base, [choice])])
            [curves[choice]] = outcome_curves(world, subjects, frames)
    return curves


def main() -> None:
    """Print the table, write the plots."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--frames", type=int)
    parser.add_argument("--period", type=int, default=32)
    parser.add_argument("-o", "--output", type=Path, default=Path("out/hit-rates"))
    options = parser.parse_args()
    for name in SCENES:
        curves = curves_of(name, options)
        title = f"{name}, {options.size} x {options.size}"
        write_bytes(options.output / f"{name}-{options.size}.png", plot_curves(title, curves))
        for choice, curve in curves.items():
            worst = min(curve.hit[1:])
            print(
                f"{title}, {choice}: hits {curve.hit_rate:.1%} (worst frame {worst:.1%}), "
                f"{curve.found_rate:.1%} of what was not due, burst {curve.burst:.1%}",
                flush=True,
            )


if __name__ == "__main__":
    main()
