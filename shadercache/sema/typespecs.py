"""Types as written: names, struct definitions, array sizes."""

from __future__ import annotations

from shadercache.ast.nodes import Dims, Expr, Node, Qualifiers, StructDef, TypeSpec, VarDecl
from shadercache.lang.builtins import struct
from shadercache.lang.types import INT, UINT, VOID, Type, array_of, builtin_type, struct_type
from shadercache.sema.inference_context import InferenceContext
from shadercache.sema.problems import ERROR


def declared(context: InferenceContext, spec: TypeSpec) -> Type:
    """The type of something that is declared with this specifier."""
    kind = resolve(context, spec)
    if spec.dims and kind is not ERROR and not context.language.arrays_are_values:
        message = f"the size of an array stands behind its name: {kind.element} x[...]"
        return context.problems.error("SC221", message, spec)
    return kind


def check_layout(context: InferenceContext, qualifiers: Qualifiers) -> None:
    """The types of the values in a ``layout(...)``."""
    for entry in qualifiers.layout or ():
        if entry.value is not None:
            context.check(entry.value)


def resolve(context: InferenceContext, spec: TypeSpec) -> Type:
    """The type a specifier stands for, whose struct it may define; ``ERROR`` after a diagnostic."""
    kind = _named(context, spec)
    if spec.dims:
        kind = with_dims(context, kind, spec.dims, spec)
    context.tables.specs[spec] = kind
    return kind


def _named(context: InferenceContext, spec: TypeSpec) -> Type:
    if spec.struct is not None:
        return _define(context, spec.struct)
    # The user's first: a struct may have the name of a type that this version lacks.
    meaning = context.scopes.visible.get(spec.name) or builtin_type(spec.name)
    if meaning is None and spec.name.startswith("gl_"):
        meaning = struct(spec.name)
    if isinstance(meaning, Type):
        return meaning
    if meaning is not None:
        return context.problems.error("SC204", f"'{spec.name}' is not a type here", spec)
    return context.problems.undeclared("type", spec.name, spec, context.scopes.names)


def with_dims(context: InferenceContext, element: Type, dims: Dims, node: Node) -> Type:
    """``element`` with array sizes around it; ``node`` is blamed for what is wrong."""
    if not dims or element is ERROR:
        # Every expression has a type in the tables, so sizes are checked here too.
        for size in dims:
            if size is not None:
                context.check(size)
        return element
    if element is VOID:
        return context.problems.error("SC204", "an array of void", node)
    kind = element
    # `float a[2][3]` is two arrays of three floats: the last size is the innermost one.
    for size in reversed(dims):
        number = None if size is None else _size(context, size)
        if number == 0:
            return ERROR
        kind = array_of(kind, number)
    if len(kind.dims) > 1 and not context.language.at_least(430, 310):
        return context.problems.error("SC225", "arrays of arrays need GLSL 4.30", node)
    return kind


def _size(context: InferenceContext, size: Expr) -> int:
    """A constant positive integer; 0 after a diagnostic."""
    kind, constants = context.check(size), context.constants
    value = constants.values.get(size)
    if kind is ERROR:
        return 0
    if kind not in (INT, UINT) or size not in constants.expressions:
        message = "an array size is a constant integer"
    elif not isinstance(value, int):
        message = "the value of this array size cannot be computed"
    elif value <= 0:
        message = f"an array size is positive, not {value}"
    else:
        return value
    context.problems.error("SC215", message, size)
    return 0


def _define(context: InferenceContext, struct: StructDef) -> Type:
    """Declare the struct in the current scope (section 4.1.8)."""
    kind = struct_type(struct.name, members(context, struct.fields, f"struct {struct.name}"))
    if kind.struct is not None:
        context.tables.structs[kind.struct] = struct
    if not struct.name:
        return kind
    if context.scopes.here(struct.name) is not None:
        message = f"'{struct.name}' is declared twice in the same scope"
        return context.problems.error("SC202", message, struct)
    context.check_block_name(struct.name, struct)
    context.scopes.declare(struct.name, kind)
    return kind


def members(context: InferenceContext, decls: tuple[VarDecl, ...], owner: str) -> dict[str, Type]:
    """Names and types of the members of a struct or block."""
    fields: dict[str, Type] = {}
    for decl in decls:
        base = declared(context, decl.type)
        if base is VOID:
            base = context.problems.error("SC204", "a member cannot be void", decl.type)
        for declarator in decl.declarators:
            if declarator.name in fields:
                message = f"{owner.rstrip()} has two members '{declarator.name}'"
                context.problems.error("SC202", message, declarator)
            fields[declarator.name] = with_dims(context, base, declarator.dims, declarator)
    return fields
