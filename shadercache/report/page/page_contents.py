"""What of the texts and pictures of a store gets into the page, where there is not room for all."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import zip_longest
from typing import Any

from shadercache.report.page.page_group import Measured, PageGroup
from shadercache.report.page.picture_shelf import PictureShelf
from shadercache.sweep.row import Row

MOST_TEXT = 16_000_000
"""Characters of shaders; packed they take about a tenth."""

Blob = Callable[[str], bytes]
"""A text or picture of the store by its hash; raises :class:`KeyError` where the store lacks it."""

Progress = Callable[[int], None]
"""Called with a number of rows whose pictures are done."""


def by_interest(groups: Sequence[PageGroup]) -> Iterator[tuple[int, Measured]]:
    """The rows of all groups that have a result, each with the number of its group: what is worth a
    look first, and the groups in turns, so that none is left without pictures by those before it.
    """
    for turn in zip_longest(*(group.worth_a_look() for group in groups)):
        yield from ((number, one) for number, one in enumerate(turn) if one is not None)


def page_texts(groups: Sequence[PageGroup], blob: Blob) -> dict[str, str]:
    """Shaders by hash, those of interesting rows first, up to :data:`MOST_TEXT`."""
    chosen: dict[str, tuple[str, str]] = {}
    room = MOST_TEXT
    for _, one in by_interest(groups):
        new = _read(one.row, blob, chosen)
        room -= sum(len(text) for _, text in new.values())
        if room < 0:
            break
        chosen |= new
    # By name, since files of one name are alike and take little room when packed together.
    return {
        hashed: text for hashed, (_, text) in sorted(chosen.items(), key=lambda item: item[1][0])
    }


def _read(row: Row, blob: Blob, known: dict[str, tuple[str, str]]) -> dict[str, tuple[str, str]]:
    """Name and text by hash of what is not known yet; what the store lacks is left out."""
    found = {}
    for name, hashed in row.texts.items():
        if hashed not in known:
            try:
                found[hashed] = name, blob(hashed).decode("utf-8", errors="replace")
            except KeyError:
                continue
    return found


def fill_pictures(
    data: dict[str, Any],
    groups: Sequence[PageGroup],
    shelf: PictureShelf,
    progress: Progress | None = None,
) -> None:
    """Add thumbnails, then whole sets of pictures, to the rows of :func:`page_data`.

    A row gets ``thumbnail``, the name of a picture, and ``layers``, names by layer; neither where
    there was no room.
    """
    shown = [group["rows"] for group in data["groups"]]
    for number, one in by_interest(groups):
        shown[number][one.place]["thumbnail"] = shelf.thumbnail(one.row)
        if progress is not None:
            progress(1)
    full: set[int] = set()
    for number, one in by_interest(groups):
        layers = None if number in full else shelf.layers(one.row)
        if layers is None:
            full.add(number)
        else:
            shown[number][one.place]["layers"] = layers
        if len(full) == len(groups):
            break
    data["pictures"], data["missing"] = shelf.uris, shelf.missing
