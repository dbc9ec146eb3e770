"""The pictures of the page: each once, as a data URI, as many as there is room for.

The difference is computed before anything is lost; outcomes and ages are kept as they are.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator

import numpy as np
from PIL import Image

from shadercache.caching.configuration import Configuration
from shadercache.measure.shown import Picture
from shadercache.report.debug_views import age_colors
from shadercache.report.images import difference_picture, hit_picture
from shadercache.report.parts.picture_uris import exact_uri, lossy_uri
from shadercache.sweep.pictures import AGE_STEPS
from shadercache.sweep.row import Row

THUMBNAIL = 120
"""Longest edge of what is shown under the pointer, pixels."""

_KEPT = ("original", "cached", "outcomes", "ages", "payload")
_THUMBNAIL_QUALITY = 60


class PictureShelf:
    """Pictures by name, with the room that is left for more.

    ``missing`` counts pictures that a row names and the store lacks or that cannot be read.
    """

    def __init__(self, blob: Callable[[str], bytes], room: int) -> None:
        """``blob``: a picture of the store by its hash, as ``Store.blob``; ``room`` in bytes."""
        self._blob = blob
        self._room = room
        self._reserve = room * 3 // 5
        self.uris: dict[str, str] = {}
        self.missing = 0

    def thumbnail(self, row: Row) -> str | None:
        """The name of a row's small picture, if there is one; more than two fifths of the room are
        not given to them."""
        hashed = row.pictures.get("thumbnail") or row.pictures.get("cached")
        if hashed is None or self._room <= self._reserve:
            return None
        name = f"small-{hashed}"
        if name not in self.uris:
            image = self._opened(hashed)
            if image is None:
                return None
            image.thumbnail((THUMBNAIL, THUMBNAIL))
            self.uris[name] = lossy_uri(image, _THUMBNAIL_QUALITY)
            self._room -= len(self.uris[name])
        return name

    def layers(self, row: Row) -> dict[str, str] | None:
        """The names of a row's pictures by layer, kept from now on; None where they do not fit.

        A row without pictures has none of them.
        """
        made = list(self._made(row))
        new = {name: uri for _, name, uri in made if name not in self.uris}
        size = sum(map(len, new.values()))
        if size > self._room:
            return None
        self._room -= size
        self.uris |= new
        return {layer: name for layer, name, _ in made}

    def _made(self, row: Row) -> Iterator[tuple[str, str, str]]:
        """Layer, name and data of each picture of a row."""
        hashes = row.pictures
        found = {kind: self._opened(hashes[kind]) for kind in _KEPT if kind in hashes}
        pictures = {kind: image for kind, image in found.items() if image is not None}
        for kind in ("original", "cached", "payload"):
            if kind in pictures:
                name = f"{kind}-{hashes[kind]}"
                yield kind, name, self.uris.get(name) or lossy_uri(pictures[kind])
        for layer, hashed, pixels in _layers(row, pictures):
            yield layer, f"{layer}-{hashed}", exact_uri(Image.fromarray(pixels))

    def _opened(self, hashed: str) -> Image.Image | None:
        try:
            image = Image.open(io.BytesIO(self._blob(hashed)))
            # Pillow decodes lazily; a damaged picture has to show here, where it can be left out.
            image.load()
        except (KeyError, OSError):  # OSError: Pillow cannot read it
            self.missing += 1
            return None
        return image


def _layers(row: Row, pictures: dict[str, Image.Image]) -> Iterator[tuple[str, str, Picture]]:
    """What follows from the pictures that the store keeps: layer, a hash for it, pixels."""
    hashes = row.pictures
    if "original" in pictures and "cached" in pictures:
        pair = [np.asarray(pictures[kind].convert("RGB")) for kind in ("original", "cached")]
        if pair[0].shape == pair[1].shape:
            yield "difference", hashes["cached"], difference_picture(*pair)
    if "outcomes" not in pictures or row.result is None or row.result.reuse is None:
        return
    # Stored pictures have row 0 at the top; hit_picture wants it at the bottom.
    mask = np.asarray(pictures["outcomes"].convert("L"))
    yield "hits", hashes["outcomes"], hit_picture(mask[::-1], row.result.reuse.values)
    if "ages" in pictures and row.configuration is not None:
        ages = np.asarray(pictures["ages"], np.float32) / np.float32(AGE_STEPS)
        period = Configuration.from_json(row.configuration).refresh.period
        yield "age", hashes["ages"], age_colors(ages, mask != 0, period)
