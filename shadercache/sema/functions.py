"""Functions: heads, overload sets, parameters (GLSL 3.30 section 6)."""

from __future__ import annotations

from shadercache.ast.nodes import FunctionDef, FunctionProto, Param
from shadercache.lang.types import Type
from shadercache.sema.facts import Symbol
from shadercache.sema.inference_context import InferenceContext
from shadercache.sema.problems import ERROR
from shadercache.sema.scopes import FunctionSet, Overload
from shadercache.sema.typespecs import TypeResolver


class FunctionChecker:
    """Declares functions."""

    def __init__(self, context: InferenceContext, types: TypeResolver) -> None:
        self._context = context
        self._resolver = types

    def declare(self, proto: FunctionProto, definition: FunctionDef | None = None) -> Overload:
        """Enter a prototype, or the head of a definition, into the global functions."""
        context = self._context
        overload = self._overload(proto)
        context.check_block_name(proto.name, proto)
        entry = context.scopes.function_set(proto.name)
        if not isinstance(entry, FunctionSet):
            message = f"'{proto.name}' is already declared, and not as a function"
            context.problems.error("SC202", message, proto)
            entry = FunctionSet(proto.name)
        context.tables.heads[proto] = overload
        overload = entry.overloads.setdefault(overload.params, overload)
        context.tables.functions[proto] = overload
        if definition is not None:
            overload.definition = definition
        return overload

    def _overload(self, proto: FunctionProto) -> Overload:
        language, problems = self._context.language, self._context.problems
        result = self._resolver.declared(proto.type)
        if result.holds_array and not language.arrays_are_values:
            message = "this version of GLSL has no functions that return arrays"
            result = problems.error("SC224", message, proto.type)
        if result is not ERROR and (language.only_handles(result) or result.is_unsized):
            result = problems.error("SC224", f"a function cannot return {result}", proto.type)
        params = tuple(self._param_type(param) for param in proto.params)
        return Overload(proto, result, params, tuple(map(direction, proto.params)))

    def _param_type(self, param: Param) -> Type:
        return self._resolver.with_dims(self._resolver.declared(param.type), param.dims, param)

    def declare_params(self, function: FunctionDef, overload: Overload) -> None:
        """Enter the parameters into the scope of the function's body."""
        context = self._context
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


def direction(param: Param) -> str:
    """``in``, ``out`` or ``inout``."""
    return next((word for word in param.qualifiers.words if word in ("out", "inout")), "in")
