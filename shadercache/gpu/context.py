"""Open an OpenGL context without a screen and say what it runs on."""

from __future__ import annotations

from collections.abc import Callable
from ctypes import CFUNCTYPE
from dataclasses import dataclass
from typing import Any

import moderngl

from shadercache.diagnostics import Diagnostic, GraphicsError
from shadercache.gpu.resource import Resource

APT_LINE = "apt-get install -y --no-install-recommends libegl1 libgl1"
"""Brings a software OpenGL to Debian 12/13 and Ubuntu 24.04 (glcontext loads both libraries)."""

_SOFTWARE = ("llvmpipe", "softpipe", "swrast", "swiftshader")
_SEAMLESS_CUBE_MAPS = 0x884F  # GL_TEXTURE_CUBE_MAP_SEAMLESS; moderngl has no name for it


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
    """Hand over what was drawn, without waiting for it (``glFlush``). A renderer on the CPU fills
    the pixels of one pass while the vertices of the next are processed; elsewhere it is no use."""

    @property
    def is_software(self) -> bool:
        """Whether the renderer runs on the CPU: timer queries mean nothing there."""
        return _is_software(self.renderer)

    def describe(self) -> dict[str, Any]:
        """Renderer, vendor, version and whether it is a software renderer, for result files."""
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
        GraphicsError: SC601, there is no OpenGL 3.3 here; the hint is the line to run.
    """
    ctx = _first_that_opens({"backend": "egl"}, {})
    # Every engine samples cube maps across their edges today; GL keeps it off by default.
    ctx.enable_direct(_SEAMLESS_CUBE_MAPS)
    info = ctx.info
    renderer = info["GL_RENDERER"]
    submit = _find_flush(ctx) if _is_software(renderer) else _nothing
    return Gpu(ctx, renderer, info["GL_VENDOR"], info["GL_VERSION"], submit)


def _is_software(renderer: str) -> bool:
    return any(word in renderer.lower() for word in _SOFTWARE)


def _find_flush(ctx: moderngl.Context) -> Callable[[], None]:
    """``glFlush``, for which moderngl has no name."""
    address = ctx.mglo._context.load("glFlush")
    return CFUNCTYPE(None)(address) if address else _nothing


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
    raise GraphicsError(Diagnostic("SC601", message, hint=f"run: sudo {APT_LINE}"))
