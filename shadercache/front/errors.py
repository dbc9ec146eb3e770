"""Syntax errors in a programmer's words.

The parser stops at the first token that no shader could have there. From that token, the one
before it, the brackets that are open and the tokens that would have been right, the functions
below each recognise one kind of mistake; the first that does words the diagnostic.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

from lark.exceptions import UnexpectedToken

from shadercache.ast.nodes import FunctionProto
from shadercache.diagnostics import Diagnostic
from shadercache.front.build_declarations import FullType, Head
from shadercache.front.lexis import is_word
from shadercache.front.tokens import Language, Token, TokenStream
from shadercache.lang.words import STATEMENT_WORDS, keyword_since, keywords
from shadercache.source import Source, Span

_PAIRS = {"(": ")", "[": "]", "{": "}"}
_CLOSERS = {")": "RPAR", "]": "RSQB", "}": "RBRACE"}
_INSTEAD = {
    "attribute": "write 'in'",
    "varying": "write 'out' in the vertex shader and 'in' in the fragment shader",
    "unsigned": "write 'uint'",
    "double": "write 'float'",
    "switch": "write a chain of if and else",
    **{f"{kind}vec{size}": f"write 'vec{size}'" for kind in "hf" for size in (2, 3, 4)},
}
_STATEMENT_ENDS = frozenset((";", "{", "}", ")", ":", ""))
_JUMPS = {
    "RETURN": "return",
    "BREAK": "break",
    "CONTINUE": "continue",
    "DISCARD": "discard",
    "WHILE": "do ... while",
}


@dataclass(frozen=True)
class _Mistake:
    """What is known about a syntax error.

    ``text``, ``before`` and ``earlier`` are the spellings of the unexpected token and of the two
    before it, empty outside the file. ``openings`` has the brackets that are open, innermost last,
    each with the spelling before it. ``right`` has the terminals that could have come.
    """

    source: Source
    language: Language
    text: str
    kind: str
    span: Span
    before: str
    before_span: Span
    earlier: str
    openings: list[tuple[str, Span, str]]
    right: frozenset[str]
    values: list[Any]

    def at(
        self, span: Span, message: str, hint: str | None = None, code: str = "SC103"
    ) -> Diagnostic:
        return Diagnostic(code, message, self.source, span, hint)

    def here(self, message: str, hint: str | None = None, code: str = "SC103") -> Diagnostic:
        return self.at(self.span, message, hint, code)

    def behind(self, message: str, hint: str | None = None) -> Diagnostic:
        """At the end of the token before, where something is missing."""
        return self.at(Span(self.before_span.end, self.before_span.end), message, hint)

    @property
    def place(self) -> str:
        """The unexpected token as the end of a sentence."""
        return f"before '{self.text}'" if self.text else "at the end of the file"

    @property
    def operand_missing(self) -> bool:
        return "LITERAL" in self.right

    @property
    def same_line(self) -> bool:
        return "\n" not in self.source.excerpt(Span(self.before_span.end, self.span.start))


def explain(error: UnexpectedToken, stream: TokenStream) -> Diagnostic:
    """The diagnostic for the error that the parser met in a stream."""
    mistake = _gather(error, stream)
    for recognise in _RECOGNISERS:
        diagnostic = recognise(mistake)
        if diagnostic is not None:
            return diagnostic
    wanted = _spell_out(mistake.right)
    shown = f"'{mistake.text}'" if mistake.text else "end of the file"
    return mistake.here(f"expected {wanted} {mistake.place}" if wanted else f"unexpected {shown}")


def _gather(error: UnexpectedToken, stream: TokenStream) -> _Mistake:
    lexemes = stream.lexemes
    index = len(lexemes.texts) if error.token.type == "$END" else stream.index
    parser: Any = error.interactive_parser
    openings: list[tuple[str, Span, str]] = []
    for at, text in enumerate(lexemes.texts[:index]):
        if text in _PAIRS:
            openings.append((text, _place(stream, at), _spelling(stream, at - 1)))
        elif text in _CLOSERS:
            openings.pop()
    return _Mistake(
        source=stream.source,
        language=stream.language,
        text=_spelling(stream, index),
        kind=error.token.type,
        span=_place(stream, index),
        before=_spelling(stream, index - 1),
        before_span=_place(stream, index - 1),
        earlier=_spelling(stream, index - 2),
        openings=openings,
        right=frozenset(parser.accepts()),
        values=parser.parser_state.value_stack,
    )


def _spelling(stream: TokenStream, index: int) -> str:
    texts = stream.lexemes.texts
    return texts[index] if 0 <= index < len(texts) else ""


def _place(stream: TokenStream, index: int) -> Span:
    lexemes = stream.lexemes
    if 0 <= index < len(lexemes.texts):
        return Span(lexemes.starts[index], lexemes.ends[index])
    end = len(stream.source.text.rstrip()) if index >= 0 else 0
    return Span(end, end)


# --- kinds of mistakes ----------------------------------------------------------------------------


def _reserved(mistake: _Mistake) -> Diagnostic | None:
    if mistake.kind != "RESERVED":
        return None
    if mistake.text == "subroutine":
        hint = "call the function directly, or choose it with a switch on a uniform"
        return mistake.here("subroutines are not supported", hint, "SC111")
    message = f"'{mistake.text}' is a reserved word of {mistake.language}"
    return mistake.here(message, _reserved_hint(mistake), "SC106")


def _reserved_hint(mistake: _Mistake) -> str:
    if "NAME" in mistake.right and "BASIC_TYPE" not in mistake.right:
        return "choose another name"
    instead = _INSTEAD.get(mistake.text)
    return instead or _needs(mistake.text, mistake.language) or "choose another name"


def _needs(word: str, language: Language) -> str | None:
    """The hint which version a word needs; ``None`` where no later one has it."""
    since = keyword_since(word, language.es)
    if since is None or since <= language.version:
        return None
    return f"it needs #version {since}{' es' if language.es else ''} or later"


def _later_keyword(mistake: _Mistake) -> Diagnostic | None:
    """A word that only another version knows, as in ``precise float x;``."""
    language = mistake.language
    for text, span in ((mistake.text, mistake.span), (mistake.before, mistake.before_span)):
        if is_word(text) and text not in keywords(*language):
            hint = _needs(text, language)
            if hint is not None:
                return mistake.at(span, f"'{text}' has no meaning in {language}", hint, "SC106")
    return None


def _stray_word(mistake: _Mistake) -> Diagnostic | None:
    if mistake.text == "else" and mistake.before in (";", "{", "}"):
        hint = "several statements before 'else' need braces" if mistake.before == ";" else None
        return mistake.here("'else' without an 'if'", hint)
    if mistake.text in ("case", "default") and mistake.before in _STATEMENT_ENDS:
        return mistake.here(f"'{mistake.text}' outside a 'switch'")
    return None


def _wrong_closer(mistake: _Mistake) -> Diagnostic | None:
    """A closing bracket that does not fit the innermost open one."""
    if mistake.text not in _CLOSERS:
        return None
    opening, _, _ = mistake.openings[-1] if mistake.openings else ("{", Span(0, 0), "")
    if not mistake.openings or (opening == "{" and mistake.text != "}"):
        return mistake.here(f"this '{mistake.text}' closes nothing")
    closer = _PAIRS[opening]
    if mistake.text == closer or _CLOSERS[closer] not in mistake.right:
        return None
    return mistake.behind(f"expected '{closer}' {mistake.place}", _opened(mistake))


def _never_closed(mistake: _Mistake) -> Diagnostic | None:
    """A bracket that is open at the end of the file."""
    if mistake.text or not mistake.openings:
        return None
    opening, span, _ = mistake.openings[-1]
    complete = mistake.before in (";", "}", "{") or _CLOSERS[_PAIRS[opening]] in mistake.right
    return mistake.at(span, f"this '{opening}' is never closed") if complete else None


def _opened(mistake: _Mistake) -> str:
    opening, span, _ = mistake.openings[-1]
    line, column = mistake.source.position(span.start)
    return f"the '{opening}' at {line}:{column} is open"


def _unknown_type(mistake: _Mistake) -> Diagnostic | None:
    """``Foo bar``, where nothing says that ``Foo`` is a type."""
    if mistake.kind != "NAME":
        return None
    if "NAME" not in mistake.right and "TYPE_NAME" in mistake.right:
        return mistake.here(f"'{mistake.text}' is not the name of a type", _outside_hint(mistake))
    starts = mistake.same_line and mistake.earlier in _STATEMENT_ENDS
    if starts and is_word(mistake.before) and mistake.before not in keywords(*mistake.language):
        message = f"'{mistake.before}' is not the name of a type"
        return mistake.at(mistake.before_span, message)
    return None


def _outside_hint(mistake: _Mistake) -> str | None:
    return None if mistake.openings else "outside functions there are only declarations"


def _keyword_as_name(mistake: _Mistake) -> Diagnostic | None:
    """``float in = 1.0;``"""
    wanted = "NAME" in mistake.right and not mistake.operand_missing and mistake.same_line
    if wanted and mistake.text in keywords(*mistake.language):
        return mistake.here(f"'{mistake.text}' is a keyword and cannot be a name", code="SC106")
    return None


def _missing_type(mistake: _Mistake) -> Diagnostic | None:
    """``const x = 1.0;``, ``uniform Foo bar;``, ``uniform;``"""
    if {"LBRACE", "COMMA"} <= mistake.right and mistake.kind in ("EQUAL", "LSQB", "LPAR"):
        return mistake.at(mistake.before_span, f"expected a type before '{mistake.before}'")
    if {"LBRACE", "COMMA"} <= mistake.right and mistake.kind == "NAME":
        message = f"'{mistake.before}' is not the name of a type"
        return mistake.at(mistake.before_span, message)
    if "BASIC_TYPE" in mistake.right and is_word(mistake.before) and not mistake.operand_missing:
        return mistake.behind(f"expected a type after '{mistake.before}'")
    return None


def _missing_name(mistake: _Mistake) -> Diagnostic | None:
    if "NAME" not in mistake.right or mistake.operand_missing or mistake.before in _STATEMENT_ENDS:
        return None
    return mistake.behind(f"expected a name after '{mistake.before}'")


def _missing_semicolon(mistake: _Mistake) -> Diagnostic | None:
    unfinished = mistake.operand_missing and mistake.before != "return"
    if "SEMICOLON" not in mistake.right or unfinished or mistake.before in (";", "{", ""):
        return None
    if mistake.text == ")":
        return mistake.behind("expected ';' before ')'")
    apart = not mistake.same_line or mistake.text in ("", "{", "}") or is_word(mistake.text)
    return mistake.behind(f"expected ';' after {_construct(mistake)}") if apart else None


def _construct(mistake: _Mistake) -> str:
    """What stands unfinished on the parser's stack, in words."""
    for value in reversed(mistake.values):
        if isinstance(value, Token) and value.type in _JUMPS:
            return f"'{_JUMPS[value.type]}'"
        if isinstance(value, Head) and value.type is None:
            return "the block"
        if isinstance(value, FullType) or (isinstance(value, tuple) and _is_declaration(value)):
            return "declaration"
    if isinstance(mistake.values[-1], FunctionProto):
        return "the function; one cannot be defined in another"
    return "expression" if mistake.openings else "declaration"


def _is_declaration(value: tuple[Any, ...]) -> bool:
    return bool(value) and isinstance(value[0], FullType)


def _missing_closer(mistake: _Mistake) -> Diagnostic | None:
    """``f(a b)``, ``a[1;``: the innermost bracket could have been closed here."""
    opening, _, before = mistake.openings[-1] if mistake.openings else ("{", Span(0, 0), "")
    if opening == "{" or mistake.operand_missing:
        return None
    closer = _PAIRS[opening]
    if _CLOSERS[closer] not in mistake.right:
        return None
    listed = opening == "(" and is_word(before) and before not in STATEMENT_WORDS
    wanted = f"',' or '{closer}'" if listed and mistake.text != ";" else f"'{closer}'"
    return mistake.behind(f"expected {wanted} {mistake.place}", _opened(mistake))


def _missing_colon(mistake: _Mistake) -> Diagnostic | None:
    if "COLON" not in mistake.right:
        return None
    asked = any(isinstance(value, Token) and value.text == "?" for value in mistake.values)
    return mistake.behind(f"expected ':' after the {'second part of ?:' if asked else 'label'}")


def _missing_operand(mistake: _Mistake) -> Diagnostic | None:
    if not mistake.operand_missing:
        return None
    if "IF" in mistake.right:
        return mistake.here(f"expected a statement {mistake.place}")
    return mistake.here(f"expected an expression after '{mistake.before}'")


def _missing_declaration(mistake: _Mistake) -> Diagnostic | None:
    if "BASIC_TYPE" not in mistake.right:
        return None
    if mistake.before in ("", ";", "}") and not mistake.openings:
        return mistake.here(
            f"expected a declaration, found '{mistake.text}'", _outside_hint(mistake)
        )
    return mistake.here(f"expected a type {mistake.place}")


_RECOGNISERS: tuple[Callable[[_Mistake], Diagnostic | None], ...] = (
    _reserved,
    _later_keyword,
    _stray_word,
    _wrong_closer,
    _never_closed,
    _unknown_type,
    _keyword_as_name,
    _missing_closer,
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
