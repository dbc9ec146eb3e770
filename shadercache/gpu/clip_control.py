"""The part of an application's state that moderngl sets once, and clip space, for which it has no
name."""

from __future__ import annotations

from collections.abc import Callable
from ctypes import CFUNCTYPE, c_uint
from functools import lru_cache

import moderngl

from shadercache.diagnostics import Diagnostic, GraphicsError
from shadercache.scene.graphics_state import GraphicsState

_LOWER_LEFT, _CLIP = 0x8CA1, {"symmetric": 0x935E, "zero-to-one": 0x935F}


def apply_state(ctx: moderngl.Context, state: GraphicsState) -> None:
    """Set what is not set with each draw.

    Raises:
        GraphicsError: SC605, the driver has no clip control.
    """
    ctx.polygon_offset = state.offset
    control = _clip_control(ctx)
    if control is not None:
        control(_LOWER_LEFT, _CLIP[state.clip])
    elif state.clip != "symmetric":
        message = "this OpenGL has no glClipControl (4.5 has it)"
        raise GraphicsError(Diagnostic("SC605", message))


@lru_cache(maxsize=4)
def _clip_control(ctx: moderngl.Context) -> Callable[[int, int], None] | None:
    """``glClipControl``, for which moderngl has no name."""
    address = ctx.mglo._context.load("glClipControl")
    return CFUNCTYPE(None, c_uint, c_uint)(address) if address else None
