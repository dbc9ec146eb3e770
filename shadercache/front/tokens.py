"""The lexer that feeds the parser: kinds of tokens, and which names are types just now.

Whether a word is a TYPE_NAME or a NAME depends on the scopes and on what the parser can take: in
``Ray Ray = Ray(o, d);`` the second word is a variable and the third still the constructor. The
lexer therefore asks the parser's state for each name that a struct has, and only for those. When
a scope closes, the parser has already seen the token that follows it; that token is judged again.
"""

from __future__ import annotations

from collections.abc import Container, Iterator
from typing import Any, NamedTuple

from lark.common import LexerConf
from lark.lexer import Lexer, LexerState
from lark.parsers.lalr_parser_state import ParserState

from shadercache.diagnostics import Diagnostic, InputError
from shadercache.front.preprocess import MAX_WORD, Lexemes, is_number, is_word
from shadercache.lang import words
from shadercache.lang.extension_words import suffix_problem
from shadercache.source import Source, Span

MAX_OPERATORS = 1000
"""Operators that may wait for an operand: prefix signs, assignments, ``?`` and ``:``."""

_CHECK_EVERY = 500
_OPERATORS = frozenset(("SIGN", "PREFIX", "STEP", "EQUAL", "ASSIGN", "QMARK", "COLON"))


class Edition(NamedTuple):
    """Which GLSL a file is written in: version, embedded or not, extensions that are on."""

    version: int
    es: bool = False
    extensions: frozenset[str] = frozenset()

    def at_least(self, desktop: int | None, es: int | None, *extensions: str) -> bool:
        """Is it this version or a later one, or is one of the extensions on?

        ``None``: neither a version nor an extension has it there.
        """
        since = es if self.es else desktop
        if since is None:
            return False
        return self.version >= since or not self.extensions.isdisjoint(extensions)

    def __str__(self) -> str:
        """``GLSL ES 3.00``, as a programmer says it."""
        return f"GLSL{' ES' if self.es else ''} {self.version // 100}.{self.version % 100:02}"


class Token:
    """A terminal of the grammar, with its text and its place in the user's file."""

    __slots__ = ("end", "start", "text", "type")

    # Lark gives these of the last token to the end of the input; nobody reads them.
    line = column = end_line = end_column = start_pos = end_pos = None

    def __init__(self, type_: str, text: str, start: int, end: int) -> None:
        self.type = type_
        self.text = text
        self.start = start
        self.end = end

    @property
    def span(self) -> Span:
        """Its place."""
        return Span(self.start, self.end)


class TypeScopes:
    """Which names are types in the scopes that are open, innermost last.

    ``types`` has all names that ever were a type's; ``pending`` is the token in the parser's hand.
    """

    __slots__ = ("_frames", "pending", "types")

    def __init__(self) -> None:
        self._frames: list[dict[str, bool]] = [dict.fromkeys(words.BUILTIN_STRUCTS, True)]
        self.types: set[str] = set(words.BUILTIN_STRUCTS)
        self.pending: Token | None = None

    def open(self) -> int:
        """Open a scope; the number of scopes that are open now."""
        self._frames.append({})
        return len(self._frames)

    def close(self) -> None:
        """Close the innermost scope and judge the pending token anew."""
        self._frames.pop()
        # LALR reads one token ahead: this one was judged in the scope that has just ended.
        token = self.pending
        if token is not None and token.text in self.types:
            token.type = "TYPE_NAME" if self.is_type(token.text) else "NAME"

    def declare_type(self, name: str) -> None:
        """A struct of this name begins."""
        self.types.add(name)
        self._frames[-1][name] = True

    def declare_variable(self, name: str) -> None:
        """A variable of this name begins; it may hide a struct."""
        # A name that no struct ever had is a NAME everywhere: most declarations cost one look-up.
        if name in self.types:
            self._frames[-1][name] = False

    def is_type(self, name: str) -> bool:
        """Does the name mean a struct here?"""
        return next((frame[name] for frame in reversed(self._frames) if name in frame), False)


class TokenStream:
    """What is parsed: the lexemes of one file, and the scopes that the parser keeps for it."""

    def __init__(self, source: Source, language: Edition, lexemes: Lexemes) -> None:
        self.source = source
        self.language = language
        self.lexemes = lexemes
        self.scopes = TypeScopes()
        self.index = -1

    def error(self, code: str, message: str, hint: str | None = None) -> InputError:
        """An error at the lexeme that is being read."""
        span = Span(self.lexemes.starts[self.index], self.lexemes.ends[self.index])
        return InputError(Diagnostic(code, message, self.source, span, hint))


class TokenLexer(Lexer):
    """Lark's door for a lexer of one's own; the text it is given is a :class:`TokenStream`."""

    __future_interface__ = 2

    def __init__(self, lexer_conf: LexerConf) -> None:
        self._fixed = {
            term.pattern.value: term.name
            for term in lexer_conf.terminals
            if term.pattern is not None and term.pattern.type == "str"
        }
        self._kinds: dict[Edition, dict[str, str]] = {}

    def lex(self, lexer_state: LexerState, parser_state: ParserState[int]) -> Iterator[Any]:
        """The tokens of a stream, each made when the parser asks for it."""
        stream: Any = lexer_state.text
        scopes = stream.scopes
        # A copy, because the file's own names and numbers are entered below.
        kinds = self._kinds_of(stream.language).copy()
        check_at = MAX_OPERATORS
        stack = parser_state.state_stack
        states = parser_state.parse_conf.states
        lexemes = stream.lexemes
        # The parser's callbacks add to this set while the loop runs.
        types = scopes.types
        find = kinds.get
        for text, start, end in zip(lexemes.texts, lexemes.starts, lexemes.ends, strict=True):
            stream.index += 1
            kind = find(text)
            if text == words.NONUNIFORM and _is_called(stream):
                kind = "NAME"
            if kind is None:
                kind = kinds[text] = _kind_of(text, stream)
            # The row of the state on top of the stack has the terminals that the parser can take.
            if text in types:
                kind = _name_kind(text, scopes, states[stack[-1]])
            if len(stack) > check_at:
                _check_operators(parser_state.value_stack, stream)
                check_at += _CHECK_EVERY
            token = Token(kind, text, start, end)
            scopes.pending = token
            yield token

    def _kinds_of(self, language: Edition) -> dict[str, str]:
        """The terminals of all words and signs that a language has."""
        kinds = self._kinds.get(language)
        if kinds is None:
            known = words.keywords(*language)
            kinds = self._kinds[language] = _word_kinds(language)
            # What the grammar spells out is a word of this version, or a sign.
            kinds |= {
                text: kind
                for text, kind in self._fixed.items()
                if text in known or not is_word(text)
            }
        return kinds


def _is_called(stream: TokenStream) -> bool:
    """Does a bracket follow?"""
    return stream.lexemes.texts[stream.index + 1 : stream.index + 2] == ["("]


def _name_kind(text: str, scopes: TypeScopes, acceptable: Container[str]) -> str:
    """What a name is that some struct has. Where only one kind may stand it is that kind."""
    if "TYPE_NAME" not in acceptable:
        return "NAME"
    return "TYPE_NAME" if "NAME" not in acceptable or scopes.is_type(text) else "NAME"


def _check_operators(values: list[Any], stream: TokenStream) -> None:
    """Refuse what nests too deeply without brackets, for the tree would be as deep."""
    # Only a stack that grew long is looked through: the limit is not kept to the last one.
    waiting = sum(isinstance(value, Token) and value.type in _OPERATORS for value in values)
    if waiting > MAX_OPERATORS:
        raise stream.error("SC105", f"more than {MAX_OPERATORS} operators nest here")


def _word_kinds(language: Edition) -> dict[str, str]:
    """The terminals of the words and operators that the grammar does not spell out."""
    return {
        **dict.fromkeys(words.reserved_words(*language), "RESERVED"),
        **dict.fromkeys(words.type_names(*language), "BASIC_TYPE"),
        **dict.fromkeys(words.qualifier_words(*language), "QUALIFIER"),
        **dict.fromkeys(words.TRUTH_WORDS, "LITERAL"),
        **dict.fromkeys(words.PRECEDENCE, "BINARY"),
        **dict.fromkeys(words.ASSIGN_OPS, "ASSIGN"),
        # Behind BINARY, which these two are as well: they may also stand before an operand.
        **dict.fromkeys(words.SIGN_OPS, "SIGN"),
        **dict.fromkeys(words.PREFIX_OPS, "PREFIX"),
        **dict.fromkeys(words.STEP_OPS, "STEP"),
    }


def _kind_of(text: str, stream: TokenStream) -> str:
    """The terminal of a name or number; an error for what is neither."""
    if len(text) > MAX_WORD:
        raise stream.error("SC102", f"'{text}' has more than {MAX_WORD} characters")
    if is_word(text) and text.isascii():
        return "NAME"
    if text[0].isdigit() or (text[0] == "." and len(text) > 1):
        if is_number(text):
            _check_suffix(text, stream)
            return "LITERAL"
        raise stream.error("SC102", f"'{text}' is not a number of GLSL")
    shown = f"'{text}'" if text.isprintable() else f"U+{ord(text):04X}"
    kind = "" if text.isascii() else ", which is not ASCII and may stand in comments only"
    hint = "GLSL has no strings" if text in ('"', "'") else None
    raise stream.error("SC101", f"unexpected character {shown}{kind}", hint)


_SUFFIXES: dict[str, tuple[int | None, int | None, tuple[str, ...]]] = {
    "u": (130, 300, ("GL_EXT_gpu_shader4",)),
    "f": (120, 300, ()),
    "lf": (400, None, ("GL_ARB_gpu_shader_fp64",)),
}
"""Since when a number may end in this: desktop, ES (``None``: never), or with which extensions."""


def _check_suffix(text: str, stream: TokenStream) -> None:
    """Refuse the suffix of a literal where the version has none such (section 4.1)."""
    if (problem := suffix_problem(text, stream.language.extensions)) is not None:
        raise stream.error("SC111", *problem)
    # The last f of a hexadecimal number is a digit.
    hexadecimal = text[:2] in ("0x", "0X") and text[-1] in "fF"
    if text[-1] not in "fFuU" or text[-2:] in ("hf", "HF") or hexadecimal:
        return
    suffix = text[-2:] if text[-2] in "lL" else text[-1]
    desktop, es, extensions = _SUFFIXES[suffix.lower()]
    if not stream.language.at_least(desktop, es, *extensions):
        message = f"{stream.language} has no numbers that end in '{suffix}'"
        raise stream.error("SC102", message, f"write {text.removesuffix(suffix)}")
