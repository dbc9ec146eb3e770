"""A contact sheet: one row for each node, one column for each kind of picture, with a legend."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from shadercache.measure.measurement import Shot
from shadercache.measure.shown import Picture, picture
from shadercache.report import images
from shadercache.report.debug_views import with_legend

COLUMN_TITLES = ("original", "cached", "10x difference", "hit map")

_PAPER = (250, 250, 248)
_INK = (32, 32, 36)
_FAINT = (110, 110, 118)
_MARGIN = 24
_GAP = 12
_TITLE = 26
_TEXT = 17


@dataclass(frozen=True, eq=False)
class SheetRow:
    """A row: the pictures of one variant, a heading, and a line of numbers beneath it."""

    shot: Shot
    heading: str
    caption: str


def contact_sheet(title: str, rows: Sequence[SheetRow], cell: int = 400) -> Picture:
    """The sheet, (h, w, 3) with row 0 at the top.

    Args:
        cell: width of each picture in pixels; heights follow the shape of the pictures.
    """
    height, width = rows[0].shot.original.shape[:2] if rows else (1, 1)
    cell_height = max(1, round(cell * height / width))
    row_height = cell_height + 2 * _TEXT + 2 * _GAP
    head = _MARGIN + _TITLE + 2 * _GAP + _TEXT + _GAP
    sheet_width = 2 * _MARGIN + 4 * cell + 3 * _GAP
    sheet_height = head + len(rows) * (row_height + _GAP)
    sheet = Image.new("RGB", (sheet_width, sheet_height), _PAPER)
    draw = ImageDraw.Draw(sheet)
    draw.text((_MARGIN, _MARGIN), title, _INK, _font(_TITLE))
    for column, name in enumerate(COLUMN_TITLES):
        x = _MARGIN + column * (cell + _GAP)
        draw.text((x, head - _TEXT - _GAP), name, _FAINT, _font(_TEXT))
    y = head
    for row in rows:
        _draw_row(sheet, row, y, (cell, cell_height))
        y += row_height + _GAP
    possible = {name for row in rows for name in row.shot.probe.values}
    legend = [entry for name, entry in images.LEGEND.items() if name in possible]
    return with_legend(np.asarray(sheet, np.uint8), legend, _MARGIN)


def _draw_row(sheet: Image.Image, row: SheetRow, y: int, size: tuple[int, int]) -> None:
    shot, draw = row.shot, ImageDraw.Draw(sheet)
    smooth, exact = Image.Resampling.LANCZOS, Image.Resampling.NEAREST
    original, cached = picture(shot.original), picture(shot.cached)
    outcomes = images.hit_picture(shot.probe.mask, shot.probe.values)
    difference = images.difference_picture(original, cached)
    # Neither the difference nor the hit map may be averaged: single pixels are what they show.
    shown = (original, smooth), (cached, smooth), (difference, exact), (outcomes, exact)
    for column, (pixels, how) in enumerate(shown):
        image = Image.fromarray(pixels).resize(size, how)
        sheet.paste(image, (_MARGIN + column * (size[0] + _GAP), y))
    below = y + size[1] + _GAP // 2
    room = sheet.width - 2 * _MARGIN
    draw.text((_MARGIN, below), _fitting(draw, row.heading, room), _INK, _font(_TEXT))
    draw.text((_MARGIN, below + _TEXT + 4), row.caption, _FAINT, _font(_TEXT))


def _fitting(draw: ImageDraw.ImageDraw, text: str, room: float) -> str:
    """The text, or its first words with dots where it is wider than ``room`` pixels."""
    kept = text
    # Fonts are proportional, so words are taken away until what is left fits.
    while kept and draw.textlength(kept if kept == text else f"{kept} ...", _font(_TEXT)) > room:
        kept = kept.rpartition(" ")[0]
    return kept if kept == text else f"{kept} ..."


def _font(size: int) -> ImageFont.FreeTypeFont | ImageFont.ImageFont:
    return ImageFont.load_default(size)
