"""Does the driver fetch at the level of detail that it tells?

GLSL says so (4.60, section 8.9.1), and Mesa 22.3 does. The llvmpipe of 25.0 tells the true level,
and fetches at one with a fast logarithm: 1.683 where it says 1.725. What ``--fetches level`` makes
then differs from the original by what neighbouring levels of the texture do.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

import moderngl
import numpy as np

from shadercache.gpu.context import Gpu

_GLSL = Path(__file__).parent / "glsl"
_SIZE = (32, 32)
_NEEDED = 400
"""The version of ``textureQueryLod``."""


@cache
def tells_true_levels(gpu: Gpu) -> bool:
    """Are ``texture`` and ``textureLod`` at the level of ``textureQueryLod`` the same bits?"""
    ctx = gpu.ctx
    if ctx.version_code < _NEEDED:
        return False
    vertex, fragment = (
        (_GLSL / f"levels.{stage}").read_text(encoding="utf-8") for stage in ("vert", "frag")
    )
    program = ctx.program(vertex_shader=vertex, fragment_shader=fragment)
    # Noise, so that every level of detail is another picture.
    pixels = np.random.default_rng(1).random((*_SIZE, 4), dtype=np.float32)
    texture = ctx.texture(_SIZE, 4, pixels.tobytes(), dtype="f4")
    texture.build_mipmaps()
    texture.filter = moderngl.LINEAR_MIPMAP_LINEAR, moderngl.LINEAR
    target = ctx.texture(_SIZE, 1, dtype="f4")
    framebuffer = ctx.framebuffer([target])
    array = ctx.vertex_array(program, [])
    program["u_map"] = 0
    texture.use(0)
    framebuffer.use()
    ctx.enable_only(ctx.NOTHING)
    array.render(moderngl.TRIANGLES, vertices=3)
    other = np.frombuffer(target.read(), np.float32)
    for resource in (array, framebuffer, target, texture, program):
        resource.release()
    return not other.any()
