"""An OpenGL context without a screen: what it runs on, and the state that is set once a frame."""

from __future__ import annotations

import ctypes
import sys
from collections.abc import Callable
from ctypes import c_uint
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import moderngl

from shadercache.diagnostics import Diagnostic, GraphicsError
from shadercache.gpu.resource import Resource
from shadercache.scene.graphics_state import GraphicsState

APT_LINE = "apt-get install -y --no-install-recommends libegl1 libgl1"
"""Brings a software OpenGL to Debian 12/13 and Ubuntu 24.04 (glcontext loads both libraries)."""

_REMEDIES = {
    "win32": "install the graphics card's driver from its maker (what Windows and remote desktops "
    "bring is OpenGL 1.1), or put Mesa's opengl32.dll beside python.exe",
    "darwin": "run it in the session of a user who is logged in at the screen: macOS brings OpenGL "
    "4.1, but none without a window server",
}

_SOFTWARE = ("llvmpipe", "softpipe", "swrast", "swiftshader")
# moderngl has no names for GL_TEXTURE_CUBE_MAP_SEAMLESS, GL_LOWER_LEFT and the clip spaces.
_SEAMLESS_CUBE_MAPS, _LOWER_LEFT = 0x884F, 0x8CA1
_CLIP = {"symmetric": 0x935E, "zero-to-one": 0x935F}


@dataclass(frozen=True, eq=False)
class Gpu(Resource):
    """One OpenGL context and the names the driver gives itself.

    Two of them in one process need ``with gpu.ctx:`` around every use; one per process is enough.
    """

    ctx: moderngl.Context
    renderer: str
    vendor: str
    version: str
    submit: Callable[[], None]
    """Hand over what was drawn, without waiting for it."""

    @property
    def is_software(self) -> bool:
        """Whether the renderer runs on the CPU: timer queries mean nothing there."""
        return _is_software(self.renderer)

    def describe(self) -> dict[str, Any]:
        """What result files say of the renderer."""
        return {
            "renderer": self.renderer,
            "vendor": self.vendor,
            "version": self.version,
            "software": self.is_software,
        }

    def release(self) -> None:
        """Destroy the context with all that lives in it."""
        self.ctx.release()


def open_context() -> Gpu:
    """A standalone context, by EGL or else by the system's default backend.

    Raises:
        GraphicsError: SC601, there is no OpenGL 3.3 here; the hint is what to do.
    """
    # Where it could be X11, that is moderngl's own choice, which needs a display. Elsewhere a
    # libEGL is a browser's or a toolkit's, and has OpenGL ES only.
    own = sys.platform in _REMEDIES
    ctx = _first_that_opens({}) if own else _first_that_opens({"backend": "egl"}, {})
    # Every engine samples cube maps across their edges today; GL keeps it off by default.
    ctx.enable_direct(_SEAMLESS_CUBE_MAPS)
    info = ctx.info
    renderer = info["GL_RENDERER"]
    # A renderer on the CPU fills the pixels of one pass while the vertices of the next are
    # processed, if only it has them: so passes are flushed. Elsewhere that is no use.
    submit = gl_function(ctx, "glFlush") if _is_software(renderer) else None
    return Gpu(ctx, renderer, info["GL_VENDOR"], info["GL_VERSION"], submit or _nothing)


def what_to_do() -> str:
    """What brings an OpenGL 3.3 to this system."""
    return _REMEDIES.get(sys.platform, f"run: sudo {APT_LINE}")


def _is_software(renderer: str) -> bool:
    return any(word in renderer.lower() for word in _SOFTWARE)


def apply_state(ctx: moderngl.Context, state: GraphicsState) -> None:
    """Set of an application's state what is not set with each draw.

    Raises:
        GraphicsError: SC605, the driver has no clip control.
    """
    ctx.polygon_offset = state.offset
    control = gl_function(ctx, "glClipControl", c_uint, c_uint)
    if control is not None:
        # GL's default is set as well: another scene of this context may have left the other one.
        control(_LOWER_LEFT, _CLIP[state.clip])
    elif state.clip != "symmetric":
        message = "this OpenGL has no glClipControl (4.5 has it)"
        raise GraphicsError(Diagnostic("SC605", message))


@lru_cache(maxsize=8)
def gl_function(
    ctx: moderngl.Context, name: str, *arguments: type[c_uint]
) -> Callable[..., None] | None:
    """A function of GL that moderngl does not have; None where the driver has none either."""
    address = ctx.mglo._context.load(name)
    # Windows has a calling convention of its own for those of the system.
    kind = getattr(ctypes, "WINFUNCTYPE", ctypes.CFUNCTYPE)
    function: Callable[..., None] | None = kind(None, *arguments)(address) if address else None
    return function


def _nothing() -> None:
    """There is nothing to do."""


def _first_that_opens(*settings: dict[str, Any]) -> moderngl.Context:
    reasons: list[str] = []
    for setting in settings:
        try:
            return moderngl.create_context(standalone=True, **setting)
        except Exception as error:  # glcontext raises plain Exception
            reasons.append(" ".join(str(error).split()))
    message = f"no usable OpenGL 3.3: {'; '.join(reasons)}"
    raise GraphicsError(Diagnostic("SC601", message, hint=what_to_do()))
