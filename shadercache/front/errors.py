"""Syntax errors in a programmer's words.

The parser stops at the first token that no shader could have there. From that token, the one
before it, the brackets that are open and the tokens that would have been right, the functions
below each recognise one kind of mistake; the first that does words the diagnostic.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from lark.exceptions import UnexpectedToken

from shadercache.ast.nodes import FunctionProto
from shadercache.diagnostics import Diagnostic
from shadercache.front import other_languages as foreign
from shadercache.front.declaration_callbacks import DeclaredHead, FullType
from shadercache.front.preprocess import is_word
from shadercache.front.tokens import Edition, Token, TokenStream
from shadercache.front.unexpected import CLOSERS, PAIRS, Unexpected, gather
from shadercache.lang import extension_words
from shadercache.lang.words import STATEMENT_WORDS, keyword_since, keywords, type_names

_STATEMENT_ENDS = frozenset((";", "{", "}", ")", ":", ""))
_JUMPS = {
    "RETURN": "return",
    "BREAK": "break",
    "CONTINUE": "continue",
    "DISCARD": "discard",
    "WHILE": "do ... while",
}


def explain(error: UnexpectedToken, stream: TokenStream) -> Diagnostic:
    """The diagnostic for the error that the parser met in a stream."""
    mistake = gather(error, stream)
    for recognise in _RECOGNISERS:
        diagnostic = recognise(mistake)
        if diagnostic is not None:
            return diagnostic
    wanted = _spell_out(mistake.right)
    shown = f"'{mistake.text}'" if mistake.text else "end of the file"
    return mistake.here(f"expected {wanted} {mistake.place}" if wanted else f"unexpected {shown}")


# --- kinds of mistakes ----------------------------------------------------------------------------


def _reserved(mistake: Unexpected) -> Diagnostic | None:
    if mistake.text == "subroutine":
        hint = "call the function directly, or choose it with a switch on a uniform"
        return mistake.here("subroutines are not supported", hint, "SC111")
    if mistake.kind != "RESERVED":
        return None
    hint = "choose another name"
    # Where a type could stand, the word was meant as one; elsewhere it was meant as a name.
    if "NAME" not in mistake.right or "BASIC_TYPE" in mistake.right:
        instead = foreign.INSTEAD_OF_RESERVED.get(mistake.text)
        hint = instead or _needs(mistake.text, mistake.language) or hint
    message = f"'{mistake.text}' is a reserved word of {mistake.language}"
    return mistake.here(message, hint, "SC106")


def _of_extension(mistake: Unexpected) -> Diagnostic | None:
    """``float16_t x;``, ``uniform f16mat2x3 m;``, ``perprimitiveEXT in vec3 v;``"""
    if mistake.kind not in ("NAME", "QUALIFIER", "BASIC_TYPE", "TYPE_NAME"):
        return None
    here, before = (mistake.text, mistake.span), (mistake.before, mistake.before_span)
    # The word before comes first: an unknown type is met only at the name behind it.
    known = keywords(*mistake.language)
    for text, span in (before, here):
        # Where the extension is on, the word is known, and the mistake another.
        if text not in known and (of_extension := extension_words.explained(text)):
            return mistake.at(span, *of_extension, "SC111")
    return None


def _needs(word: str, language: Edition) -> str | None:
    """The hint which version a word needs; ``None`` where no later one has it."""
    since = keyword_since(word, language.es)
    if since is None or since <= language.version:
        return None
    return f"it needs #version {since}{' es' if language.es else ''} or later"


def _later_keyword(mistake: Unexpected) -> Diagnostic | None:
    """A word that only another version knows, as in ``precise float x;``."""
    language = mistake.language
    here, before = (mistake.text, mistake.span), (mistake.before, mistake.before_span)
    # `switch (x) {` reads as a call up to its brace where the version has no switch.
    for text, span in (here, before, (mistake.callee, mistake.span)):
        if is_word(text) and text not in keywords(*language) and (hint := _needs(text, language)):
            return mistake.at(span, f"'{text}' has no meaning in {language}", hint, "SC106")
    return None


def _stray_word(mistake: Unexpected) -> Diagnostic | None:
    if mistake.text == "else" and mistake.before in (";", "{", "}"):
        hint = "several statements before 'else' need braces" if mistake.before == ";" else None
        return mistake.here("'else' without an 'if'", hint)
    if mistake.text in ("case", "default") and mistake.before in _STATEMENT_ENDS:
        return mistake.here(f"'{mistake.text}' outside a 'switch'")
    return None


def _wrong_closer(mistake: Unexpected) -> Diagnostic | None:
    """A closing bracket that does not fit the innermost open one."""
    if mistake.text not in CLOSERS:
        return None
    opening, _, _ = mistake.innermost
    if not mistake.openings or (opening == "{" and mistake.text != "}"):
        return mistake.here(f"this '{mistake.text}' closes nothing")
    closer = PAIRS[opening]
    if mistake.text == closer or CLOSERS[closer] not in mistake.right:
        return None
    return mistake.behind(f"expected '{closer}' {mistake.place}", _opened(mistake))


def _never_closed(mistake: Unexpected) -> Diagnostic | None:
    """A bracket that is open at the end of the file."""
    if mistake.text or not mistake.openings:
        return None
    opening, span, _ = mistake.innermost
    # Behind an unfinished expression the missing operand is the nearer mistake.
    complete = mistake.before in (";", "}", "{") or CLOSERS[PAIRS[opening]] in mistake.right
    return mistake.at(span, f"this '{opening}' is never closed") if complete else None


def _opened(mistake: Unexpected) -> str:
    opening, span, _ = mistake.innermost
    line, column = mistake.stream.source.position(span.start)
    return f"the '{opening}' at {line}:{column} is open"


def _unknown_type(mistake: Unexpected) -> Diagnostic | None:
    """``Foo bar``, where nothing says that ``Foo`` is a type."""
    if mistake.kind != "NAME":
        return None
    span, name = mistake.span, mistake.text
    # `Foo` alone reads as an expression, so the parser stops only at the name behind it.
    if "NAME" in mistake.right or "TYPE_NAME" not in mistake.right:
        span, name = mistake.before_span, mistake.before
        starts = mistake.same_line and mistake.earlier in _STATEMENT_ENDS
        if not starts or not is_word(name) or name in keywords(*mistake.language):
            return None
    if mistake.before == "," and mistake.innermost[0] == "(":
        hint: str | None = "each parameter has a type of its own"
    else:
        known = {*type_names(*mistake.language), *mistake.stream.scopes.types}
        hint = foreign.type_hint(name, known) or _outside_hint(mistake)
    return mistake.at(span, f"'{name}' is not the name of a type", hint)


def _outside_hint(mistake: Unexpected) -> str | None:
    return None if mistake.openings else "outside functions there are only declarations"


def _unfinished_block(mistake: Unexpected) -> Diagnostic | None:
    """``struct S { float a; } void main() { }``"""
    if mistake.before != "}" or not {"NAME", "SEMICOLON"} <= mistake.right:
        return None
    return mistake.behind("expected ';' after the block") if mistake.is_keyword else None


def _keyword_as_name(mistake: Unexpected) -> Diagnostic | None:
    """``float in = 1.0;``"""
    wanted = "NAME" in mistake.right and not mistake.operand_missing and mistake.same_line
    if wanted and mistake.is_keyword:
        return mistake.here(f"'{mistake.text}' is a keyword and cannot be a name", code="SC106")
    return None


def _missing_type(mistake: Unexpected) -> Diagnostic | None:
    """``const x = 1.0;``, ``uniform Foo bar;``, ``uniform;``"""
    if {"LBRACE", "COMMA"} <= mistake.right:
        if mistake.kind in ("EQUAL", "LSQB", "LPAR"):
            return mistake.at(mistake.before_span, f"expected a type before '{mistake.before}'")
        if mistake.kind == "NAME":
            message = f"'{mistake.before}' is not the name of a type"
            return mistake.at(mistake.before_span, message)
    if "BASIC_TYPE" in mistake.right and is_word(mistake.before) and not mistake.operand_missing:
        return mistake.behind(f"expected a type after '{mistake.before}'")
    return None


def _missing_name(mistake: Unexpected) -> Diagnostic | None:
    if "NAME" not in mistake.right or mistake.operand_missing or mistake.before in _STATEMENT_ENDS:
        return None
    hint = foreign.operand_hint(mistake)
    return mistake.behind(f"expected a name after '{mistake.before}'", hint)


def _missing_sign(mistake: Unexpected) -> Diagnostic | None:
    """``float a 1.0;``, ``void main { }``, ``a 1.0``"""
    if mistake.text == "{" and {"LPAR", "SEMICOLON"} <= mistake.right and is_word(mistake.before):
        return mistake.behind(f"expected '(' after '{mistake.before}'")
    if mistake.kind != "LITERAL" or mistake.operand_missing or not mistake.same_line:
        return None
    if "EQUAL" in mistake.right and _construct(mistake) == "declaration":
        return mistake.here(f"expected '=' {mistake.place}")
    operator = "BINARY" in mistake.right and mistake.openings
    return mistake.here(f"expected an operator {mistake.place}") if operator else None


def _missing_semicolon(mistake: Unexpected) -> Diagnostic | None:
    unfinished = mistake.operand_missing and mistake.before != "return"
    if "SEMICOLON" not in mistake.right or unfinished or mistake.before in (";", "{", ""):
        return None
    if mistake.text == ")":
        return mistake.behind("expected ';' before ')'")
    # On the same line a sign is more likely out of place itself than the sign of a missing ';'.
    if mistake.same_line and mistake.text not in ("", "{", "}") and not is_word(mistake.text):
        return None
    hint = _opened(mistake) if isinstance(mistake.values[-1], FunctionProto) else None
    return mistake.behind(f"expected ';' after {_construct(mistake)}", hint)


def _construct(mistake: Unexpected) -> str:
    """What stands unfinished on the parser's stack, in words."""
    for value in reversed(mistake.values):
        if isinstance(value, Token) and value.type in _JUMPS:
            return f"'{_JUMPS[value.type]}'"
        if isinstance(value, DeclaredHead) and value.type is None:
            return "the block"
        # A list of declarators begins with their type.
        if isinstance(value[0] if isinstance(value, list) and value else value, FullType):
            return "declaration"
    if isinstance(mistake.values[-1], FunctionProto):
        return "the function; one cannot be defined in another"
    return "expression" if mistake.openings else "declaration"


def _missing_closer(mistake: Unexpected) -> Diagnostic | None:
    """``f(a b)``, ``a[1;``: the innermost bracket could have been closed here."""
    opening, _, before = mistake.innermost
    closer = PAIRS[opening]
    if opening == "{" or mistake.operand_missing or CLOSERS[closer] not in mistake.right:
        return None
    listed = opening == "(" and is_word(before) and before not in STATEMENT_WORDS
    wanted = f"',' or '{closer}'" if listed and mistake.text != ";" else f"'{closer}'"
    return mistake.behind(f"expected {wanted} {mistake.place}", _opened(mistake))


def _missing_colon(mistake: Unexpected) -> Diagnostic | None:
    if "COLON" not in mistake.right:
        return None
    asked = any(isinstance(value, Token) and value.text == "?" for value in mistake.values)
    return mistake.behind(f"expected ':' after the {'second part of ?:' if asked else 'label'}")


def _missing_operand(mistake: Unexpected) -> Diagnostic | None:
    if not mistake.operand_missing:
        return None
    if "IF" in mistake.right:
        return mistake.here(f"expected a statement {mistake.place}")
    hint = foreign.operand_hint(mistake)
    return mistake.here(f"expected an expression after '{mistake.before}'", hint)


def _missing_declaration(mistake: Unexpected) -> Diagnostic | None:
    if "BASIC_TYPE" not in mistake.right:
        return None
    if mistake.before in ("", ";", "}") and not mistake.openings:
        message = f"expected a declaration, found '{mistake.text}'"
        return mistake.here(message, _outside_hint(mistake))
    return mistake.here(f"expected a type {mistake.place}")


# The first that recognises its mistake wins. So what one word gives away comes first, then brackets
# and habits of other languages, and last what is merely missing, which fits almost anywhere.
_RECOGNISERS: tuple[Callable[[Unexpected], Diagnostic | None], ...] = (
    _reserved,
    _of_extension,
    _later_keyword,
    foreign.operator,
    foreign.cast,
    foreign.else_if,
    foreign.struct_variable,
    foreign.return_type,
    foreign.second_type,
    _stray_word,
    _wrong_closer,
    _never_closed,
    _unfinished_block,
    _unknown_type,
    foreign.semantic,
    _keyword_as_name,
    _missing_closer,
    _missing_sign,
    _missing_colon,
    _missing_type,
    _missing_name,
    _missing_semicolon,
    _missing_operand,
    _missing_declaration,
)

_SPELLINGS = {
    "LPAR": "'('",
    "RPAR": "')'",
    "LSQB": "'['",
    "RSQB": "']'",
    "LBRACE": "'{'",
    "RBRACE": "'}'",
    "COMMA": "','",
    "COLON": "':'",
    "SEMICOLON": "';'",
    "WHILE": "'while'",
    "QUALIFIER": "highp, mediump or lowp",
    "BASIC_TYPE": "a type",
}


def _spell_out(terminals: Iterable[str]) -> str:
    """``'(' or ';'``; nothing where there are too many to help."""
    names = sorted(terminals)
    if len(names) > 3 or any(name not in _SPELLINGS for name in names):
        return ""
    return " or ".join(_SPELLINGS[name] for name in names)
