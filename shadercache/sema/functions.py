"""Functions: heads, overload sets, recursion (GLSL 3.30 section 6)."""

from __future__ import annotations

from shadercache.ast.nodes import Call, FunctionDef, FunctionProto, Param
from shadercache.lang.types import VOID, Type
from shadercache.sema.check_context import ERROR, Context
from shadercache.sema.facts import Symbol
from shadercache.sema.qualifiers import MEMORY
from shadercache.sema.scopes import FunctionSet, Overload
from shadercache.sema.typespecs import TypeResolver

_PRECISIONS = ("highp", "mediump", "lowp")
_RESULT_WORDS = frozenset((*_PRECISIONS, "precise"))
_PARAM_WORDS = frozenset((*_PRECISIONS, *MEMORY, "precise", "const", "in", "out", "inout"))


class FunctionChecker:
    """Declares functions and, at the end, looks at all of them together."""

    def __init__(self, context: Context, types: TypeResolver) -> None:
        self._context = context
        self._resolver = types
        self._all: list[Overload] = []
        self._prototypes: dict[FunctionProto, Overload] = {}

    def prototypes(self) -> dict[FunctionProto, FunctionDef]:
        """The definition of each prototype that has one."""
        found = self._prototypes.items()
        return {proto: item.definition for proto, item in found if item.definition}

    def declare(self, proto: FunctionProto, definition: FunctionDef | None = None) -> Overload:
        """Enter a prototype, or the head of a definition, into the global functions."""
        context = self._context
        overload = self._overload(proto)
        context.check_name(proto.name, proto)
        context.check_block_name(proto.name, proto)
        self._check_version(proto, overload)
        entry = context.scopes.function_set(proto.name)
        if not isinstance(entry, FunctionSet):
            message = f"'{proto.name}' is already declared, and not as a function"
            context.error("SC202", message, proto)
            entry = FunctionSet(proto.name)
        before = entry.overloads.get(overload.params)
        if before is None:
            entry.overloads[overload.params] = overload
            self._all.append(overload)
        else:
            self._compare(before, overload, definition)
            overload = before
        if definition is None:
            self._prototypes[proto] = overload
        else:
            overload.definition = definition
        return overload

    def _check_version(self, proto: FunctionProto, overload: Overload) -> None:
        """GLSL ES leaves the built-in functions alone, and declares functions at global scope only
        (ES 1.00 and 3.00 section 6.1)."""
        context = self._context
        if not context.es:
            return
        builtin = context.builtin_functions(proto.name)
        if context.version >= 300:
            hidden = bool(builtin)
        else:
            hidden = any(tuple(p.type for p in s.params) == overload.params for s in builtin)
        if hidden:
            context.error("SC202", f"'{proto.name}' is a built-in function", proto)
        elif context.scopes.depth:
            context.error("SC221", "a function cannot be declared in another", proto)

    def _overload(self, proto: FunctionProto) -> Overload:
        result = self._resolver.declared(proto.qualifiers, proto.type)
        if result.holds_array and not self._context.arrays_are_values:
            message = "this version of GLSL has no functions that return arrays"
            result = self._context.error("SC224", message, proto.type)
        if result is not ERROR and (self._context.only_handles(result) or result.is_unsized):
            result = self._context.error("SC224", f"a function cannot return {result}", proto.type)
        extra = [word for word in proto.qualifiers.words if word not in _RESULT_WORDS]
        if extra:
            message = f"'{extra[0]}' does not apply to the result of a function"
            self._context.error("SC224", message, proto.qualifiers)
        params = tuple(self._param_type(param) for param in proto.params)
        return Overload(proto, result, params, tuple(map(direction, proto.params)))

    def _param_type(self, param: Param) -> Type:
        context = self._context
        base = self._resolver.declared(param.qualifiers, param.type)
        kind = self._resolver.with_dims(base, param.dims, param)
        if kind is ERROR:
            return kind
        words = param.qualifiers.words
        extra = [word for word in words if word not in _PARAM_WORDS]
        if extra:
            context.error("SC221", f"'{extra[0]}' does not apply to a parameter", param)
        if param.qualifiers.layout:
            context.error("SC223", "a parameter has no layout", param)
        problem = context.words_problem(words)
        if problem is not None:
            context.error("SC221", problem, param)
        if kind is VOID:
            context.error("SC204", "a parameter cannot be void", param)
        elif kind.is_unsized:
            context.error("SC215", "an array parameter needs a size", param)
        elif context.only_handles(kind) and param.writes_back:
            context.error("SC221", f"a parameter of type {kind} cannot be written", param)
        return kind

    def _compare(self, before: Overload, now: Overload, definition: FunctionDef | None) -> None:
        """A function declared again must agree in everything (section 6.1)."""
        name, context = now.proto.name, self._context
        if ERROR in (before.result, now.result):
            return
        if before.result is not now.result:
            message = f"'{name}' was declared to return {before.result}, not {now.result}"
            self._context.error("SC224", message, now.proto)
        elif _qualified(before.proto) != _qualified(now.proto):
            message = f"'{name}' was declared with other parameter qualifiers"
            self._context.error("SC224", message, now.proto)
        elif definition is before.definition is None and context.es_version == 100:
            context.error("SC202", f"'{name}' is declared twice", now.proto)
        elif definition is not None and before.definition is not None:
            message = f"'{name}' with these parameters is defined twice"
            self._context.error("SC202", message, now.proto)

    def declare_params(self, function: FunctionDef, overload: Overload) -> None:
        """Enter the parameters into the scope of the function's body."""
        context = self._context
        for param, kind in zip(function.proto.params, overload.params, strict=True):
            if param.name is None:
                continue
            context.check_name(param.name, param)
            if context.scopes.here(param.name) is not None:
                message = f"two parameters are called '{param.name}'"
                context.error("SC202", message, param)
            writable = not param.qualifiers.has("const")
            symbol = Symbol(param.name, kind, "param", param.qualifiers, param, False, writable)
            context.scopes.declare(param.name, symbol)
            context.declared[param] = symbol

    def check_all(self, needs_main: bool) -> None:
        """There is a right ``main``, nothing calls itself, what is called is defined."""
        context = self._context
        self._check_main(needs_main)
        called = {id(target) for target in context.calls.values()}
        for overload in self._all:
            if overload.definition is None and id(overload) in called:
                message = f"'{overload.proto.name}' is called but not defined here"
                context.warn("SC291", message, overload.proto)
        find_recursion(context)

    def _check_main(self, needed: bool) -> None:
        context = self._context
        mains = [item for item in self._all if item.proto.name == "main"]
        if not any(item.definition for item in mains):
            # A part of a program may leave it to another part (section 3.8 of 4.60).
            tell = context.error if needed else context.warn
            toy = any(item.proto.name == "mainImage" for item in self._all)
            hint = "files of Shadertoy are read with --dialect shadertoy" if toy else None
            tell("SC217", "there is no function 'void main()'", context.module, hint)
        for item in mains:
            if item.params or item.result not in (VOID, ERROR):
                message = "'main' takes no parameters and returns void"
                context.error("SC217", message, item.proto)


def direction(param: Param) -> str:
    """``in``, ``out`` or ``inout``."""
    return next((word for word in param.qualifiers.words if word in ("out", "inout")), "in")


def _qualified(proto: FunctionProto) -> list[tuple[str, bool]]:
    """Direction of each parameter, and whether it is ``const``."""
    return [(direction(param), param.qualifiers.has("const")) for param in proto.params]


def find_recursion(context: Context) -> None:
    """Report each call that closes a cycle of calls (section 6.1 forbids it even if never run)."""
    done: set[FunctionDef] = set()
    for start in context.called:
        path: list[FunctionDef] = []
        stack: list[tuple[FunctionDef, Call | None]] = [(start, None)]
        while stack:
            function, call = stack.pop()
            if call is None and path and path[-1] is function:
                path.pop()
                done.add(function)
            elif function in path and call is not None:
                cycle = [*path[path.index(function) :], function]
                names = " > ".join(item.name for item in cycle)
                context.error("SC216", f"recursion is not allowed: {names}", call)
            elif function not in done:
                path.append(function)
                stack.append((function, None))
                stack.extend(_user_calls(context, function))


def _user_calls(context: Context, function: FunctionDef) -> list[tuple[FunctionDef, Call | None]]:
    calls: list[tuple[FunctionDef, Call | None]] = []
    for call in reversed(context.called[function]):
        target = context.calls[call]
        if isinstance(target, Overload) and target.definition in context.called:
            calls.append((target.definition, call))
    return calls
