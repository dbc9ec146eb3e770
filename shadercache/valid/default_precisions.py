"""Default precisions (GLSL ES 1.00 section 4.5.3, ES 3.00 section 4.5.4).

GLSL ES wants a precision for every float, integer and sampler; desktop GLSL takes the words and
ignores them. A fragment shader has no default for ``float``.
"""

from __future__ import annotations

from collections.abc import Iterator

from shadercache.ast.nodes import (
    Block,
    For,
    FunctionDef,
    FunctionProto,
    Node,
    Param,
    PrecisionDecl,
    Switch,
    VarDecl,
    While,
)
from shadercache.ast.walk import EXPRESSIONS, children
from shadercache.lang.types import FLOAT, INT, Type
from shadercache.lang.words import PRECISIONS
from shadercache.sema.problems import ERROR
from shadercache.valid.suspect import Suspect

_ALWAYS = frozenset(("int", "sampler2D", "samplerCube", "samplerExternalOES", "atomic_uint"))
_EXPRESSIONS = frozenset(EXPRESSIONS)
_SCOPES = (FunctionDef, Block, For, While, Switch)


def check_default_precisions(suspect: Suspect) -> None:
    """What is declared has a precision, its own or a default."""
    for decl in suspect.nodes(PrecisionDecl):
        kind = _kind(decl, suspect)
        if kind not in (FLOAT, INT, ERROR) and not kind.is_opaque:
            message = f"there is no default precision of {kind}"
            suspect.problems.error("SC221", message, decl.type)
    if not suspect.language.es:
        return
    told = set(_ALWAYS)
    if suspect.language.stage == "vertex":
        told.add("float")
    for node, given in _scoped(suspect):
        kind = _kind(node, suspect)
        if not isinstance(node, PrecisionDecl):
            _require(node, kind, given, told, suspect)
        elif (sort := _sort(kind)) is not None:
            given.add(sort)


_Typed = VarDecl | Param | FunctionProto


def _kind(node: _Typed | PrecisionDecl, suspect: Suspect) -> Type:
    return suspect.tables.specs.get(node.type, ERROR)


def _scoped(suspect: Suspect) -> Iterator[tuple[_Typed | PrecisionDecl, set[str]]]:
    """What is declared, in source order, with the default precisions of its scope."""
    stack: list[tuple[Node, set[str]]] = [(suspect.module, set())]
    while stack:
        node, given = stack.pop()
        if isinstance(node, VarDecl | Param | FunctionProto | PrecisionDecl):
            yield node, given
        inner = set(given) if isinstance(node, _SCOPES) else given
        below = reversed(children(node))
        stack += [(child, inner) for child in below if type(child) not in _EXPRESSIONS]


def _require(node: _Typed, kind: Type, given: set[str], told: set[str], suspect: Suspect) -> None:
    """Complain about a type without a precision; once for each sort of type."""
    sort, problems = _sort(kind), suspect.problems
    if not PRECISIONS.isdisjoint(node.qualifiers.words):
        if sort is None and kind is not ERROR:
            problems.error("SC221", f"{kind} has no precision", node.type)
    elif sort is not None and sort not in told and sort not in given:
        told.add(sort)
        message = f"{kind} has no precision, and {sort} no default one"
        hint = f"write 'precision mediump {sort};' at the top"
        problems.error("SC228", message, node.type, hint)


def _sort(kind: Type) -> str | None:
    """The type whose default precision counts for ``kind``; ``None`` where none does."""
    if kind is ERROR or kind.struct is not None or kind.is_void:
        return None
    if kind.base is None:
        return kind.name
    return {"float": "float", "int": "int", "uint": "int"}.get(kind.base)
