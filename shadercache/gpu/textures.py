"""Texture files on the GPU: ``.png``, ``.jpg`` (8 bits a channel) and ``.npz`` (any precision).

The latter also hold cube maps, layers of an array and volumes. Values reach the shader as stored;
nothing is converted from or to sRGB.
"""

from __future__ import annotations

import struct
import zlib
from pathlib import Path

import moderngl
import numpy as np
from numpy.typing import NDArray
from PIL import Image, UnidentifiedImageError

from shadercache.diagnostics import input_error
from shadercache.gpu.context import Gpu
from shadercache.scene.npz import INFLATION, load_npz
from shadercache.scene.object_inputs import TextureSpec

GlTexture = moderngl.Texture | moderngl.TextureCube | moderngl.TextureArray | moderngl.Texture3D

_DTYPES = {"float32": "f4", "float16": "f2", "uint8": "f1", "int32": "i4", "uint32": "u4"}
_INTEGERS = {"i4": " of integers", "u4": " of unsigned integers"}
_FILTERS = {
    ("nearest", False): (moderngl.NEAREST, moderngl.NEAREST),
    ("linear", False): (moderngl.LINEAR, moderngl.LINEAR),
    ("nearest", True): (moderngl.NEAREST_MIPMAP_NEAREST, moderngl.NEAREST),
    ("linear", True): (moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR),
}

MAX_PIXELS = 1 << 26
"""Pixels of a picture: 8192 by 8192."""

_PICTURES = (".png", ".jpg", ".jpeg")

MADE_NUMBERS = {"integers": np.int32, "naturals": np.uint32}
"""What generated textures of integers are called, and what they hold."""

_ARRAYS = {
    "faces": "(6, n, n, c)",
    "layers": "(n, h, w, c)",
    "volume": "(d, h, w, c)",
    "pixels": "(h, w, c)",
}
"""The array that a ``.npz`` file has one of, and its shape."""

_KINDS = {
    moderngl.Texture: "2D texture",
    moderngl.TextureCube: "cube map",
    moderngl.TextureArray: "array texture",
    moderngl.Texture3D: "3D texture",
}


def texture_kind(texture: GlTexture) -> str:
    """What kind of sampler reads it: ``2D texture``, ``cube map``, ``array texture`` or ``3D
    texture``, perhaps ``of integers`` or ``of unsigned integers``."""
    return _KINDS[type(texture)] + _INTEGERS.get(texture.dtype, "")


def load_pixels(path: Path) -> tuple[NDArray[np.generic], str]:
    """The pixels of a texture file and whether they are a picture, faces of a cube map or layers.

    Returns:
        ``(pixels, "pixels")`` with shape (h, w, c), ``(layers, "layers")`` with shape (n, h, w, c),
        ``(volume, "volume")`` with shape (d, h, w, c),
        or ``(faces, "faces")`` with shape (6, h, h, c) in the order +X, -X, +Y, -Y, +Z, -Z;
        float32, float16 or uint8, or int32 and uint32 for samplers of integers; 1 to 4 channels.

    Raises:
        InputError: SC530 unreadable file, SC531 no such array, a wrong shape or type.
    """
    if path.suffix.lower() in _PICTURES:
        return _load_picture(path), "pixels"
    arrays = load_npz(path, "SC530", "the texture")
    what = next((name for name in _ARRAYS if name in arrays), None)
    if what is None:
        raise input_error("SC531", f"the texture {path} has none of {', '.join(_ARRAYS)}")
    pixels = arrays[what]
    if pixels.ndim == _ARRAYS[what].count(","):
        pixels = pixels[..., np.newaxis]
    _check(path, pixels, what)
    # Row 0 of a file is uploaded first: it lies at v = 0, for both kinds of file.
    return np.ascontiguousarray(pixels), what


def _load_picture(path: Path) -> NDArray[np.generic]:
    try:
        # Two decoders for strangers' files. Opening reads the header alone, so the size is checked
        # before any pixel is decoded.
        with Image.open(path, formats=("PNG", "JPEG")) as image:
            _check_size(path, image.width, image.height)
            return np.asarray(image.convert("RGBA"))
    except UnidentifiedImageError:
        reason = "it is not a PNG or JPEG file"
    except OSError as error:
        reason = error.strerror or str(error)
    # Pillow raises SyntaxError for a broken PNG.
    except (ValueError, SyntaxError, EOFError, struct.error, zlib.error) as error:
        reason = str(error) or "it is broken"
    except (Image.DecompressionBombError, Image.DecompressionBombWarning) as error:
        reason = str(error)
    raise input_error("SC530", f"cannot read the texture {path}: {reason}")


def _check_size(path: Path, width: int, height: int) -> None:
    """Refuse what is too large, and what a file of this size cannot hold."""
    if width * height > MAX_PIXELS:
        raise ValueError(f"it has {width} x {height} pixels; at most {MAX_PIXELS:,} are read")
    # A pixel may have one bit.
    if width * height > 8 * INFLATION * path.stat().st_size:
        raise ValueError(f"it claims {width} x {height} pixels, which the file does not hold")


def _check(path: Path, pixels: NDArray[np.generic], what: str) -> None:
    shape, wanted = pixels.shape, _ARRAYS[what]
    fits = len(shape) == wanted.count(",") + 1 and min(shape) > 0 and shape[-1] <= 4
    if not fits or (what == "faces" and (shape[0] != 6 or shape[1] != shape[2])):
        fault = f"has shape {shape}, not {wanted} with 1 to 4 channels"
    elif pixels.dtype.name not in _DTYPES:
        fault = f"has {pixels.dtype} values, not float32, float16, uint8, int32 or uint32"
    elif not np.isfinite(pixels).all():
        fault = "holds NaN or infinity"
    else:
        return
    raise input_error("SC531", f"the texture {path} {fault}")


def made_pixels(what: str) -> tuple[NDArray[np.generic], str]:
    """A generated texture, the same in every run: smooth blobs under noise, in four channels.

    ``what`` and the shapes are those of :func:`load_pixels`; ``integers`` and ``naturals`` are
    pixels of such.
    """
    if what in MADE_NUMBERS:
        return made_pixels("pixels")[0].astype(MADE_NUMBERS[what]), "pixels"
    depth = {"pixels": (), "faces": (6,), "layers": (4,), "volume": (16,)}[what]
    shape = (*depth, 64, 64)
    # Noise tells texels apart, blobs tell places apart.
    noise = np.random.default_rng(2008).random((*shape, 4))
    across = np.sin(np.linspace(0.0, 4.0 * np.pi, 64, endpoint=False))
    blobs = 0.5 + 0.5 * across[:, None, None] * across[None, :, None]
    return (255.0 * (0.5 * noise + 0.5 * blobs)).astype(np.uint8), what


def upload_texture(gpu: Gpu, spec: TextureSpec) -> GlTexture:
    """Load a texture file into GL with its sampling state.

    Raises:
        InputError: SC530, SC531 as ``load_pixels``.
    """
    pixels, what = made_pixels(spec.path.name) if spec.generated else load_pixels(spec.path)
    texture = _create(gpu.ctx, pixels, what)
    # Integers are never mixed.
    if texture.dtype in _INTEGERS:
        texture.filter = _FILTERS["nearest", False]
    else:
        if spec.mipmap:
            texture.build_mipmaps()
        texture.filter = _FILTERS[spec.filter, spec.mipmap]
    # A cube map is sampled by direction, and has nothing beyond its edges.
    if not isinstance(texture, moderngl.TextureCube):
        texture.repeat_x = texture.repeat_y = spec.wrap == "repeat"
    if isinstance(texture, moderngl.Texture3D):
        texture.repeat_z = spec.wrap == "repeat"
    # A volume has no direction in which it is seen at a slant.
    elif spec.anisotropy > 1.0:
        texture.anisotropy = min(spec.anisotropy, gpu.ctx.max_anisotropy)
    return texture


def _create(ctx: moderngl.Context, pixels: NDArray[np.generic], what: str) -> GlTexture:
    height, width, channels = pixels.shape[-3:]
    kind, data = _DTYPES[pixels.dtype.name], pixels.tobytes()
    if what == "faces":
        return ctx.texture_cube((width, height), channels, data, dtype=kind)
    if what == "layers":
        return ctx.texture_array((width, height, len(pixels)), channels, data, dtype=kind)
    if what == "volume":
        return ctx.texture3d((width, height, len(pixels)), channels, data, dtype=kind)
    return ctx.texture((width, height), channels, data, dtype=kind)
