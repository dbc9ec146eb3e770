"""Caching compiler for GLSL fragment shaders, with the harness that measures what it gains.

Names are loaded when they are first used (PEP 562), so that ``import shadercache`` is cheap and
imports neither numpy nor moderngl.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from shadercache.caching.configuration import Configuration
    from shadercache.compiler import analyse, rewrite
    from shadercache.diagnostics import Diagnostic, DiagnosticError
    from shadercache.front.parse import parse
    from shadercache.measure.measure import measure
    from shadercache.source import Source
    from shadercache.tuning.choose import tune
    from shadercache.verify.parallel import VerifiedScene
    from shadercache.verify.parallel import verify_in_parallel as verify

__version__ = "0.1.0"

__all__ = [
    "Configuration",
    "Diagnostic",
    "DiagnosticError",
    "Source",
    "VerifiedScene",
    "__version__",
    "analyse",
    "measure",
    "parse",
    "rewrite",
    "tune",
    "verify",
]

_HOME = {
    "Configuration": "shadercache.caching.configuration:Configuration",
    "Diagnostic": "shadercache.diagnostics:Diagnostic",
    "DiagnosticError": "shadercache.diagnostics:DiagnosticError",
    "Source": "shadercache.source:Source",
    "VerifiedScene": "shadercache.verify.parallel:VerifiedScene",
    "analyse": "shadercache.compiler:analyse",
    "measure": "shadercache.measure.measure:measure",
    "parse": "shadercache.front.parse:parse",
    "rewrite": "shadercache.compiler:rewrite",
    "tune": "shadercache.tuning.choose:tune",
    "verify": "shadercache.verify.parallel:verify_in_parallel",
}
"""Public name: the module it lives in, and its name there."""


def __getattr__(name: str) -> Any:
    """Import a public name on first use; raises AttributeError for names that do not exist."""
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    module, attribute = _HOME[name].split(":")
    value = getattr(import_module(module), attribute)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
