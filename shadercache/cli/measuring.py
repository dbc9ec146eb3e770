"""What ``run``, ``bench`` and ``demo`` share: the measurement, and the table of its results."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from shadercache.cli.options import PictureOptions, parse_size
from shadercache.cli.progress import progress
from shadercache.cli.tables import format_table

if TYPE_CHECKING:
    from shadercache.linking.linker import Linker
    from shadercache.measure.measurement import (
        CachingGain,
        Measurement,
        MeasureOptions,
        NodeResult,
        VariantResult,
    )
    from shadercache.measure.subjects import VariantSubject

_FIGURES: Mapping[str, Callable[[VariantResult], str]] = {
    "time ms": lambda variant: f"{variant.timing.median * 1e3:.1f}",
    "p95/p99": lambda variant: f"{variant.timing.p95 * 1e3:.0f}/{variant.timing.p99 * 1e3:.0f}",
    "reset": lambda variant: f"{variant.reset:.2f}x",
    "ratio": lambda variant: f"{variant.speedup.median:.2f}x",
    "interval": lambda variant: f"{variant.speedup.low:.2f}-{variant.speedup.high:.2f}",
    "hits": lambda variant: f"{variant.hit_rate:.1%}",
    "RMSE": lambda variant: f"{variant.error.rmse:.4f}",
    "PSNR dB": lambda variant: f"{variant.error.psnr:.1f}" if variant.error.rmse else "exact",
    "floor ms": lambda variant: "" if variant.floor is None else f"{variant.floor * 1e3:.1f}",
    "eff.": lambda variant: "" if variant.efficiency is None else f"{variant.efficiency:.2f}",
}
"""Columns of the table of results, and what stands in them for a variant."""

FIGURES = tuple(_FIGURES)
FEW_FIGURES = ("time ms", "ratio", "interval", "hits", "RMSE", "PSNR dB")
"""The figures that a first look needs."""


def measured(
    linker: Linker,
    subjects: Sequence[VariantSubject],
    how: MeasureOptions,
    drawn: PictureOptions,
    label: str,
) -> tuple[Measurement, dict[str, Any]]:
    """Measure the subjects of a scene, and say where. ``label`` is what the progress is called."""
    from shadercache.gpu.context import open_context
    from shadercache.linking.user_places import at_home
    from shadercache.measure.measure import measure
    from shadercache.measure.result_files import environment
    from shadercache.render.render_scene import RenderScene
    from shadercache.scene.mesh import replacement_mesh

    mesh = replacement_mesh(linker.scene, drawn.mesh)
    with (
        open_context() as gpu,
        at_home(linker.analysis),
        RenderScene(gpu, linker.scene, parse_size(drawn.size), mesh=mesh) as world,
        _steps(label) as tell,
    ):
        results = measure(world, linker.originals(), subjects, how, tell)
        return results, environment(gpu)


@contextmanager
def _steps(label: str) -> Iterator[Callable[[int, int, str], None]]:
    """Progress in steps that a measurement counts for itself."""
    # In thousandths, since how many steps there are is only known with the first call.
    with progress(label, 1000) as advance:
        shown = 0

        def tell(done: int, total: int, _: str) -> None:
            nonlocal shown
            reached = 1000 * done // max(1, total)
            advance(reached - shown)
            shown = reached

        yield tell


def result_table(
    measurement: Measurement,
    label: Callable[[NodeResult], str],
    figures: Sequence[str] = FIGURES,
) -> str:
    """All variants of all nodes, nodes in ascending P/T, as text."""
    rows = []
    for node in sorted(measurement.nodes, key=lambda node: node.ratio or 0.0):
        head = (label(node), "" if node.ratio is None else f"{node.ratio:.3f}")
        for variant in node.variants:
            name = measurement.name(variant.configuration)
            rows.append((*head, name, *(_FIGURES[figure](variant) for figure in figures)))
            head = ("", "")
    header = ("node", "P/T", "variant", *figures)
    return format_table(header, rows, right="P/T ratio hits RMSE eff.")


def summary(measurement: Measurement) -> str:
    """The original's time, its ratio to the bare geometry, and the share of the frame covered."""
    group, options, size = measurement.groups[0], measurement.options, measurement.size
    # All groups are of one scene, so the first one's times of the original will do.
    original, geometry = group.original.median, group.geometry.median
    lines = [
        f"original {original * 1e3:.1f} ms, geometry alone {geometry * 1e3:.1f} ms "
        f"({original / geometry:.1f}x), {measurement.covered:.0%} of the frame covered"
    ]
    if group.skipped is not None:
        skipped = group.skipped
        lines.append(
            f"{skipped.objects} objects; {skipped.outside:.1f} of them outside of the picture "
            f"and not drawn, which saves the original {skipped.saved:.0%}; "
            f"{skipped.uncached} drawn by their originals"
        )
    lines += map(_worth, measurement.gains)
    periods, blocks = (
        " and ".join(map(str, sorted(set(numbers))))
        for numbers in zip(*measurement.refreshes, strict=True)
    )
    lines.append(
        f"{size[0]}x{size[1]}, {measurement.frames} frames, period {periods}, "
        f"block {blocks}; errors over covered pixels of frames "
        f"{options.first_compared + 1}-{measurement.frames}; clock: {measurement.clock}"
    )
    return "\n".join([*lines, *(f"note: {note}" for note in measurement.notes)])


def _worth(gain: CachingGain) -> str:
    drawn = "cached" if gain.pays else "nothing gained, so drawn by the original"
    names = f"{len(gain.objects)} objects" if len(gain.objects) > 1 else gain.objects[0]
    ratio = gain.ratio
    return (
        f"{names} ({gain.shader}): cached, a frame is {ratio.median:.2f}x "
        f"[{ratio.low:.2f}-{ratio.high:.2f}] as fast with {gain.algorithm}: {drawn}"
    )
