"""Textures one level of detail finer, for pictures that are shaded at half the resolution."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from ctypes import c_uint

import moderngl

from shadercache.gpu.context import gl_function
from shadercache.render.render_scene import RenderScene

# moderngl knows no bias. A negative integer is passed on as the unsigned one of the same bits.
_LOD_BIAS = 0x8501
_TARGETS = {
    moderngl.Texture: 0x0DE1,
    moderngl.TextureCube: 0x8513,
    moderngl.TextureArray: 0x8C1A,
}
_FINER, _PLAIN = 0xFFFFFFFF, 0


@contextmanager
def sharper_textures(world: RenderScene) -> Iterator[None]:
    """Inside of it, all textures with levels of detail are sampled one level finer."""
    _set_bias(world, _FINER)
    try:
        yield
    finally:
        _set_bias(world, _PLAIN)


def _set_bias(world: RenderScene, bias: int) -> None:
    change = gl_function(world.gpu.ctx, "glTexParameteri", c_uint, c_uint, c_uint)
    assert change is not None  # OpenGL has had it from its first version on
    for drawable in world.drawables:
        for name, spec in drawable.scene_object.inputs.textures.items():
            texture = drawable.texture(name)
            if spec.mipmap and texture is not None:
                # OpenGL changes what is bound to the active unit.
                texture.use(0)
                change(_TARGETS[type(texture)], _LOD_BIAS, bias)
