"""Pictures as texts that may stand in a page.

What is compared by eye is kept with loss, or ten pictures of noise would fill a page; what single
pixels matter of is kept as it is.
"""

from __future__ import annotations

import io
from base64 import b64encode
from typing import Any

from PIL import Image

QUALITY = 92
"""Of what is compared by eye."""


def lossy_uri(image: Image.Image, quality: int = QUALITY) -> str:
    """A picture with slight loss, as a data URI."""
    return _uri(image, quality=quality)


def exact_uri(image: Image.Image) -> str:
    """A picture as it is, as a data URI."""
    return _uri(image, lossless=True)


def _uri(image: Image.Image, **how: Any) -> str:
    buffer = io.BytesIO()
    image.convert("RGB").save(buffer, "WEBP", **how)
    return f"data:image/webp;base64,{b64encode(buffer.getvalue()).decode()}"
