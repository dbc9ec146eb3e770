"""What a measurement is asked and what it answers: plain values, with the raw samples."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from shadercache.caching.configuration import Assignment, Configuration
from shadercache.measure.image_error import ErrorStats, Pixels
from shadercache.measure.metrics.perceived import Perceived
from shadercache.measure.output_errors import OutputError
from shadercache.measure.statistics import (
    Ratio,
    Reached,
    StopRule,
    Timing,
    rank_correlation,
)

PERCEIVED = 4
"""Of at most so many frames all metrics are computed."""

ORIGINAL = "original"
"""What stands for the original where images are kept by label."""

LAST_COMPARED = 8
"""So many images at the end of a short run say enough of its error."""


@dataclass(frozen=True, slots=True)
class MeasureOptions:
    """How to measure. Frames are counted from 0, so the papers' frames 33-64 are 32 to 63.

    ``frames``: how many are drawn and compared; frame 0 is a reset and is not timed.
    ``error_from``: images are compared from this frame on; of short runs all but the last eight
    frames come before, or half of the frames if that is less.
    ``probe_every``: every so many frames of that range, hit masks, work and the parts of the floor
    are taken as well (they cost extra draws); more often in a short run, so that there are eight.
    ``group``: how many variants are interleaved at once; more need more memory for caches.
    ``picture_frame``: the frame whose pictures are kept; None keeps none.
    ``curves``: of at most so many payloads what becomes of the pixels is counted in every frame.
    ``weigh``: first find out which objects with shaders of their own are worth caching.
    ``perceptual``: after all timing, draw the frames once more and look at up to four images for
    what an RMSE hides: SSIM, FLIP, flicker, the error by age, the pattern of blocks.
    ``stop``: then repeat these frames, only to time them, until every ratio is known well enough.
    """

    frames: int = 64
    error_from: int = 32
    probe_every: int = 4
    group: int = 12
    picture_frame: int | None = None
    curves: int = 8
    weigh: bool = True
    perceptual: bool = False
    stop: StopRule | None = None

    @property
    def first_compared(self) -> int:
        """The first frame whose image is compared; never the reset frame."""
        # The error grows over the first period, so a short run is compared at its end.
        return max(1, min(self.error_from, max(self.frames // 2, self.frames - LAST_COMPARED)))

    def is_probed(self, frame: int) -> bool:
        """Whether the costly extras are taken at a frame."""
        return self._falls_on(frame, min(self.probe_every, self._compared // 8))

    def times_payload(self, frame: int) -> bool:
        """Whether the payload alone is timed at a frame: sixteen times, or at all that compare."""
        return self._falls_on(frame, self._compared // 16)

    def is_perceived(self, frame: int) -> bool:
        """Whether the costly metrics of images are taken at a frame."""
        # An odd distance: what does something else in every second frame is seen doing both.
        return self._falls_on(frame, -(-self._compared // PERCEIVED) | 1)

    @property
    def _compared(self) -> int:
        return self.frames - self.first_compared

    def _falls_on(self, frame: int, every: int) -> bool:
        since = frame - self.first_compared
        return since >= 0 and since % max(1, every) == 0


@dataclass(frozen=True, eq=False)
class Probe:
    """What became of each pixel of a frame, as its debug program and its cache say.

    ``mask`` (h, w): 0 where nothing is drawn, else one of ``values`` by outcome. ``ages`` (h, w):
    in frames, where the cache keeps them; ``period`` is the refresh period.
    """

    mask: NDArray[np.uint8]
    values: Mapping[str, int]
    ages: NDArray[np.float32] | None
    period: int

    @property
    def shares(self) -> dict[str, float]:
        """Of the pixels where something is drawn, the share of each outcome."""
        counts = np.bincount(self.mask.ravel(), minlength=256)
        covered = max(1, self.mask.size - int(counts[0]))
        return {name: float(counts[value]) / covered for name, value in self.values.items()}


@dataclass(frozen=True, eq=False)
class Shot:
    """Images of one variant at one frame, row 0 at the bottom; ``probe`` tells its outcomes."""

    label: str
    configuration: Configuration
    original: Pixels
    cached: Pixels
    probe: Probe


@dataclass(frozen=True, slots=True)
class Curve:
    """What became of the visible pixels of cached objects: their shares, by frame from frame 0.

    ``period`` and ``block`` are those of the run."""

    period: int
    block: int
    hit: tuple[float, ...]
    refresh: tuple[float, ...]

    @property
    def hit_rate(self) -> float:
        """The mean share of hits, without the reset frame."""
        return float(np.mean(self.hit[1:]))

    @property
    def found_rate(self) -> float:
        """The same of what is not refreshed on purpose: what reprojection finds again."""
        pairs = zip(self.hit[1:], self.refresh[1:], strict=True)
        # With a period of 1 everything is refreshed, and nothing is left to be found.
        return float(np.mean([hit / max(1e-9, 1.0 - refresh) for hit, refresh in pairs]))

    @property
    def burst(self) -> float:
        """The greatest share that is refreshed in one frame."""
        return max(self.refresh[1:])


@dataclass(frozen=True, slots=True)
class SubjectResult:
    """What is said of everything that was drawn beside the original.

    ``timing`` of all frames but reset frames. ``speedup`` is original / this, frame by frame.
    ``error`` over all images that were compared, ``frame_rmse`` of each of them. ``perceived``:
    None unless it was asked for (``MeasureOptions.perceptual``). ``outputs``: the error of each
    output, where the shader has several.
    """

    timing: Timing
    speedup: Ratio
    error: ErrorStats
    frame_rmse: tuple[float, ...]
    perceived: Perceived | None
    outputs: tuple[OutputError, ...]


@dataclass(frozen=True, slots=True)
class VariantResult(SubjectResult):
    """One variant against the original.

    ``outcomes``: share of the covered visible pixels that were a hit, a refresh, a miss by cause;
    ``burst`` the largest share of refreshes in any probed frame.
    ``reset`` is the time of the frame behind a reset over the original's (the median of a few).
    ``work``: fragments per frame by pass, overdraw included. ``floor`` in seconds and
    ``efficiency`` = floor / time as docs/why/measuring.md says, None without parts.
    ``bytes_per_pixel``: what its textures take (``render.memory``).
    """

    configuration: Configuration
    reset: float
    outcomes: Mapping[str, float]
    burst: float
    hit_rates: tuple[float, ...]
    work: Mapping[str, float]
    floor: float | None
    efficiency: float | None
    bytes_per_pixel: float

    @property
    def hit_rate(self) -> float:
        """Mean share of the covered visible pixels that reuse a payload, over probed frames."""
        return float(np.mean(self.hit_rates)) if self.hit_rates else 0.0


@dataclass(frozen=True, slots=True)
class OtherResult(SubjectResult):
    """What is no variant."""

    label: str


@dataclass(frozen=True, slots=True)
class KnownNode:
    """What a node is, before anything is measured.

    ``equal``: for how many nodes of the same value it stands. ``static_ratio``: P/T by the
    compiler's static costs, None where nobody asked for them.
    """

    label: str
    node_id: str
    path: str
    text: str
    type: str
    mode: str
    equal: int
    static_ratio: float | None


@dataclass(frozen=True, slots=True)
class NodeResult(KnownNode):
    """One node. ``ratio`` is P/T as measured: payload alone over the original, both less geometry.

    ``payload`` and ``hit`` are the parts measured alone at the probed frames (None if the manifest
    has no 3-pass or no 2-pass variant). ``curves``: one for each period and block.
    """

    ratio: float | None
    payload: Timing | None
    hit: Timing | None
    variants: tuple[VariantResult, ...]
    curves: tuple[Curve, ...] = ()


@dataclass(frozen=True, slots=True)
class Skipped:
    """What a scene of several objects does without, on average over the frames.

    ``objects`` there are; ``outside`` of them lie outside of the picture or are not there, so are
    not drawn; ``uncached`` are drawn by their originals. ``saved``: the share of the original's
    time that drawing all of them takes more.
    """

    objects: int
    outside: float
    uncached: int
    saved: float


@dataclass(frozen=True, slots=True)
class CachingGain:
    """How many times as fast a frame is with the objects of one shader cached, all else the same.

    ``shader`` is its file's name; ``ratio`` is of the algorithm that gains the most by it.
    """

    shader: str
    objects: tuple[str, ...]
    algorithm: str
    ratio: Ratio

    @property
    def pays(self) -> bool:
        """Is the frame any faster for it?"""
        return self.ratio.median > 1.0


@dataclass(frozen=True, slots=True)
class Group:
    """Nodes whose frames were interleaved with the same draws of the original.

    ``original`` and ``geometry`` (the vertex work alone) are timed at every frame. ``reached``: how
    well the ratios are known. ``others`` were drawn in turns with them.
    """

    original: Timing
    geometry: Timing
    reached: Reached
    nodes: tuple[NodeResult, ...]
    others: tuple[OtherResult, ...] = ()
    skipped: Skipped | None = None


@dataclass(frozen=True, eq=False)
class Measurement:
    """The whole answer. ``covered``: mean share of the frame that the mesh covers; ``notes``: what
    the runs gave away, such as cuts that were not told; ``gains``: what caching the objects with
    shaders of their own is worth. Those where it is nothing were drawn by their originals.
    ``pictures``: at the frame of the shots, what is no variant by its label, and the original as
    ``ORIGINAL``."""

    scene: str
    size: tuple[int, int]
    options: MeasureOptions
    clock: str
    covered: float
    groups: tuple[Group, ...]
    shots: tuple[Shot, ...]
    notes: tuple[str, ...] = ()
    gains: tuple[CachingGain, ...] = ()
    assignments: Mapping[Configuration, Assignment] = field(default_factory=dict)
    pictures: Mapping[str, Pixels] = field(default_factory=dict)

    @property
    def rank_correlation(self) -> float | None:
        """Spearman's, of P/T as measured and by static costs, over the nodes that have both.

        None for fewer than three of them.
        """
        pairs = [
            (node.ratio, node.static_ratio)
            for node in self.nodes
            if node.ratio is not None and node.static_ratio is not None
        ]
        return rank_correlation([one for one, _ in pairs], [other for _, other in pairs])

    @cached_property
    def nodes(self) -> tuple[NodeResult, ...]:
        """All nodes, in the order they were given."""
        return tuple(node for group in self.groups for node in group.nodes)

    @cached_property
    def refreshes(self) -> tuple[tuple[int, int], ...]:
        """The periods and blocks that were measured beside each other."""
        variants = (variant for node in self.nodes for variant in node.variants)
        refreshes = (variant.configuration.refresh for variant in variants)
        return tuple(dict.fromkeys((refresh.period, refresh.block) for refresh in refreshes))

    def name(self, configuration: Configuration) -> str:
        """What tells variants of one node apart: the algorithm; with several periods and blocks
        these too."""
        period, block = configuration.refresh.period, configuration.refresh.block
        name, rate = configuration.algorithm, configuration.payload_rate
        name += "" if rate == "full" else f" {rate}"
        return f"{name} n{period} k{block}" if len(self.refreshes) > 1 else name
