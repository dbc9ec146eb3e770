"""What is found wrong with a module while it is gone through."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from shadercache.ast.nodes import Member, Node
from shadercache.diagnostics import Diagnostic, InputError, Severity
from shadercache.lang import extension_words
from shadercache.lang.types import Type
from shadercache.source import Source

ERROR = Type("<error>")
"""Type of an expression that was already complained about: whoever uses it stays silent."""

MAX_TOLD = 1_000
"""Mistakes that are told; after that many no one reads on."""

_HINTS = 20


class Problems:
    """The diagnostics of one module."""

    def __init__(self, source: Source) -> None:
        self._source = source
        self._diagnostics: list[Diagnostic] = []
        self._undeclared: set[str] = set()

    def error(self, code: str, message: str, node: Node, hint: str | None = None) -> Type:
        """Report a mistake at ``node``; returns the type that silences what depends on it."""
        self._diagnostics.append(Diagnostic(code, message, self._source, node.span, hint))
        return ERROR

    def warn(self, code: str, message: str, node: Node, hint: str | None = None) -> None:
        """Report something legal but doubtful."""
        place = self._source, node.span
        self._diagnostics.append(Diagnostic(code, message, *place, hint, Severity.WARNING))

    def undeclared(
        self, what: str, name: str, node: Node, known: Callable[[], Iterable[str]]
    ) -> Type:
        """Report an unknown name, once, with the nearest known one as a hint."""
        if name in self._undeclared:
            return ERROR
        self._undeclared.add(name)
        if of_extension := extension_words.explained(name):
            message, hint = of_extension
            return self.error("SC111", message, node, hint)
        # Looking for similar names is slow, and nobody reads the hundredth hint.
        hint = did_you_mean(name, known()) if len(self._undeclared) <= _HINTS else None
        return self.error("SC201", f"undeclared {what} '{name}'", node, hint)

    def no_field(self, message: str, node: Member, fields: Iterable[str]) -> Type:
        """Report an unknown field."""
        return self.error("SC213", message, node, did_you_mean(node.name, fields))

    def warnings(self) -> tuple[Diagnostic, ...]:
        """All that was reported, in source order.

        Raises :class:`InputError` with all of it if there is an error among it.
        """
        reports = sorted(
            self._diagnostics, key=lambda one: (one.span[0] if one.span else 0, one.code)
        )
        errors = [one for one in reports if one.severity is Severity.ERROR]
        if errors:
            raise InputError(reports if len(reports) <= MAX_TOLD else errors[:MAX_TOLD])
        return tuple(reports)


def did_you_mean(name: str, known: Iterable[str]) -> str | None:
    """``did you mean 'x'?`` for the known name nearest to ``name``."""
    from difflib import get_close_matches  # only mistakes need it, and it is slow to import

    best = get_close_matches(name, set(known), 1, 0.7)
    return f"did you mean '{best[0]}'?" if best else None
