"""The value of the expression in an ``#if``.

An expression has integers of 32 bits and the operators of C but for ``?:``, assignment and comma.
What stands behind ``0 &&`` or ``1 ||`` is not evaluated: a mistake there is none.

Source: The OpenGL Shading Language 4.60, section 3.3.
"""

from __future__ import annotations

import operator
import re
from collections.abc import Callable, Container, Sequence

from shadercache.front.preprocess.directive_errors import DirectiveError
from shadercache.front.preprocess.scanner import is_word

_INTEGER = re.compile(r"0[xX][0-9a-fA-F]+|0[0-7]*|[1-9][0-9]*")
_UNARY: dict[str, Callable[[int], int]] = {
    "+": operator.pos,
    "-": operator.neg,
    "~": operator.invert,
    "!": operator.not_,
}
_BINARY: dict[str, tuple[int, Callable[[int, int], int]]] = {
    "||": (1, lambda left, right: bool(left or right)),
    "&&": (2, lambda left, right: bool(left and right)),
    "|": (3, operator.or_),
    "^": (4, operator.xor),
    "&": (5, operator.and_),
    "==": (6, operator.eq),
    "!=": (6, operator.ne),
    "<": (7, operator.lt),
    ">": (7, operator.gt),
    "<=": (7, operator.le),
    ">=": (7, operator.ge),
    # C leaves shifts by 32 and more undefined; compilers take the last five bits. Without the mask
    # `1 << 2147483647` would fill the memory.
    "<<": (8, lambda left, right: left << (right & 31)),
    ">>": (8, lambda left, right: left >> (right & 31)),
    "+": (9, operator.add),
    "-": (9, operator.sub),
    "*": (10, operator.mul),
    "/": (10, lambda left, right: _quotient(left, right)),
    "%": (10, lambda left, right: left - right * _quotient(left, right)),
}
_TIGHTEST = 11  # The precedence of the unary operators.

_Value = int | DirectiveError  # A mistake counts only if the whole depends on it.


def replace_defined(words: tuple[str, ...], macros: Container[str]) -> list[str]:
    """The words of an expression with ``1`` or ``0`` for ``defined X`` and ``defined(X)``."""
    replaced: list[str] = []
    at = 0
    while at < len(words):
        if words[at] != "defined":
            replaced.append(words[at])
            at += 1
            continue
        bracket = words[at + 1 : at + 2] == ("(",)
        name = words[at + 1 + bracket] if at + 1 + bracket < len(words) else ""
        if not is_word(name):
            raise DirectiveError("SC122", "'defined' needs the name of a macro")
        at += 2 + bracket
        if bracket:
            if words[at : at + 1] != (")",):
                raise DirectiveError("SC122", f"expected ')' after 'defined({name}'")
            at += 1
        replaced.append("1" if name in macros else "0")
    return replaced


def evaluate(words: Sequence[str], es: bool) -> int:
    """The value of an expression whose macros are expanded."""
    values: list[_Value] = []
    waiting: list[tuple[str, int]] = []  # Operators and brackets with their precedence.
    operand = True
    for word in words:
        # Prefix operators wait without anything being carried out: the innermost comes first.
        if operand and word == "(":
            waiting.append(("(", 0))
        elif operand and word in _UNARY:
            waiting.append((word, _TIGHTEST))
        elif operand:
            values.append(_operand(word, es))
            operand = False
        elif word == ")":
            # Brackets wait with precedence 0: this stops at the innermost one.
            _apply(values, waiting, 1)
            if not waiting:
                raise DirectiveError("SC122", "this expression has a ')' without a '('")
            waiting.pop()
        elif word in _BINARY:
            precedence = _BINARY[word][0]
            _apply(values, waiting, precedence)
            waiting.append((word, precedence))
            operand = True
        else:
            raise DirectiveError("SC122", f"'{word}' is out of place in this expression")
    if operand:
        raise DirectiveError("SC122", "a value is missing at the end of this expression")
    _apply(values, waiting, 1)
    if waiting:
        raise DirectiveError("SC122", "a ')' is missing in this expression")
    (result,) = values
    if isinstance(result, DirectiveError):
        raise result
    return result


def _operand(word: str, es: bool) -> _Value:
    if word == "defined":
        message = "'defined' comes out of a macro, which compilers do not take"
        raise DirectiveError("SC122", message, "write it into the #if itself")
    if is_word(word):
        # It counts as 0 but in GLSL ES (GLSL ES 3.00, section 3.4).
        hint = "ask with 'defined' first"
        mistake = DirectiveError("SC122", f"'{word}' is not defined, which GLSL ES forbids", hint)
        return mistake if es else 0
    if not word[0].isdigit():
        raise DirectiveError("SC122", f"expected a value before '{word}'")
    if not _INTEGER.fullmatch(word):
        raise DirectiveError("SC122", f"'{word}' is not an integer")
    base = 16 if word[1:2] in ("x", "X") else 8 if word[0] == "0" else 10
    # Decimal digits beyond a few thousand would take their time, and Python refuses them.
    if (base == 10 and len(word) > 10) or (value := int(word, base)) >= 1 << 32:
        raise DirectiveError("SC122", f"'{word}' needs more than 32 bits")
    return _wrapped(value)


def _apply(values: list[_Value], waiting: list[tuple[str, int]], precedence: int) -> None:
    """Carry out what waits and binds at least that tightly."""
    while waiting and waiting[-1][1] >= precedence:
        word, binding = waiting.pop()
        right = values.pop()
        if binding < _TIGHTEST:
            right = _combined(values.pop(), word, right)
        elif not isinstance(right, DirectiveError):
            right = _wrapped(_UNARY[word](right))
        values.append(right)


def _combined(left: _Value, word: str, right: _Value) -> _Value:
    if isinstance(left, DirectiveError):
        return left
    if word in ("&&", "||") and bool(left) == (word == "||"):
        return int(bool(left))
    if isinstance(right, DirectiveError):
        return right
    if word in ("/", "%") and right == 0:
        return DirectiveError("SC122", "division by zero")
    return _wrapped(_BINARY[word][1](left, right))


def _quotient(left: int, right: int) -> int:
    """Division that rounds towards zero."""
    quotient = abs(left) // abs(right)
    return quotient if (left < 0) == (right < 0) else -quotient


def _wrapped(value: int) -> int:
    """The value as a signed integer of 32 bits."""
    return ((int(value) + (1 << 31)) & 0xFFFFFFFF) - (1 << 31)
