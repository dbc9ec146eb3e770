"""Caching compiler for GLSL fragment shaders, with the harness that measures what it gains.

Names are loaded when they are first used (PEP 562), so that ``import shadercache`` is cheap and
imports neither numpy nor moderngl.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from shadercache.compiler import Analysis, Emission, analyse, rewrite
    from shadercache.diagnostics import Diagnostic, DiagnosticError
    from shadercache.front.parse import parse
    from shadercache.options import Options
    from shadercache.source import Source

__version__ = "0.1.0"

__all__ = [
    "Analysis",
    "Diagnostic",
    "DiagnosticError",
    "Emission",
    "Options",
    "Source",
    "__version__",
    "analyse",
    "parse",
    "rewrite",
]

_HOME = {
    "Analysis": "compiler",
    "Diagnostic": "diagnostics",
    "DiagnosticError": "diagnostics",
    "Emission": "compiler",
    "Options": "options",
    "Source": "source",
    "analyse": "compiler",
    "parse": "front.parse",
    "rewrite": "compiler",
}


def __getattr__(name: str) -> Any:
    """Import a public name on first use; raises AttributeError for names that do not exist."""
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f"shadercache.{_HOME[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
