"""Heads of functions, recursion, and which functions there have to be (GLSL 3.30 section 6.1)."""

from __future__ import annotations

from collections.abc import Iterator

from shadercache.ast import nodes as n
from shadercache.lang.types import VOID, Type
from shadercache.lang.words import MEMORY_QUALIFIERS, NONUNIFORM, PRECISIONS
from shadercache.sema.problems import ERROR
from shadercache.sema.scopes import Overload
from shadercache.valid.qualifier_words import words_problem
from shadercache.valid.suspect import Finding, Suspect

_RESULT_WORDS = frozenset((*PRECISIONS, "precise", NONUNIFORM))
_PARAM_WORDS = frozenset(
    (*PRECISIONS, *MEMORY_QUALIFIERS, NONUNIFORM, "precise", "const", "in", "out", "inout")
)


def function_heads(_: n.Module, suspect: Suspect) -> Iterator[Finding]:
    """Each head by itself, and beside the one that came first."""
    definitions = {function.proto for function in suspect.nodes(n.FunctionDef)}
    first: dict[Overload, Overload] = {}
    defined: set[Overload] = set()
    for proto, head in suspect.tables.heads.items():
        extra = [word for word in proto.qualifiers.words if word not in _RESULT_WORDS]
        if extra:
            message = f"'{extra[0]}' does not apply to the result of a function"
            yield Finding("SC224", message, proto.qualifiers)
        for param, kind in zip(proto.params, head.params, strict=True):
            if kind is not ERROR:
                yield from _parameter(param, kind, suspect)
        if suspect.language.es:
            yield from _of_es(proto, head, proto in suspect.nested, suspect)
        function = suspect.tables.functions[proto]
        defines = proto in definitions
        before = first.setdefault(function, head)
        if before is not head:
            yield from _declared_again(before, head, (defines, function in defined), suspect)
        if defines:
            defined.add(function)


def _parameter(param: n.Param, kind: Type, suspect: Suspect) -> Iterator[Finding]:
    words = param.qualifiers.words
    extra = [word for word in words if word not in _PARAM_WORDS]
    if extra:
        yield Finding("SC221", f"'{extra[0]}' does not apply to a parameter", param)
    if param.qualifiers.layout:
        yield Finding("SC223", "a parameter has no layout", param)
    problem = words_problem(words, suspect.language)
    if problem is not None:
        yield Finding("SC221", problem, param)
    if kind is VOID:
        yield Finding("SC204", "a parameter cannot be void", param)
    elif kind.is_unsized:
        yield Finding("SC215", "an array parameter needs a size", param)
    elif suspect.language.only_handles(kind) and param.writes_back:
        yield Finding("SC221", f"a parameter of type {kind} cannot be written", param)


def _of_es(
    proto: n.FunctionProto, head: Overload, nested: bool, suspect: Suspect
) -> Iterator[Finding]:
    """GLSL ES leaves the built-in functions alone, and declares functions at global scope only
    (ES 1.00 and 3.00 section 6.1)."""
    hidden = suspect.language.builtin_functions(proto.name)
    if suspect.language.version < 300:  # other parameters make another function
        hidden = tuple(
            signature
            for signature in hidden
            if tuple(param.type for param in signature.params) == head.params
        )
    if hidden:
        yield Finding("SC202", f"'{proto.name}' is a built-in function", proto)
    elif nested:
        yield Finding("SC221", "a function cannot be declared in another", proto)


def _declared_again(
    before: Overload, now: Overload, defines: tuple[bool, bool], suspect: Suspect
) -> Iterator[Finding]:
    """The heads of a function agree in everything; ``defines``: does this one define it, did one
    before?"""
    name, code, message = now.proto.name, "SC224", None
    if ERROR in (before.result, now.result):
        return
    if before.result is not now.result:
        message = f"'{name}' was declared to return {before.result}, not {now.result}"
    elif _qualified(before) != _qualified(now):
        message = f"'{name}' was declared with other parameter qualifiers"
    # GLSL ES 1.00 takes one prototype of a function (section 6.1).
    elif not any(defines) and suspect.language.es_version == 100:
        code, message = "SC202", f"'{name}' is declared twice"
    elif all(defines):
        code, message = "SC202", f"'{name}' with these parameters is defined twice"
    if message is not None:
        yield Finding(code, message, now.proto)


def _qualified(head: Overload) -> list[tuple[str, bool]]:
    """Direction of each parameter, and whether it is ``const``."""
    params = zip(head.directions, head.proto.params, strict=True)
    return [(direction, param.qualifiers.has("const")) for direction, param in params]


def recursion(_: n.Module, suspect: Suspect) -> Iterator[Finding]:
    """Each call that closes a cycle of calls is wrong, even one that never runs."""
    # What is done was followed to its end: all cycles through it are told.
    done: set[n.FunctionDef] = set()
    for start in suspect.tables.called:
        path: list[n.FunctionDef] = []
        stack: list[tuple[n.FunctionDef, n.Call | None]] = [(start, None)]
        while stack:
            function, call = stack.pop()
            # Without a call it is the way back: everything that the function calls is done.
            if call is None and path and path[-1] is function:
                path.pop()
                done.add(function)
            elif function in path and call is not None:
                cycle = [*path[path.index(function) :], function]
                names = " > ".join(caller.name for caller in cycle)
                yield Finding("SC216", f"recursion is not allowed: {names}", call)
            elif function not in done:
                path.append(function)
                stack.append((function, None))
                for call in reversed(suspect.tables.called[function]):
                    callee = suspect.tables.calls[call]
                    if isinstance(callee, Overload) and callee.definition in suspect.tables.called:
                        stack.append((callee.definition, call))


def definitions(_: n.Module, suspect: Suspect) -> Iterator[Finding]:
    """What is called is defined here, or in another part of the program."""
    callees = {callee for callee in suspect.tables.calls.values() if isinstance(callee, Overload)}
    for function in callees:
        if function.definition is None:
            message = f"'{function.proto.name}' is called but not defined here"
            yield Finding("SC291", message, function.proto, warning=True)


def entry_point(suspect: Suspect, needed: bool) -> Iterator[Finding]:
    """There is one ``void main()``; a part of a program may leave it to another part (section 3.8
    of 4.60)."""
    heads = suspect.tables.functions.values()
    mains = {head for head in heads if head.proto.name == "main"}
    if not any(head.definition for head in mains):
        toy = any(head.proto.name == "mainImage" for head in heads)
        hint = "files of Shadertoy are read with --dialect shadertoy" if toy else None
        message = "there is no function 'void main()'"
        yield Finding("SC217", message, suspect.module, hint, warning=not needed)
    for main in mains:
        if main.params or main.result not in (VOID, ERROR):
            yield Finding("SC217", "'main' takes no parameters and returns void", main.proto)
