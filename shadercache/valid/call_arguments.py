"""Arguments that have to be constant (GLSL 4.60 section 8.9): SC226."""

from __future__ import annotations

from shadercache.ast.nodes import Call, Expr
from shadercache.lang.builtins import Signature
from shadercache.valid.suspect import Suspect

_OFFSETS = range(-8, 8)


def check_call_arguments(suspect: Suspect) -> None:
    """Offsets of texture look-ups are constant expressions."""
    for call in suspect.nodes(Call):
        callee = suspect.tables.calls.get(call)
        if not isinstance(callee, Signature) or not callee.texture:
            continue
        for arg, param in zip(call.args, callee.params, strict=True):
            if not param.constant:
                continue
            if not suspect.is_constant(arg):
                message = f"this argument of '{call.name}' must be a constant expression"
                suspect.problems.error("SC226", message, arg)
            elif "Gather" not in call.name:
                _check_offset(arg, suspect)


def _check_offset(arg: Expr, suspect: Suspect) -> None:
    """All drivers have the same least and greatest offset."""
    value = suspect.value(arg) or 0
    far = [n for n in (value if isinstance(value, tuple) else (value,)) if n not in _OFFSETS]
    if far:
        message = f"an offset lies between {_OFFSETS[0]} and {_OFFSETS[-1]}; this is {far[0]}"
        suspect.problems.error("SC226", message, arg)
