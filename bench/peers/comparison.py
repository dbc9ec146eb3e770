"""One scene: the original, the peers and some variants of the cache, drawn in turns."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from bench.peers.checkerboard import Checkerboard
from bench.peers.fewer_samples import fewer_samples
from bench.peers.final_color import final_color
from bench.peers.half_rate import HalfRate
from bench.peers.outcomes import METRICS, SCHEMA_VERSION, Point, SceneOutcome, who_wins
from bench.peers.reduced_resolution import BilinearUpsampling, DepthAwareUpsampling
from bench.peers.scene_programs import ScenePrograms
from bench.peers.temporal_upscaling import TemporalUpscaling
from shadercache.caching.configuration import Configuration, Filter, PayloadRate, Refresh
from shadercache.diagnostics import InputError
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.measure.measure import Progress, measure
from shadercache.measure.measurement import (
    Group,
    Measurement,
    MeasureOptions,
    SubjectResult,
    VariantResult,
)
from shadercache.measure.result_files import environment
from shadercache.measure.statistics import paired_ratio
from shadercache.measure.subjects import Subject, VariantSubject, subjects_of
from shadercache.render.render_scene import RenderScene

MULTIPLE = 4
"""The size is one of this: smaller pictures have whole pixels that lie upon the large ones."""

COLOR_PERIODS = (2, 4)
"""Refresh periods of the cached colour, beside the scene's: it ages faster than what is in it."""

LONGER = 4
"""Times the scene's period: carried samples are tried at both, since they do not blur with age."""

SLOWER: tuple[PayloadRate, ...] = ("half", "quarter")
"""Payload rates at which the colour is tried."""

_TURN = 2
"""Frames that are timed as one: a peer may do all of its work in every second frame."""


@dataclass(frozen=True)
class Setting:
    """A scene to compare in, and in how many frames."""

    linker: Linker
    programs: ScenePrograms
    frames: int

    @property
    def configuration(self) -> Configuration:
        """The default, with the scene's period and block."""
        demo = self.linker.scene.demo
        refresh = Refresh() if demo is None else Refresh(period=demo.period, block=demo.block)
        return Configuration(refresh=refresh)


def _reduced(kind: type[BilinearUpsampling], divisor: int, how: str) -> Maker:
    share = {2: "half", 4: "quarter"}[divisor]

    def make(setting: Setting) -> list[Subject]:
        label = f"{share} resolution, {how}"
        return [kind(label, setting.programs, setting.frames, divisor)]

    return make


def _fewer(setting: Setting) -> list[Subject]:
    cheaper = fewer_samples(setting.linker.scene)
    return [] if cheaper is None else [cheaper]


def _colors(setting: Setting) -> list[Subject]:
    plain = setting.configuration
    periods = dict.fromkeys((*COLOR_PERIODS, plain.refresh.period))
    return [
        final_color(setting.linker, f"cached colour, period {period}", plain.with_refresh(period))
        for period in periods
    ]


def cached_values(setting: Setting) -> list[Subject]:
    """The nodes that the scene shows, in each of the ways that might suit one."""
    scene, plain = setting.linker.scene, setting.configuration
    names = scene.nodes if scene.demo is None else scene.demo.nodes
    subjects: list[Subject] = []
    for name in names:
        for chosen in _ways(replace(plain, nodes=(scene.nodes[name],))):
            try:
                subjects += subjects_of(setting.linker, name, [chosen])
            except InputError as error:
                # What carried samples keep beside the payload may not fit into the texels.
                if error.diagnostics[0].code != "SC430":
                    raise
    return [*subjects, *_slower_colors(setting)]


def _slower_colors(setting: Setting) -> Iterator[Subject]:
    """The colour at a fraction of the rate: the most that can be upsampled."""
    three = replace(setting.configuration, algorithm="3-pass")
    for rate in SLOWER:
        for period in _short_periods(three):
            chosen = replace(three, payload_rate=rate).with_refresh(period)
            try:
                yield final_color(setting.linker, "colour", chosen)
            except InputError as error:
                if error.diagnostics[0].code != "SC407":
                    raise


def _short_periods(plain: Configuration) -> list[int]:
    """Periods for payloads at a fraction of the rate, and the scene's."""
    return sorted({1, 2, plain.refresh.period})


def _ways(plain: Configuration) -> Iterator[Configuration]:
    """By algorithm, filter, period and payload rate."""
    period = plain.refresh.period
    two, three = (replace(plain, algorithm=name) for name in ("2-pass", "3-pass"))
    carried = replace(two, filter=Filter("carried"))
    yield from (two, three, replace(plain, algorithm="parked"))
    yield from (carried, carried.with_refresh(LONGER * period))
    for shorter in _short_periods(plain):
        yield replace(three, payload_rate="half").with_refresh(shorter)


Maker = Callable[[Setting], Sequence[Subject]]

PEERS: Mapping[str, Maker] = {
    "half-bilinear": _reduced(BilinearUpsampling, 2, "bilinear"),
    "half-depth": _reduced(DepthAwareUpsampling, 2, "depth-aware"),
    "quarter-bilinear": _reduced(BilinearUpsampling, 4, "bilinear"),
    "quarter-depth": _reduced(DepthAwareUpsampling, 4, "depth-aware"),
    "checkerboard": lambda setting: [
        Checkerboard("checkerboard", setting.programs, setting.frames)
    ],
    "color": _colors,
    "fewer": _fewer,
    "half-rate": lambda setting: [
        HalfRate("half frame rate, warped", setting.programs, setting.frames)
    ],
    "temporal": lambda setting: [
        TemporalUpscaling("temporal upscaling", setting.programs, setting.frames)
    ],
}
"""What is compared, by the names of ``--only``; ``cache`` stands for the variants."""

CACHE = "cache"


def compare(
    gpu: Gpu, setting: Setting, size: int, only: Sequence[str], progress: Progress | None = None
) -> tuple[SceneOutcome, Measurement]:
    """Measure all that is asked for in one run, at one output size.

    Args:
        size: width and height, a multiple of ``MULTIPLE``.
        only: names of peers, and ``cache``.

    Raises as ``measure`` and the peers.
    """
    variants = cached_values(setting) if CACHE in only else []
    peers = [peer for name in PEERS if name in only for peer in PEERS[name](setting)]
    subjects = [*variants, *peers]
    options = MeasureOptions(
        setting.frames,
        group=len(subjects),
        picture_frame=setting.frames - 1,
        curves=0,
        perceptual=True,
    )
    linker = setting.linker
    with RenderScene(gpu, linker.scene, (size, size)) as world:
        measured = measure(world, linker.originals(), subjects, options, progress)
    [group] = measured.groups
    period = setting.configuration.refresh.period
    colors = {peer.label for peer in peers if isinstance(peer, VariantSubject)}
    points = tuple(_points(group, colors, period))
    outcome = SceneOutcome(
        schema_version=SCHEMA_VERSION,
        scene=measured.scene,
        size=measured.size,
        frames=setting.frames,
        clock=measured.clock,
        environment=environment(gpu),
        # The mean: of a peer that works in every second frame a median shows one kind only.
        original=1e3 * float(np.mean(group.original.samples)),
        points=points,
        winners={metric: who_wins(points, metric) for metric in METRICS},
        samples=group.original.samples,
    )
    return outcome, measured


def _points(group: Group, colors: set[str], period: int) -> Iterator[Point]:
    for node in group.nodes:
        for variant in node.variants:
            if node.label in colors:
                yield _point(group, variant, node.label, "peer")
            else:
                words = (node.label, *_words(variant.configuration, period))
                yield _point(group, variant, ", ".join(words), "cache")
    for other in group.others:
        yield _point(group, other, other.label, "peer")


def _words(configuration: Configuration, period: int) -> Iterator[str]:
    """The algorithm, and what is not as it is by default in the scene."""
    yield configuration.algorithm
    if configuration.filter != Filter():
        yield configuration.filter.kind
    if configuration.payload_rate != "full":
        yield f"{configuration.payload_rate} rate"
    if configuration.refresh.period != period:
        yield f"period {configuration.refresh.period}"


def _point(group: Group, result: SubjectResult, label: str, kind: str) -> Point:
    original, own = (turns(of.samples) for of in (group.original, result.timing))
    ratio = paired_ratio(original, own)
    seen = result.perceived
    found: dict[str, float | None] = {"rmse": result.error.rmse, "p99": result.error.p99}
    if seen is not None:
        found |= {"flip": seen.flip, "ssim": seen.ssim, "flicker": seen.flicker}
    return Point(
        label=label,
        kind="cache" if kind == "cache" else "peer",
        ratio=ratio.median,
        low=ratio.low,
        high=ratio.high,
        milliseconds=1e3 * float(np.mean(result.timing.samples)),
        errors={name: error for name, error in found.items() if error is not None},
        configuration=(
            result.configuration.to_json() if isinstance(result, VariantResult) else None
        ),
        samples=result.timing.samples,
    )


def turns(samples: Sequence[float]) -> list[float]:
    """The times of each two frames that follow one another; of an odd number the first is left."""
    rest = samples[len(samples) % _TURN :]
    return [sum(rest[at : at + _TURN]) for at in range(0, len(rest), _TURN)]
