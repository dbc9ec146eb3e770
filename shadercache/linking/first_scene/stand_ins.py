"""Texture files: a model's own pictures, and what stands in where there is none."""

from __future__ import annotations

import io
import os
import re
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image, UnidentifiedImageError

from shadercache.diagnostics import input_error
from shadercache.files import file_stem
from shadercache.gpu.textures import MADE_NUMBERS, MAX_PIXELS
from shadercache.scene.models.parts import Picture

_FLAT = {"normal": (128, 128, 255), "emissive": (0, 0, 0)}
_SIZE = 64


class TextureFolder:
    """The files that a scene's textures are written to, in a folder beside it."""

    def __init__(self, folder: Path, final: Path) -> None:
        """Args: ``folder`` is where files are written; ``final`` what it will be called."""
        self._folder, self._final = folder, final
        self._written: dict[tuple[object, ...], str] = {}

    def picture(self, picture: Picture) -> str:
        """The path of a model's own picture, as the scene names it.

        Raises:
            InputError: SC530, it is no picture that can be read.
        """
        if isinstance(picture.data, Path) and not picture.flipped:
            return relative(picture.data, self._final)
        name = file_stem(re.sub(r"[^\w-]+", "-", picture.name).strip("-") or "picture")
        key = (id(picture.data), picture.flipped)
        if key not in self._written:
            image = _decoded(picture)
            upright = image.transpose(Image.Transpose.FLIP_TOP_BOTTOM) if picture.flipped else image
            self._save(key, name.lower(), upright)
        return self._written[key]

    def stand_in(self, role: str | None) -> str:
        """A texture for a role that the model has no picture for; squares without one."""
        key = ("stand-in", role)
        if key not in self._written:
            flat = Image.new("RGBA", (4, 4), (*_FLAT.get(role or "", (255, 255, 255)), 255))
            self._save(key, f"flat-{role}" if role else "squares", flat if role else _squares())
        return self._written[key]

    def array(self, what: str) -> str:
        """What samplers read that is no picture, by :data:`MADE_TEXTURES`: the ``faces`` of a sky,
        squares in two ``layers``, in a ``volume``, or as numbers."""
        key = ("array", what)
        if key not in self._written:
            path = self._path("sky" if what == "faces" else what, ".npz")
            pixels = np.asarray(_squares())
            if what in MADE_NUMBERS:
                arrays: dict[str, Any] = {"pixels": pixels.astype(MADE_NUMBERS[what])}
            else:
                squares = np.stack([pixels, 255 - pixels])
                arrays = {what: _sky() if what == "faces" else squares}
            np.savez_compressed(path, **arrays)
            self._written[key] = f"textures/{path.name}"
        return self._written[key]

    def _save(self, key: tuple[object, ...], name: str, image: Image.Image) -> None:
        path = self._path(name, ".png")
        image.convert("RGBA").save(path)
        self._written[key] = f"textures/{path.name}"

    def _path(self, name: str, ending: str) -> Path:
        folder = self._folder / "textures"
        folder.mkdir(exist_ok=True)
        number, path = 1, folder / f"{name}{ending}"
        while path.exists():
            number += 1
            path = folder / f"{name}-{number}{ending}"
        return path


def relative(path: Path, folder: Path) -> str:
    """A path as a scene file in a folder names it."""
    try:
        found = os.path.relpath(os.path.realpath(path), os.path.realpath(folder))
    except ValueError:  # on another drive
        found = os.path.realpath(path)
    return Path(found).as_posix()


def _decoded(picture: Picture) -> Image.Image:
    source = picture.data if isinstance(picture.data, Path) else io.BytesIO(picture.data)
    try:
        with Image.open(source, formats=("PNG", "JPEG")) as image:
            if image.width * image.height > MAX_PIXELS:
                raise ValueError(f"it has more than {MAX_PIXELS:,} pixels")
            return image.convert("RGBA")
    except UnidentifiedImageError:
        reason = "it is not a PNG or JPEG file"
    except (OSError, ValueError, SyntaxError, EOFError) as error:
        reason = str(error) or "it is broken"
    except (Image.DecompressionBombError, Image.DecompressionBombWarning) as error:
        reason = str(error)
    raise input_error("SC530", f"cannot read the picture '{picture.name}' of the model: {reason}")


def _squares() -> Image.Image:
    """Light and dark squares, so that texture coordinates can be seen."""
    row, column = np.indices((_SIZE, _SIZE)) // 8
    shade = np.where((row + column) % 2 == 0, 220, 120).astype(np.uint8)
    return Image.fromarray(np.dstack([shade, shade, shade, np.full_like(shade, 255)]), "RGBA")


def _sky() -> np.ndarray:
    """The faces of a cube map: light above, darker below."""
    faces = np.full((6, _SIZE, _SIZE, 4), 255, np.uint8)
    shade = np.linspace(230, 90, _SIZE).astype(np.uint8)[:, None]
    for face in (0, 1, 4, 5):
        faces[face, ..., :3] = np.broadcast_to(shade, (_SIZE, _SIZE))[..., None]
    faces[2, ..., :3], faces[3, ..., :3] = 230, 90
    return faces
