"""FIG5: what becomes of each pixel, for blocks of 1, 2 and 4 (N1 to N4).

Figure 5 of Sitthi-amorn et al. 2008 on the dragon. Whether a missed pixel shows what was hidden is
told without the variants: by the depths and the motion of the originals.
"""

from __future__ import annotations

import zlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from bench.papers.claims import Verdict
from bench.papers.drawing import panels, png
from bench.papers.experiment import Experiment, Options
from bench.papers.turns import BLOCK, PERIOD
from bench.papers.two_octaves import Bench, two_octaves
from shadercache.cli.tables import format_table
from shadercache.gpu.context import Gpu
from shadercache.render.surfaces import Surfaces
from shadercache.render.variant_runner import VariantRunner
from shadercache.report.images import LEGEND, hit_picture
from shadercache.verify.expected_hits import DepthTest, Stored, shown_before

BLOCKS = (1, 2, 4)
LOOKED_AT = 8
"""In so many frames misses are looked at one by one."""

NEAR = 0.05
"""How far the share of refreshed pixels may be off one in a period, relative to it."""

FOUND = 0.90
"""The share that has to be found again (Nehab et al. 2006)."""

MOST = 0.90
"""The share of misses that have to be disocclusions."""

Mask = NDArray[np.bool_]


@dataclass(frozen=True, slots=True)
class RefreshMap:
    """One block size. ``shares`` are means over the frames of a period, of the covered pixels;
    ``split``: blocks of which a part is refreshed, of ``whole`` blocks and these together.

    ``misses`` at the frames that were looked at, ``disoccluded`` of them; ``mask`` (h, w) is that
    of the last frame, compressed.
    """

    block: int
    shares: Mapping[str, float]
    found: float
    whole: int
    split: int
    misses: int
    disoccluded: int
    mask: bytes


@dataclass(frozen=True, slots=True)
class Figure5:
    """What is stored. ``values``: an outcome's number in the masks."""

    size: int
    values: Mapping[str, int]
    maps: tuple[RefreshMap, ...]


def gather(gpu: Gpu, options: Options, tell: Callable[[int, int], None]) -> Figure5:
    """Draw a period for each block size; nothing is timed."""
    maps = []
    values: Mapping[str, int] = {}
    with (
        two_octaves(gpu, options.size, "rgba32f") as bench,
        Surfaces(bench.world, bench.linker.originals()) as surfaces,
    ):
        for number, block in enumerate(BLOCKS):
            tell(number, len(BLOCKS))
            # That of two passes: the others reuse the same pixels (law 4).
            subject = bench.variants(PERIOD, block)[1]
            with VariantRunner(bench.world, *subject.objects) as runner:
                values = runner.bundle.mask_values
                maps.append(_map(bench, runner, surfaces, block))
    return Figure5(options.size, values, tuple(maps))


def _map(bench: Bench, runner: VariantRunner, surfaces: Surfaces, block: int) -> RefreshMap:
    values = runner.bundle.mask_values
    counts = np.zeros(256)
    whole = split = misses = disoccluded = 0
    mask = np.zeros(0, np.uint8)
    # The reset frame and a whole period, so that each block has its turn once.
    for frame in range(PERIOD + 1):
        if frame:
            mask = runner.hit_mask(frame)
            counts += np.bincount(mask.ravel(), minlength=256)
            due = _blocks(mask, block, values["refresh"])
            whole, split = whole + due[0], split + due[1]
        if frame > PERIOD - LOOKED_AT:
            missed = np.isin(mask, [values["outside"], values["depth"]])
            hidden = missed & ~_seen_before(runner, surfaces, frame)
            misses, disoccluded = misses + int(missed.sum()), disoccluded + int(hidden.sum())
        runner.draw(frame)
    covered = counts[1:].sum()
    shares = {name: float(counts[value] / covered) for name, value in values.items()}
    found = shares["hit"] / (1.0 - shares["refresh"])
    packed = zlib.compress(mask.tobytes(), 9)
    return RefreshMap(block, shares, found, whole, split, misses, disoccluded, packed)


def _blocks(mask: NDArray[np.uint8], block: int, due: int) -> tuple[int, int]:
    """How many blocks with refreshed pixels have only such, and how many have others too."""
    # Blocks that the border of the picture cuts are left out.
    height, width = (edge - edge % block for edge in mask.shape)
    tiles = mask[:height, :width].reshape(height // block, block, width // block, block)
    refreshed, drawn = ((tiles == due).sum((1, 3)), (tiles != 0).sum((1, 3)))
    # On an outline a block is whole if all is refreshed that is drawn of it.
    whole = int(np.count_nonzero((refreshed > 0) & (refreshed == drawn)))
    return whole, int(np.count_nonzero(refreshed)) - whole


def _seen_before(runner: VariantRunner, surfaces: Surfaces, frame: int) -> Mask:
    """Which pixels show a point of which the frame before showed all that a filter reads."""
    before = surfaces.frame(frame - 1)
    numbers = runner.inputs.of(runner.cached[0], frame).numbers
    epsilon, unit = (float(numbers[name][0]) for name in ("epsilon", "unit"))
    kept = before.number > 0
    nothing = np.zeros((*kept.shape, 0), np.uint32)
    stored = Stored(kept, nothing, surfaces.world.viewport(frame - 1))
    test = DepthTest(runner.configuration, epsilon, unit)
    return shown_before(surfaces.frame(frame), before, stored, test, still=False)


def judge(data: Figure5) -> list[Verdict]:
    """N1 to N4."""
    shares = {one.block: PERIOD * one.shares["refresh"] for one in data.maps}
    even = all(abs(share - 1.0) <= NEAR for share in shares.values())
    each = ", ".join(f"k = {block}: {share:.3f} / {PERIOD}" for block, share in shares.items())
    split = sum(one.split for one in data.maps)
    blocks = sum(one.whole + one.split for one in data.maps)
    widest = data.maps[-1]
    hidden = widest.disoccluded / max(1, widest.misses)
    found = min(one.found for one in data.maps)
    return [
        Verdict("N1", even, f"refreshed on average in a frame, of the covered pixels: {each}"),
        Verdict(
            "N2", split == 0 < blocks, f"{split} of {blocks} refreshed blocks are refreshed in part"
        ),
        Verdict(
            "N3",
            hidden >= MOST if widest.misses else None,
            f"{hidden:.1%} of {widest.misses} missed pixels (k = {widest.block}) show a point of "
            "which the frame before did not show all four texels that a filter reads",
        ),
        Verdict(
            "N4",
            found >= FOUND,
            f"{found:.1%} of what is not refreshed is found again, at a degree a frame "
            f"and {data.size} x {data.size} pixels",
        ),
    ]


def table(data: Figure5) -> str:
    """A row for each block size."""
    header = ("block", "hits", "refreshed", "missed", "found again", "misses hidden before")
    rows = [
        (
            str(one.block),
            f"{one.shares['hit']:.2%}",
            f"{one.shares['refresh']:.2%}",
            f"{one.shares['outside'] + one.shares['depth']:.2%}",
            f"{one.found:.2%}",
            f"{one.disoccluded / max(1, one.misses):.1%}",
        )
        for one in data.maps
    ]
    return format_table(header, rows)


def draw(data: Figure5) -> dict[str, bytes]:
    """The maps, and a part of each so large that single pixels are seen."""
    from matplotlib.patches import Patch

    figure, every = panels(2, len(data.maps), (11.0, 8.0))
    part = data.size // 8
    for number, one in enumerate(data.maps):
        raw = np.frombuffer(zlib.decompress(one.mask), np.uint8)
        shown = hit_picture(raw.reshape(data.size, data.size), data.values)
        rows, columns = (_around(where, part) for where in np.nonzero(shown.any(axis=2)))
        for axes, pixels in (
            (every[number], shown),
            (every[number + len(data.maps)], shown[rows, columns]),
        ):
            axes.imshow(pixels, interpolation="nearest")
            axes.grid(False)
            axes.set_xticks([])
            axes.set_yticks([])
        every[number].set_title(f"k = {one.block}", loc="left", fontsize=11)
    patches = [
        Patch(color="#{:02x}{:02x}{:02x}".format(*LEGEND[name][0]), label=LEGEND[name][1])
        for name in ("hit", "refresh", "depth")
    ]
    figure.legend(handles=patches, loc="outside lower center", ncols=3, frameon=False)
    return {"figure5": png(figure)}


def _around(places: NDArray[np.int64], part: int) -> slice:
    """So many pixels around the middle of these places."""
    middle = int(np.median(places)) if places.size else part
    start = max(0, middle - part // 2)
    return slice(start, start + part)


EXPERIMENT = Experiment(
    "FIG5",
    f"Refresh maps, period {PERIOD}, blocks up to {BLOCK}",
    Figure5,
    gather,
    judge,
    table,
    draw,
)
