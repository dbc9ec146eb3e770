"""What may be assigned to, indices, and arguments that have to be constant."""

from __future__ import annotations

from collections.abc import Iterator

from shadercache.ast import nodes as n
from shadercache.lang.builtins import MOST_ELEMENTS, Signature
from shadercache.lang.types import Type, array_of
from shadercache.sema.calls import parameters
from shadercache.sema.expression_types import is_runtime_array
from shadercache.sema.facts import Symbol
from shadercache.sema.problems import ERROR
from shadercache.valid.suspect import Finding, Suspect

_READ_ONLY = {
    "const": "a constant",
    "uniform": "a uniform",
    "in": "an input",
    "param": "a constant parameter",
}
_OFFSETS = range(-8, 8)
"""Offsets of texels that every driver takes."""


def assigned(node: n.Assign, suspect: Suspect) -> Iterator[Finding]:
    """The target of an assignment is a variable that may change (GLSL 3.30 section 5.8)."""
    yield from _changed(node.target, suspect)


def stepped(node: n.Unary | n.Postfix, suspect: Suspect) -> Iterator[Finding]:
    """So is the operand of ``++`` and ``--``."""
    if node.op in ("++", "--") and suspect.type_of(node) is not ERROR:
        yield from _changed(node.operand, suspect)


def arguments(call: n.Call, suspect: Suspect) -> Iterator[Finding]:
    """And what a function writes to; offsets of texture look-ups are constant (4.60 section
    8.9)."""
    callee = suspect.tables.calls.get(call)
    if callee is None:
        return
    for arg, (_, direction) in zip(call.args, parameters(callee), strict=True):
        if direction != "in":
            yield from _changed(arg, suspect, f" by '{call.name}'")
    if not isinstance(callee, Signature) or not callee.texture:
        return
    for arg, param in zip(call.args, callee.params, strict=True):
        if param.constant and not suspect.is_constant(arg):
            message = f"this argument of '{call.name}' must be a constant expression"
            yield Finding("SC226", message, arg)
        # Gathering has limits of its own, and its constant may be a component.
        elif param.constant and "Gather" not in call.name:
            value = suspect.value(arg) or 0
            for number in value if isinstance(value, tuple) else (value,):
                if number not in _OFFSETS:
                    message = f"an offset lies between {_OFFSETS[0]} and {_OFFSETS[-1]}"
                    yield Finding("SC226", f"{message}; this is {number}", arg)
                    break


def _changed(target: n.Expr, suspect: Suspect, by: str = "") -> Iterator[Finding]:
    if suspect.type_of(target) is ERROR:
        return
    expr = target
    while not isinstance(expr, n.Name):
        if isinstance(expr, n.Member):
            whole = suspect.type_of(expr.object)
            if not whole.dims and whole.struct is None and len(set(expr.name)) < len(expr.name):
                message = f"the swizzle '{expr.name}' names a component twice{by}"
                yield Finding("SC209", message, expr)
                return
        elif not isinstance(expr, n.Index):
            message = f"this is a value, not a variable: it cannot be changed{by}"
            yield Finding("SC209", message, expr)
            return
        expr = expr.object
    symbol = suspect.tables.symbols.get(expr)
    if symbol is not None and not symbol.writable:
        message = f"'{symbol.name}' is {_read_only(symbol)}: it cannot be changed{by}"
        yield Finding("SC209", message, target)


def _read_only(symbol: Symbol) -> str:
    if symbol.block is not None:
        return "a member of a read-only block"
    return _READ_ONLY.get(symbol.kind, "read-only")


def index(node: n.Index, suspect: Suspect) -> Iterator[Finding]:
    """A constant index lies inside; some arrays have constant indices only (4.60 section 5.7)."""
    if suspect.type_of(node) is ERROR:
        return
    whole, at = suspect.type_of(node.object), suspect.value(node.index)
    size = _elements(node.object, whole)
    if isinstance(at, int) and (at < 0 or (size is not None and at >= size)):
        if whole.dims and size is not None:
            whole = array_of(whole.element, size)
        yield Finding("SC214", f"index {at} is outside of {whole}", node.index)
    if not suspect.is_constant(node.index):
        message = _dynamic(node.object, whole, suspect)
        if message is not None:
            yield Finding("SC214", message, node.index)


def _elements(array: n.Expr, whole: Type) -> int | None:
    if not whole.dims:
        return whole.cols if whole.cols > 1 else whole.rows
    most = MOST_ELEMENTS.get(array.name) if isinstance(array, n.Name) else None
    return whole.dims[0] or most


def _is_resource_array(array: n.Expr, whole: Type, suspect: Suspect) -> bool:
    """Is it an array of samplers, images or blocks that is as long as what is bound to it?"""
    if "GL_EXT_nonuniform_qualifier" not in suspect.language.extensions:
        return False
    symbol = suspect.tables.symbols.get(array) if isinstance(array, n.Name) else None
    return symbol is not None and (whole.holds_opaque or symbol.kind == "block")


def _dynamic(array: n.Expr, whole: Type, suspect: Suspect) -> str | None:
    """Why only a constant may index it."""
    language = suspect.language
    if whole.is_unsized and whole.dims[0] is None:
        symbols = suspect.tables.symbols
        if not (is_runtime_array(array, symbols) or _is_resource_array(array, whole, suspect)):
            return f"{whole} has no size yet: only a constant may index it"
    elif whole.holds_opaque and not language.indexes_samplers:
        return "before GLSL 4.00 only a constant may index an array of samplers"
    elif whole.struct is not None and whole.dims and not language.at_least(0, 320):
        symbol = suspect.tables.symbols.get(array) if isinstance(array, n.Name) else None
        if symbol is not None and symbol.kind == "block":
            return "before GLSL ES 3.20 only a constant may index an array of blocks"
    return None
