"""Heads of functions, and which of them there have to be (GLSL 3.30 section 6.1)."""

from __future__ import annotations

from shadercache.ast.nodes import DeclStmt, FunctionDef, FunctionProto, Param
from shadercache.lang.types import VOID, Type
from shadercache.lang.words import MEMORY_QUALIFIERS, PRECISIONS
from shadercache.sema.problems import ERROR
from shadercache.sema.scopes import Overload
from shadercache.valid.qualifier_words import words_problem
from shadercache.valid.suspect import Suspect

_RESULT_WORDS = frozenset((*PRECISIONS, "precise"))
_PARAM_WORDS = frozenset(
    (*PRECISIONS, *MEMORY_QUALIFIERS, "precise", "const", "in", "out", "inout")
)


def check_function_heads(suspect: Suspect) -> None:
    """Each head by itself, and beside the one that came first."""
    nested = {statement.decl for statement in suspect.nodes(DeclStmt)}
    definitions = {function.proto for function in suspect.nodes(FunctionDef)}
    first: dict[Overload, FunctionProto] = {}
    defined: set[Overload] = set()
    for proto, head in suspect.tables.heads.items():
        _check_result(proto, suspect)
        for param, kind in zip(proto.params, head.params, strict=True):
            _check_param(param, kind, suspect)
        if suspect.language.es:
            _check_builtin(proto, head, proto in nested, suspect)
        function = suspect.tables.functions[proto]
        defines = proto in definitions
        before = suspect.tables.heads[first.setdefault(function, proto)]
        if before is not head:
            _compare(before, head, defines, function in defined, suspect)
        if defines:
            defined.add(function)


def _check_result(proto: FunctionProto, suspect: Suspect) -> None:
    extra = [word for word in proto.qualifiers.words if word not in _RESULT_WORDS]
    if extra:
        message = f"'{extra[0]}' does not apply to the result of a function"
        suspect.problems.error("SC224", message, proto.qualifiers)


def _check_param(param: Param, kind: Type, suspect: Suspect) -> None:
    if kind is ERROR:
        return
    problems, words = suspect.problems, param.qualifiers.words
    extra = [word for word in words if word not in _PARAM_WORDS]
    if extra:
        problems.error("SC221", f"'{extra[0]}' does not apply to a parameter", param)
    if param.qualifiers.layout:
        problems.error("SC223", "a parameter has no layout", param)
    problem = words_problem(words, suspect.language)
    if problem is not None:
        problems.error("SC221", problem, param)
    if kind is VOID:
        problems.error("SC204", "a parameter cannot be void", param)
    elif kind.is_unsized:
        problems.error("SC215", "an array parameter needs a size", param)
    elif suspect.language.only_handles(kind) and param.writes_back:
        problems.error("SC221", f"a parameter of type {kind} cannot be written", param)


def _check_builtin(proto: FunctionProto, head: Overload, nested: bool, suspect: Suspect) -> None:
    """GLSL ES leaves the built-in functions alone, and declares functions at global scope only
    (ES 1.00 and 3.00 section 6.1)."""
    builtin = suspect.language.builtin_functions(proto.name)
    if suspect.language.version >= 300:
        hidden = bool(builtin)
    else:
        hidden = any(tuple(p.type for p in s.params) == head.params for s in builtin)
    if hidden:
        suspect.problems.error("SC202", f"'{proto.name}' is a built-in function", proto)
    elif nested:
        suspect.problems.error("SC221", "a function cannot be declared in another", proto)


def _compare(
    before: Overload, now: Overload, defines: bool, is_defined: bool, suspect: Suspect
) -> None:
    """A function declared again must agree in everything (section 6.1)."""
    name, problems = now.proto.name, suspect.problems
    if ERROR in (before.result, now.result):
        return
    if before.result is not now.result:
        message = f"'{name}' was declared to return {before.result}, not {now.result}"
        problems.error("SC224", message, now.proto)
    elif _qualified(before) != _qualified(now):
        message = f"'{name}' was declared with other parameter qualifiers"
        problems.error("SC224", message, now.proto)
    elif not defines and not is_defined and suspect.language.es_version == 100:
        problems.error("SC202", f"'{name}' is declared twice", now.proto)
    elif defines and is_defined:
        message = f"'{name}' with these parameters is defined twice"
        problems.error("SC202", message, now.proto)


def _qualified(head: Overload) -> list[tuple[str, bool]]:
    """Direction of each parameter, and whether it is ``const``."""
    params = zip(head.directions, head.proto.params, strict=True)
    return [(direction, param.qualifiers.has("const")) for direction, param in params]


def check_definitions(suspect: Suspect) -> None:
    """What is called is defined here, or in another part of the program."""
    missing = {
        callee
        for callee in suspect.tables.calls.values()
        if isinstance(callee, Overload) and callee.definition is None
    }
    for function in missing:
        message = f"'{function.proto.name}' is called but not defined here"
        suspect.problems.warn("SC291", message, function.proto)


def check_main(suspect: Suspect, *, needed: bool) -> None:
    """There is one ``void main()``; a part of a program may leave it to another part (section 3.8
    of 4.60)."""
    heads = suspect.tables.functions.values()
    mains = {item for item in heads if item.proto.name == "main"}
    if not any(item.definition for item in mains):
        tell = suspect.problems.error if needed else suspect.problems.warn
        toy = any(item.proto.name == "mainImage" for item in heads)
        hint = "files of Shadertoy are read with --dialect shadertoy" if toy else None
        tell("SC217", "there is no function 'void main()'", suspect.module, hint)
    for item in mains:
        if item.params or item.result not in (VOID, ERROR):
            message = "'main' takes no parameters and returns void"
            suspect.problems.error("SC217", message, item.proto)
