"""S14: what is packed into one number is never blended."""

from __future__ import annotations

import numpy as np
import pytest

from shadercache.caching.configuration import FilterKind
from shadercache.gpu.context import Gpu
from tests.configured import configured

from .criteria import Criteria
from .plane import plane

pytestmark = pytest.mark.xdist_group("gl")

PACKED = """#version 330
in vec2 v_place;
out vec4 o_color;
void main() {
    float shadow = floor(mod(v_place.x, 8.0)) / 8.0;
    float occlusion = floor(mod(v_place.y, 8.0)) / 8.0;
    TYPE pair = VALUE;
    o_color = vec4(UNPACKED, 0.0, 1.0);
}
"""
BITS = ("uint", "uint(shadow * 8.0) << 16 | uint(occlusion * 8.0)")
BITS_USE = "float(pair >> 16) / 8.0, float(pair & 65535u) / 8.0"
FLOAT = ("float", "floor(shadow * 64.0) + occlusion")
FLOAT_USE = "floor(pair) / 64.0, fract(pair)"


def worst(gpu: Gpu, kind: FilterKind, packed: tuple[str, str], use: str) -> float:
    """How far any unpacked value is from every one that the surface has, in eighths."""
    words = {"TYPE": packed[0], "VALUE": packed[1], "UNPACKED": use}
    text = PACKED
    for word, meaning in words.items():
        text = text.replace(word, meaning)
    made = plane(gpu, configured(refresh="none", filter=kind), fragment=text, payload=packed[1])
    apart = 0.0
    for frame in range(6):
        image = made.draw(frame, u_pan=(0.3 * frame, 0.2 * frame))
        eighths = image[..., :2] * 8.0
        apart = max(apart, float(np.abs(eighths - np.round(eighths)).max()))
    return apart


@pytest.mark.parametrize(
    "kind", ["bilinear", "nearest", "bilateral", "lanczos2", "mitchell", "carried"]
)
def test_integers_are_never_blended(gpu: Gpu, stress: Criteria, kind: FilterKind) -> None:
    stress.at_most("from any value that is there", worst(gpu, kind, BITS, BITS_USE) / 8.0, 1e-5)


def test_floats_that_are_packed_by_hand_need_the_nearest_texel(gpu: Gpu, stress: Criteria) -> None:
    apart = worst(gpu, "nearest", FLOAT, FLOAT_USE) / 8.0
    stress.at_most("from any value that is there", apart, 1e-5)
    assert worst(gpu, "bilinear", FLOAT, FLOAT_USE) > 0.1
