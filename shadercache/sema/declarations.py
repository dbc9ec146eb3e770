"""Declarations: variables (GLSL 3.30 section 4), interface blocks (4.3.7), functions (6)."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from shadercache.ast import nodes as n
from shadercache.lang.types import VOID, Type, array_of, struct_type
from shadercache.sema.facts import Kind, Symbol
from shadercache.sema.inference_context import InferenceContext
from shadercache.sema.language import NEVER
from shadercache.sema.problems import ERROR
from shadercache.sema.scopes import FunctionSet, Overload
from shadercache.sema.storage import storage_of
from shadercache.sema.typespecs import check_layout, declared, members, resolve, with_dims

BUILTIN_BLOCK = "gl_PerVertex"
"""The block that a vertex shader may declare again."""


# --- variables ------------------------------------------------------------------------------------


def _declare_variables(context: InferenceContext, decl: n.VarDecl) -> None:
    """Declare variables, global or local, each after its initialiser is checked: that of ``x``
    still sees the ``x`` outside (section 4.2.2)."""
    base = declared(context, decl.type)
    local = context.scopes.depth > 0
    kind = storage_of(decl.qualifiers, context.language.stage, local=local)
    if base is VOID:
        base = context.problems.error("SC204", "a variable cannot be void", decl.type)
    for declarator in decl.declarators:
        of_type = with_dims(context, base, declarator.dims, declarator)
        init = declarator.init
        if init is not None:
            given = _initialiser_type(context, init, of_type)
            if given is not ERROR and of_type is not ERROR:
                of_type = _initialised(context, declarator, of_type, given, kind)
        writable = kind in ("local", "global", "out")
        symbol = Symbol(
            declarator.name, of_type, kind, decl.qualifiers, declarator, not local, writable
        )
        _enter(context, symbol, declarator)
        if kind == "const" and init in context.constants.expressions and of_type is not ERROR:
            context.constants.declare(symbol, init)
    check_layout(context, decl.qualifiers)


def _initialised(
    context: InferenceContext, node: n.Declarator, of_type: Type, given: Type, kind: Kind
) -> Type:
    """The type of a variable with an initialiser: sized by it where it has no size."""
    language, code = context.language, "SC221"
    sized = given if of_type.is_unsized and _fills(given, of_type) else of_type
    if kind == "uniform" and not language.at_least(120, NEVER):
        message = "this version of GLSL has no uniforms with a value"
    elif of_type.holds_array and not language.arrays_are_values:
        code, message = "SC210", "this version of GLSL has no arrays with a value"
    elif kind in ("in", "out"):
        message = f"'{node.name}' is an '{kind}' variable: it has no initialiser"
    elif given is VOID or not language.conversions.converts(given, sized):
        message = f"cannot initialise '{node.name}' of type {of_type} with {given}"
        return context.problems.error("SC210", message, node.init or node)
    else:
        return sized
    return context.problems.error(code, message, node)


def _enter(context: InferenceContext, symbol: Symbol, node: n.Declarator | n.BlockDecl) -> None:
    """Declare a variable, unless the scope has the name; an unsized array may be given its size,
    and a built-in variable other qualifiers."""
    scopes = context.scopes
    if symbol.name.startswith("gl_") and not scopes.depth:
        known = context.language.builtin_variable(symbol.name)
        if known is not None and known.storage != "const":
            # Declared again it is still the built-in variable, with all that is known of that.
            symbol = replace(symbol, kind="builtin", writable=known.storage == "out")
    before = scopes.here(symbol.name)
    if before is not None and not _may_follow(before, symbol):
        what = "a function" if isinstance(before, FunctionSet) else "declared"
        message = f"'{symbol.name}' is already {what} in this scope"
        context.problems.error("SC202", message, node)
    context.check_block_name(symbol.name, node)
    # Even after a mistake, or each use would be told as undeclared.
    scopes.declare(symbol.name, symbol)
    context.tables.declared[node] = symbol


def _may_follow(before: object, symbol: Symbol) -> bool:
    """May the same scope declare this again? A built-in variable; an array without a size, to give
    it one (section 4.1.9)."""
    if not isinstance(before, Symbol):
        return False
    if symbol.kind == "builtin":
        return True
    sizes = before.type.is_unsized and symbol.type.is_array
    return sizes and before.type.element is symbol.type.element


def _fills(given: Type, declared: Type) -> bool:
    """Is ``given`` the array ``declared`` with all its sizes?"""
    while declared.dims and len(given.dims) == len(declared.dims):
        if declared.dims[0] not in (None, given.dims[0]):
            return False
        given, declared = given.element, declared.element
    return given is declared


def _qualify(context: InferenceContext, decl: n.QualifierDecl) -> None:
    """``invariant gl_Position;``, or ``layout(std140) uniform;`` for what follows."""
    if not decl.names:
        check_layout(context, decl.qualifiers)
    for name in decl.names:
        symbol, known = context.scopes.visible.get(name), context.language.builtin_variable(name)
        if not isinstance(symbol, Symbol):
            if known is None:
                context.problems.undeclared("variable", name, decl, context.known_variables)
                continue
            symbol = Symbol(name, known.type, "builtin", writable=known.storage == "out")
        context.tables.qualified.setdefault(decl, []).append(symbol)


# --- initialisers ---------------------------------------------------------------------------------


def _initialiser_type(context: InferenceContext, init: n.Expr, wanted: Type) -> Type:
    """The type of an initialiser of something that is declared as ``wanted``.

    A list in braces (GLSL 4.20 section 4.1.11) has no type of its own: it gets that of what it
    initialises, and each item that of the part it stands for.
    """
    if not isinstance(init, n.InitList):
        return context.check(init)
    # Lists nest only as deep as brackets may, so this may recurse.
    kind, count = wanted, len(init.items)
    if wanted.dims and wanted.dims[0] is None:
        kind = array_of(wanted.element, count)
    room = _room(kind, count)
    if room != count:
        takes = "no list of items" if room is None else f"{room} items"
        kind = context.problems.error("SC219", f"{kind} takes {takes} here", init)
    if kind.is_struct and kind.struct is not None:
        parts = list(kind.struct.fields.values())
    else:
        parts = [ERROR if kind is ERROR else kind.element] * count
    given = [_initialiser_type(context, *pair) for pair in zip(init.items, parts, strict=True)]
    if kind is not ERROR:
        kind = _settled(context, init, kind, parts, given)
    context.tables.types[init] = kind
    if kind is not ERROR and context.constants.expressions.issuperset(init.items):
        context.constants.fold(init, init.items)
    return kind


def _room(kind: Type, count: int) -> int | None:
    """How many items a list for ``kind`` has; ``None`` where there can be no list."""
    if kind is ERROR:
        return count
    if kind.dims:
        return kind.dims[0] or count
    if kind.struct is not None:
        return len(kind.struct.fields)
    size = kind.cols if kind.is_matrix else kind.rows
    return size if size > 1 else None


def _settled(
    context: InferenceContext, node: n.InitList, kind: Type, parts: list[Type], given: list[Type]
) -> Type:
    """The type of the list, where every item converts to its part."""
    if ERROR in given:
        return ERROR
    if kind.dims and kind.element.is_unsized and len(set(given)) == 1:
        return array_of(given[0], len(given))
    for value, part, item_type in zip(node.items, parts, given, strict=True):
        if item_type is VOID or not context.language.conversions.converts(item_type, part):
            message = f"cannot initialise a part of type {part} with {item_type}"
            return context.problems.error("SC210", message, value)
    return kind


# --- blocks ---------------------------------------------------------------------------------------


def _declare_block(context: InferenceContext, block: n.BlockDecl) -> None:
    """Members of a block without instance name are global names; otherwise they are fields of the
    instance."""
    storage = storage_of(block.qualifiers, context.language.stage, local=False)
    fields = members(context, block.fields, f"block {block.name}")
    context.tables.fields[block] = fields
    for qualifiers in (block.qualifiers, *(decl.qualifiers for decl in block.fields)):
        check_layout(context, qualifiers)
    # The name is a global one, and one block of each storage may have it.
    stored = context.blocks.setdefault(block.name, set())
    if storage in stored or context.scopes.here(block.name) is not None:
        message = f"'{block.name}' is already declared in this scope"
        context.problems.error("SC202", message, block)
    stored.add(storage)
    writable = storage in ("buffer", "out")
    if block.instance is not None:
        kind = with_dims(context, struct_type(block.name, fields), block.dims, block)
        instance = Symbol(
            block.instance, kind, "block", block.qualifiers, block, True, writable, block
        )
        _enter(context, instance, block)
        return
    for decl in block.fields:
        for node in decl.declarators:
            kind = fields[node.name]
            member = Symbol(node.name, kind, storage, decl.qualifiers, node, True, writable, block)
            _enter(context, member, node)


# --- functions ------------------------------------------------------------------------------------


def declare_function(
    context: InferenceContext, proto: n.FunctionProto, definition: n.FunctionDef | None = None
) -> Overload:
    """Enter a prototype, or the head of a definition, into the global functions."""
    head = _head(context, proto)
    context.check_block_name(proto.name, proto)
    entry = context.scopes.function_set(proto.name)
    if not isinstance(entry, FunctionSet):
        message = f"'{proto.name}' is already declared, and not as a function"
        context.problems.error("SC202", message, proto)
        # A set that nobody can call, so that the body is checked all the same.
        entry = FunctionSet()
    # One overload for all heads: a call that was resolved by a prototype leads to the definition.
    overload = entry.setdefault(head.params, head)
    context.tables.heads[proto], context.tables.functions[proto] = head, overload
    if definition is not None:
        overload.definition = definition
    return overload


def _head(context: InferenceContext, proto: n.FunctionProto) -> Overload:
    language, problems = context.language, context.problems
    result = declared(context, proto.type)
    if result.holds_array and not language.arrays_are_values:
        message = "this version of GLSL has no functions that return arrays"
        result = problems.error("SC224", message, proto.type)
    if result is not ERROR and (language.only_handles(result) or result.is_unsized):
        result = problems.error("SC224", f"a function cannot return {result}", proto.type)
    params = tuple(
        with_dims(context, declared(context, param.type), param.dims, param)
        for param in proto.params
    )
    return Overload(proto, result, params, tuple(map(_direction, proto.params)))


def _direction(param: n.Param) -> str:
    """``in``, ``out`` or ``inout``."""
    return next((word for word in param.qualifiers.words if word in ("out", "inout")), "in")


def declare_params(context: InferenceContext, function: n.FunctionDef, overload: Overload) -> None:
    """Enter the parameters into the scope of the function's body."""
    for param, kind in zip(function.proto.params, overload.params, strict=True):
        if param.name is None:
            continue
        if context.scopes.here(param.name) is not None:
            message = f"two parameters are called '{param.name}'"
            context.problems.error("SC202", message, param)
        writable = not param.qualifiers.has("const")
        symbol = Symbol(param.name, kind, "param", param.qualifiers, param, False, writable)
        context.scopes.declare(param.name, symbol)
        context.tables.declared[param] = symbol


# --- all ------------------------------------------------------------------------------------------

_DECLARE: dict[type, Callable[[InferenceContext, Any], object]] = {
    n.VarDecl: _declare_variables,
    n.BlockDecl: _declare_block,
    n.FunctionProto: declare_function,
    n.QualifierDecl: _qualify,
    n.PrecisionDecl: lambda context, decl: resolve(context, decl.type),
}


def declare(context: InferenceContext, decl: n.Decl) -> None:
    """Any declaration but the definition of a function, global or local."""
    _DECLARE[type(decl)](context, decl)
