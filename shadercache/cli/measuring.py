"""What ``run``, ``bench`` and ``demo`` share: the measurement, and the table of its results."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any

import typer

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
    from shadercache.measure.metrics.perceived import Perceived
    from shadercache.measure.statistics import StopRule
    from shadercache.measure.subjects import VariantSubject
    from shadercache.render.render_scene import RenderScene

_FIGURES: Mapping[str, Callable[[VariantResult], str]] = {
    "time ms": lambda variant: f"{variant.timing.median * 1e3:.1f}",
    "reset": lambda variant: f"{variant.reset:.2f}x",
    "ratio": lambda variant: f"{variant.speedup.median:.2f}x",
    "tail": lambda variant: f"{variant.timing.tail:.2f}",
    "interval": lambda variant: f"{variant.speedup.low:.2f}-{variant.speedup.high:.2f}",
    "hits": lambda variant: f"{variant.hit_rate:.1%}",
    "RMSE": lambda variant: f"{variant.error.rmse:.4f}",
    "PSNR dB": lambda variant: f"{variant.error.psnr:.1f}" if variant.error.rmse else "exact",
    "floor ms": lambda variant: "" if variant.floor is None else f"{variant.floor * 1e3:.1f}",
    "eff.": lambda variant: "" if variant.efficiency is None else f"{variant.efficiency:.2f}",
    "B/px": lambda variant: f"{variant.bytes_per_pixel:g}",
}
"""Columns of the table of results, and what stands in them for a variant."""

_PERCEIVED: Mapping[str, Callable[[Perceived], float | None]] = {
    "SSIM": lambda perceived: perceived.ssim,
    "FLIP": lambda perceived: perceived.flip,
    "flicker": lambda perceived: perceived.flicker,
    "pattern": lambda perceived: perceived.pattern,
}
"""The same of what is perceived, where it was measured."""

FIGURES = tuple(_FIGURES)
FEW_FIGURES = ("time ms", "ratio", "tail", "interval", "hits", "RMSE", "PSNR dB")
"""The figures that a first look needs."""


@dataclass(frozen=True, kw_only=True)
class TrialOptions:
    """How long is measured, in ``bench`` and whatever else measures many variants."""

    frames: Annotated[
        int, typer.Option(min=2, help="Frames of each run; the error is of these.")
    ] = 16
    until: Annotated[
        float,
        typer.Option(
            min=0.0,
            max=100.0,
            metavar="PERCENT",
            help="Repeat them, only to time them, until every ratio is known to within this; 0: "
            "never.",
        ),
    ] = 3.0
    seconds: Annotated[
        float,
        typer.Option(min=0.0, metavar="CAP", help="End the timing of a batch of variants by then."),
    ] = 30.0

    perceptual: Annotated[
        bool,
        typer.Option(
            "--perceptual",
            help="Also SSIM, FLIP, flicker, the error by age and the pattern of blocks.",
        ),
    ] = False

    @property
    def stop(self) -> StopRule | None:
        """The rule that is asked for."""
        from shadercache.measure.statistics import StopRule

        return StopRule(self.until / 100.0, self.seconds) if self.until else None


def measured(
    linker: Linker,
    subjects: Sequence[VariantSubject],
    how: MeasureOptions,
    drawn: PictureOptions,
    label: str,
) -> tuple[Measurement, dict[str, Any]]:
    """Measure the subjects of a scene, and say where. ``label`` is what the progress is called."""
    from shadercache.measure.measure import measure
    from shadercache.measure.result_files import environment

    with opened(linker, drawn, label) as (world, tell):
        results = measure(world, linker.originals(), subjects, how, tell)
        return results, environment(world.gpu)


@contextmanager
def opened(
    linker: Linker, drawn: PictureOptions, label: str
) -> Iterator[tuple[RenderScene, Callable[[int, int, str], None]]]:
    """The scene, ready to be drawn, and who is told of progress, which has that label."""
    from shadercache.gpu.context import open_context
    from shadercache.linking.user_places import at_home
    from shadercache.render.render_scene import RenderScene
    from shadercache.scene.mesh import replacement_mesh

    mesh = replacement_mesh(linker.scene, drawn.mesh)
    with (
        open_context() as gpu,
        at_home(linker.analysis),
        RenderScene(gpu, linker.scene, parse_size(drawn.size), mesh=mesh) as world,
        _steps(label) as tell,
    ):
        yield world, tell


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
        head = (label(node), *(_share(ratio) for ratio in (node.ratio, node.static_ratio)))
        for variant in node.variants:
            name = measurement.name(variant.configuration)
            told = (_FIGURES[figure](variant) for figure in figures)
            rows.append((*head, name, *told, *_perceived(variant)))
            head = ("", "", "")
    more = tuple(_PERCEIVED) if measurement.options.perceptual else ()
    header = ("node", "P/T", "static", "variant", *figures, *more)
    right = " ".join(("P/T static ratio tail hits RMSE eff.", *more))
    return "\n".join([format_table(header, rows, right=right), *_outputs(measurement, label)])


def _outputs(measurement: Measurement, label: Callable[[NodeResult], str]) -> Iterator[str]:
    """The error of each output, where the shader has several."""
    for node in measurement.nodes:
        for variant in node.variants:
            told = (
                f"{one.output} {one.error:.2%} changed"
                if one.integers
                else f"{one.output} {one.error:.4f}"
                for one in variant.outputs
            )
            if variant.outputs:
                name = measurement.name(variant.configuration)
                yield f"error by output, {label(node)}, {name}: {', '.join(told)}"


def _perceived(variant: VariantResult) -> tuple[str, ...]:
    perceived = variant.perceived
    if perceived is None:
        return ()
    figures = (figure(perceived) for figure in _PERCEIVED.values())
    return tuple("" if figure is None else f"{figure:.4f}" for figure in figures)


def _share(ratio: float | None) -> str:
    return "" if ratio is None else f"{ratio:.3f}"


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
        f"{size[0]}x{size[1]}, {options.frames} frames, period {periods}, "
        f"block {blocks}; errors over covered pixels of frames "
        f"{options.first_compared + 1}-{options.frames}; clock: {measurement.clock}"
    )
    lines.append(_reached(measurement))
    correlation = measurement.rank_correlation
    if correlation is not None:
        lines.append(f"P/T as measured and by static costs: rank correlation {correlation:.2f}")
    return "\n".join([*lines, *(f"note: {note}" for note in measurement.notes)])


def _reached(measurement: Measurement) -> str:
    """How well the ratios are known, and after how much."""
    reached, stop = [group.reached for group in measurement.groups], measurement.options.stop
    width = max(batch.half_width for batch in reached)
    counts = [batch.frames for batch in reached]
    frames = "-".join(str(count) for count in dict.fromkeys((min(counts), max(counts))))
    told = (
        f"every ratio to within {width:.1%} (half of its 95 % interval), from {frames} timed "
        f"frames in {sum(batch.seconds for batch in reached):.0f} s"
    )
    capped = sum(batch.capped for batch in reached)
    if stop is None or not capped:
        return told
    which = f"{capped} of {len(reached)} batches" if len(reached) > 1 else "the run"
    return f"{told}; {which} ran out of time before {stop.half_width:.1%}"


def _worth(gain: CachingGain) -> str:
    drawn = "cached" if gain.pays else "nothing gained, so drawn by the original"
    names = f"{len(gain.objects)} objects" if len(gain.objects) > 1 else gain.objects[0]
    ratio = gain.ratio
    return (
        f"{names} ({gain.shader}): cached, a frame is {ratio.median:.2f}x "
        f"[{ratio.low:.2f}-{ratio.high:.2f}] as fast with {gain.algorithm}: {drawn}"
    )
