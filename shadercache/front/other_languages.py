"""Words and signs of C, HLSL and other languages where GLSL has something else.

``(float)x``, ``float3 v``, ``a -> b``, ``elseif``: each is told with what GLSL writes instead.
"""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches

from shadercache.diagnostics import Diagnostic
from shadercache.front.preprocess import is_word
from shadercache.front.unexpected import Unexpected
from shadercache.lang.words import type_names

INSTEAD_OF_RESERVED = {
    "attribute": "write 'in'",
    "varying": "write 'out' in the vertex shader and 'in' in the fragment shader",
    "class": "write 'struct'",
    "double": "write 'float'",
    "enum": "write 'const int' variables",
    "extern": "leave it out",
    "fixed": "write 'float'",
    "half": "write 'float'",
    "inline": "leave it out",
    "long": "write 'int'",
    "noinline": "leave it out",
    "public": "leave it out",
    "short": "write 'int'",
    "static": "leave it out",
    "switch": "write a chain of if and else",
    "typedef": "write a struct, or #define the name",
    "unsigned": "write 'uint'",
    **{f"{kind}vec{size}": f"write 'vec{size}'" for kind in "hf" for size in (2, 3, 4)},
}
"""What to write instead of a reserved word where a declaration begins with it."""

_VECTORS = {"float": "vec", "half": "vec", "int": "ivec", "uint": "uvec", "bool": "bvec"}
_SIZES = (2, 3, 4)
_TYPES = {
    **{f"{kind}{n}": f"{name}{n}" for kind, name in _VECTORS.items() for n in _SIZES},
    **{f"float{n}x{n}": f"mat{n}" for n in _SIZES},
    # HLSL names rows before columns, GLSL columns before rows.
    **{f"float{r}x{c}": f"mat{c}x{r}" for r in _SIZES for c in _SIZES if r != c},
    **dict.fromkeys(("Texture2D", "texture2d", "sampler"), "sampler2D"),
    **dict.fromkeys(("Texture3D", "texture3d"), "sampler3D"),
    **dict.fromkeys(("TextureCube", "texturecube"), "samplerCube"),
    **dict.fromkeys(("char", "byte", "i32"), "int"),
    **dict.fromkeys(("f32", "real", "number"), "float"),
    **dict.fromkeys(("u32", "dword"), "uint"),
    "boolean": "bool",
    "cbuffer": "uniform",
}
_UNTYPED = frozenset(("auto", "let", "var", "def", "fn", "func", "function"))

_OPERATORS = {
    "=<": "write '<='",
    "=>": "write '>='",
    "===": "write '=='",
    "!==": "write '!='",
    "<>": "write '!='",
    "**": "write pow(x, y)",
    "->": "write '.'",
    ":=": "write '='",
}
_OPERATOR_WORDS = {"and": "&&", "or": "||", "xor": "^^", "mod": "%"}
_ELSE_IF = frozenset(("elseif", "elsif", "elif"))


def type_hint(name: str, known: Iterable[str]) -> str | None:
    """What to write for a name that is no type."""
    if name in _TYPES:
        return f"write '{_TYPES[name]}'"
    if name in _UNTYPED:
        return "a declaration begins with its type"
    close = get_close_matches(name, sorted(known), 1, 0.75) if len(name) > 2 else []
    return f"did you mean '{close[0]}'?" if close else None


def operand_hint(mistake: Unexpected) -> str | None:
    """What may be meant by a sign that begins no operand."""
    if mistake.text in ("*", "&"):
        return "GLSL has no pointers"
    if mistake.text == "[" and mistake.before in ("=", "("):
        return "write an array's constructor, such as float[2](1.0, 2.0)"
    return None


def operator(mistake: Unexpected) -> Diagnostic | None:
    """``a === b``, ``a -> b``, ``a and b``"""
    span, signs = mistake.span, mistake.before + mistake.text
    if mistake.text in _OPERATOR_WORDS and "BINARY" in mistake.right:
        signs, hint = mistake.text, f"write '{_OPERATOR_WORDS[mistake.text]}'"
    elif signs in _OPERATORS and mistake.before_span.end == mistake.span.start:
        span, hint = mistake.before_span.to(mistake.span), _OPERATORS[signs]
    elif mistake.text + mistake.after == ":=":
        signs, hint = ":=", _OPERATORS[":="]
    else:
        return None
    return mistake.at(span, f"'{signs}' is no operator of GLSL", hint)


def cast(mistake: Unexpected) -> Diagnostic | None:
    """``(float)x``"""
    around = mistake.earlier, mistake.text
    if around != ("(", ")") or mistake.before not in type_names(*mistake.language):
        return None
    return mistake.here("GLSL has no casts", f"write {mistake.before}(...)")


def else_if(mistake: Unexpected) -> Diagnostic | None:
    """``elseif (a) b;``, which begins like a call."""
    if mistake.callee not in _ELSE_IF:
        return None
    return mistake.here(f"'{mistake.callee}' is no word of GLSL", "write 'else if'")


def struct_variable(mistake: Unexpected) -> Diagnostic | None:
    """``struct S s;``"""
    if mistake.earlier != "struct" or not is_word(mistake.text):
        return None
    hint = f"the name of a struct is its type: {mistake.before} {mistake.text}"
    return mistake.here(f"expected '{{' {mistake.place}", hint)


def return_type(mistake: Unexpected) -> Diagnostic | None:
    """``main() { }``"""
    if mistake.kind != "NAME" or mistake.after != "(" or mistake.openings:
        return None
    if "NAME" in mistake.right or "TYPE_NAME" not in mistake.right:
        return None
    hint = f"a function that returns nothing begins with 'void {mistake.text}('"
    return mistake.here(f"expected a type before '{mistake.text}'", hint)


def semantic(mistake: Unexpected) -> Diagnostic | None:
    """``float4 color : COLOR``"""
    declares = not mistake.operand_missing and not mistake.right.isdisjoint(("SEMICOLON", "RPAR"))
    if mistake.text != ":" or not is_word(mistake.after) or not declares:
        return None
    if mistake.innermost[0] != "{" and mistake.before == "]":
        return None
    hint = "GLSL has no semantics; variables meet by their names or by layout(location = ...)"
    return mistake.here("unexpected ':'", hint)


def second_type(mistake: Unexpected) -> Diagnostic | None:
    """``float a = 1.0, float b = 2.0;``"""
    types = type_names(*mistake.language)
    if mistake.before != "," or mistake.text not in types or mistake.operand_missing:
        return None
    if "NAME" not in mistake.right or "BASIC_TYPE" in mistake.right:
        return None
    hint = "the names share one type; a declaration with another type begins after ';'"
    return mistake.here(f"expected a name {mistake.place}", hint)
