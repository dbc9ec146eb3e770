"""Arguments that have to be constant (GLSL 4.60 section 8.9): SC226."""

from __future__ import annotations

from shadercache.ast.nodes import Call, Expr
from shadercache.lang.builtins import Signature
from shadercache.valid.subject import Subject

_OFFSETS = range(-8, 8)


def check_call_arguments(subject: Subject) -> None:
    """Offsets of texture look-ups are constant expressions."""
    for call in subject.nodes(Call):
        callee = subject.tables.calls.get(call)
        if not isinstance(callee, Signature) or not callee.texture:
            continue
        for arg, param in zip(call.args, callee.params, strict=True):
            if not param.constant:
                continue
            if not subject.is_constant(arg):
                message = f"this argument of '{call.name}' must be a constant expression"
                subject.problems.error("SC226", message, arg)
            elif "Gather" not in call.name:
                _check_offset(arg, subject)


def _check_offset(arg: Expr, subject: Subject) -> None:
    """All drivers have the same least and greatest offset."""
    value = subject.value(arg) or 0
    far = [n for n in (value if isinstance(value, tuple) else (value,)) if n not in _OFFSETS]
    if far:
        message = f"an offset lies between {_OFFSETS[0]} and {_OFFSETS[-1]}; this is {far[0]}"
        subject.problems.error("SC226", message, arg)
