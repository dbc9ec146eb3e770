"""What becomes of each pixel, as false colours with a legend: all outcomes, one of them, or ages.

Input arrays have row 0 at the bottom (OpenGL); pictures have row 0 at the top.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from shadercache.diagnostics import usage_error
from shadercache.measure.measurement import Probe
from shadercache.measure.shown import Picture
from shadercache.report.images import LEGEND, Color, hit_picture, outcome_color

ALL, HITS, AGE = "all", "hits", "age"

ALIASES = {"clip": "outside", "miss": "depth"}
"""Other words for outcomes: ``outside`` is what the clip test turns down."""

YOUNG, AGED, TOO_OLD = (24, 44, 110), (250, 216, 96), (220, 60, 160)
"""Colours of the ages: new, a period old, and older, which a guard of ages does not let be."""

_FAINT = (72, 72, 78)
_PAPER, _INK = (250, 250, 248), (32, 32, 36)
_PAD = 6


def view_names(probe: Probe) -> tuple[str, ...]:
    """The views that there are of a frame."""
    return (HITS, *probe.values, *([AGE] if probe.ages is not None else []))


def chosen_views(words: Iterable[str], probe: Probe) -> list[str]:
    """The names that are meant by what a user wrote, in that order.

    Raises :class:`UsageError` SC442 for a view that there is not.
    """
    known = view_names(probe)
    chosen: dict[str, None] = {}
    for word in words:
        name = ALIASES.get(word, word)
        if name != ALL and name not in known:
            hint = f"one of {', '.join((ALL, *known))}"
            if name == AGE:
                hint = "the cache keeps ages with --cache age=on"
            raise usage_error("SC442", f"there is no view {word!r} of these variants", hint)
        chosen |= dict.fromkeys(known if name == ALL else (name,))
    return list(chosen)


def view_picture(name: str, probe: Probe) -> Picture:
    """A view with its legend below it."""
    if name == AGE:
        assert probe.ages is not None
        shown = age_colors(probe.ages[::-1], probe.mask[::-1] != 0, probe.period)
        return with_legend(shown, _age_legend(probe))
    if name == HITS:
        shown = hit_picture(probe.mask, probe.values)
        return with_legend(shown, _outcome_legend(probe, probe.values))
    mark = probe.values[name]
    colors = np.zeros((256, 3), np.uint8)
    colors[1:] = _FAINT
    colors[mark] = outcome_color(name, mark)
    return with_legend(colors[probe.mask[::-1]], _outcome_legend(probe, [name]))


def with_legend(
    shown: Picture, entries: Iterable[tuple[Color, str]], margin: int = _PAD
) -> Picture:
    """The picture with a line for each few entries below it: a patch of colour and its meaning."""
    height, width = shown.shape[:2]
    size = max(9, min(18, width // 28))
    font = ImageFont.load_default(size)
    placed: list[tuple[int, int, Color, str]] = []
    x, y = margin, height + _PAD
    for color, words in entries:
        needed = size + _PAD + int(font.getlength(words)) + 2 * _PAD
        # The first entry of a line stands there even if it is wider than the picture.
        if x > margin and x + needed > width - margin + _PAD:
            x, y = margin, y + size + _PAD
        placed.append((x, y, color, words))
        x += needed
    sheet = Image.new("RGB", (width, y + size + 2 * _PAD), _PAPER)
    sheet.paste(Image.fromarray(shown), (0, 0))
    draw = ImageDraw.Draw(sheet)
    for x, y, color, words in placed:
        draw.rectangle((x, y + 2, x + size, y + 2 + size), fill=color)
        draw.text((x + size + _PAD, y), words, _INK, font)
    return np.asarray(sheet, np.uint8)


def _outcome_legend(probe: Probe, names: Iterable[str]) -> Iterator[tuple[Color, str]]:
    for name in names:
        color = outcome_color(name, probe.values[name])
        words = LEGEND[name][1] if name in LEGEND else name
        yield color, f"{words} {probe.shares[name]:.1%}"


def age_colors(ages: NDArray[np.float32], drawn: NDArray[np.bool_], period: int) -> Picture:
    """Ages (h, w), in frames, as colours from new to a period old; black where nothing is drawn."""
    share = np.clip(ages / period, 0.0, 1.0)[..., None]
    colors = (1.0 - share) * np.array(YOUNG) + share * np.array(AGED)
    colors[ages > period] = TOO_OLD
    colors[~drawn] = 0.0
    return np.ascontiguousarray(np.rint(colors), np.uint8)


def _age_legend(probe: Probe) -> Iterator[tuple[Color, str]]:
    assert probe.ages is not None
    steps = 4
    for step in range(steps + 1):
        part = step / steps
        red, green, blue = (round(a + part * (b - a)) for a, b in zip(YOUNG, AGED, strict=True))
        yield (red, green, blue), f"{part * probe.period:g}"
    drawn = probe.ages[probe.mask != 0]
    worst = float(drawn.max(initial=0.0))
    yield TOO_OLD, f"older; frames since computed, oldest {worst:.1f}"
