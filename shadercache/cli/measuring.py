"""What ``run``, ``bench`` and ``demo`` share: options, sizes, and the table of results."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Annotated

import typer

from shadercache.caching.algorithms import ALGORITHMS
from shadercache.cli.progress import progress
from shadercache.cli.tables import format_table
from shadercache.diagnostics import usage_error

if TYPE_CHECKING:
    from shadercache.measure.measurement import CachingGain, Measurement, NodeResult, VariantResult

WeighOption = Annotated[
    bool,
    typer.Option(
        "--weigh/--no-weigh",
        help="Of several objects, leave those to their originals where caching gains nothing.",
    ),
]

PASSES = (*(item.word for item in ALGORITHMS), "all")
"""What ``--passes`` takes."""

HEADER = (
    "node",
    "P/T",
    "variant",
    "time ms",
    "p95/p99",
    "reset",
    "ratio",
    "interval",
    "hits",
    "RMSE",
    "PSNR dB",
    "floor ms",
    "eff.",
)
RIGHT = "P/T ratio hits RMSE eff."
SHORT_HEADER = ("node", "P/T", "variant", "time ms", "ratio", "interval", "hits", "RMSE", "PSNR dB")
"""The columns that a first look needs."""


def parse_size(text: str) -> tuple[int, int]:
    """``1024`` or ``1280x720`` as (width, height). Raises :class:`UsageError` SC007."""
    parts = text.lower().split("x")
    if len(parts) in (1, 2) and all(part.isdecimal() and 0 < int(part) <= 16384 for part in parts):
        return int(parts[0]), int(parts[-1])
    raise usage_error("SC007", f"'{text}' is not a size", "give 1024 or 1280x720, in pixels")


def parse_numbers(text: str, name: str, least: int, most: int) -> list[int]:
    """``1,4,32`` as numbers. Raises :class:`UsageError` SC008 for one out of its range."""
    parts = [part for part in text.split(",") if part]
    if parts and all(part.isdecimal() and least <= int(part) <= most for part in parts):
        return [int(part) for part in parts]
    hint = f"give whole numbers from {least} to {most}, separated by commas"
    raise usage_error("SC008", f"'{text}' is no value for {name}", hint)


def parse_passes(text: str) -> tuple[str, ...]:
    """``all`` or words of the table of algorithms, such as ``1,2``, as their names. Raises
    :class:`UsageError` SC008."""
    known = {item.word: item.name for item in ALGORITHMS}
    words = list(known) if text == "all" else [word for word in text.split(",") if word]
    if words and all(word in known for word in words):
        return tuple(known[word] for word in words)
    hint = f"give 'all', or some of {', '.join(known)}, separated by commas"
    raise usage_error("SC008", f"'{text}' is no value for --passes", hint)


def one_of(words: Sequence[str]) -> Callable[[str], str]:
    """A parser of an option that takes one of these words."""

    def word(text: str) -> str:
        if text not in words:
            raise typer.BadParameter(f"'{text}' is not one of {', '.join(words)}")
        return text

    return word


def parse_periods(text: str) -> list[int]:
    """Refresh periods in frames (the look-up's arithmetic ends at 65,535)."""
    return parse_numbers(text, "--period", 1, 65_535)


def parse_blocks(text: str) -> list[int]:
    """Block edges in pixels: even, so that blocks hold whole 2x2 quads."""
    blocks = parse_numbers(text, "--block", 2, 4096)
    if any(block % 2 for block in blocks):
        raise usage_error("SC008", f"'{text}' is no value for --block", "blocks are even")
    return blocks


@contextmanager
def step_progress(label: str) -> Iterator[Callable[[int, int, str], None]]:
    """A callback for :func:`shadercache.measure.measure.measure` that shows its progress.

    The number of steps is learnt with the first call.
    """
    with progress(label, 1000) as advance:
        shown = 0

        def tell(done: int, total: int, what: str) -> None:
            nonlocal shown
            reached = 1000 * done // max(1, total)
            if reached > shown:
                advance(reached - shown)
                shown = reached

        yield tell


def result_table(
    measurement: Measurement,
    label: Callable[[NodeResult], str],
    columns: Sequence[str] = HEADER,
) -> str:
    """All variants of all nodes, nodes in ascending P/T, as text."""
    nodes = sorted(measurement.nodes, key=lambda node: node.ratio or 0.0)
    rows = [
        _row(node, variant, label(node) if first else "", measurement.name(variant.configuration))
        for node in nodes
        for first, variant in _marked(node.variants)
    ]
    chosen = [HEADER.index(name) for name in columns]
    return format_table(columns, [tuple(row[at] for at in chosen) for row in rows], right=RIGHT)


def summary(measurement: Measurement) -> str:
    """The original's time, its ratio to the bare geometry, and the share of the frame covered."""
    lines: list[str] = []
    for group in measurement.groups[:1]:
        original, geometry = group.original.median, group.geometry.median
        lines.append(
            f"original {original * 1e3:.1f} ms, geometry alone {geometry * 1e3:.1f} ms "
            f"({original / geometry:.1f}x), {measurement.covered:.0%} of the frame covered"
        )
        if group.skipped is not None:
            skipped = group.skipped
            lines.append(
                f"{skipped.objects} objects; {skipped.outside:.1f} of them outside of the picture "
                f"and not drawn, which saves the original {skipped.saved:.0%}; "
                f"{skipped.uncached} drawn by their originals"
            )
    lines += [_worth(gain) for gain in measurement.gains]
    options, size = measurement.options, measurement.size
    periods, blocks = (sorted(set(found)) for found in zip(*measurement.refreshes, strict=True))
    lines.append(
        f"{size[0]}x{size[1]}, {measurement.frames} frames, period {_listed(periods)}, "
        f"block {_listed(blocks)}; errors over covered pixels of frames "
        f"{options.first_compared + 1}-{measurement.frames}; clock: {measurement.clock}"
    )
    lines += [f"note: {note}" for note in measurement.notes]
    return "\n".join(lines)


def _listed(numbers: Sequence[int]) -> str:
    return " and ".join(map(str, numbers))


def _worth(gain: CachingGain) -> str:
    drawn = "cached" if gain.pays else "nothing gained, so drawn by the original"
    names = f"{len(gain.objects)} objects" if len(gain.objects) > 1 else gain.objects[0]
    ratio = gain.ratio
    return (
        f"{names} ({gain.shader}): cached, a frame is {ratio.median:.2f}x "
        f"[{ratio.low:.2f}-{ratio.high:.2f}] as fast with {gain.algorithm}: {drawn}"
    )


def _marked(variants: Sequence[VariantResult]) -> Iterator[tuple[bool, VariantResult]]:
    for place, variant in enumerate(variants):
        yield place == 0, variant


def _row(node: NodeResult, variant: VariantResult, label: str, name: str) -> tuple[str, ...]:
    ratio, error = variant.speedup, variant.error
    psnr = "exact" if error.rmse == 0.0 else f"{error.psnr:.1f}"
    return (
        label,
        f"{node.ratio:.3f}" if label and node.ratio is not None else "",
        name,
        f"{variant.timing.median * 1e3:.1f}",
        f"{variant.timing.p95 * 1e3:.0f}/{variant.timing.p99 * 1e3:.0f}",
        f"{variant.reset:.2f}x",
        f"{ratio.median:.2f}x",
        f"{ratio.low:.2f}-{ratio.high:.2f}",
        f"{variant.hit_rate:.1%}",
        f"{error.rmse:.4f}",
        psnr,
        "" if variant.floor is None else f"{variant.floor * 1e3:.1f}",
        "" if variant.efficiency is None else f"{variant.efficiency:.2f}",
    )
