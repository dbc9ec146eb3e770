"""What is wrong with a directive, before it is known where that stands."""

from __future__ import annotations


class DirectiveError(Exception):
    """A code, a message and a hint; whoever reads the directive knows its place."""

    def __init__(self, code: str, message: str, hint: str | None = None) -> None:
        super().__init__(message)
        self.code = code
        self.message = message
        self.hint = hint


class RunawayError(DirectiveError):
    """A limit is reached; reading on makes no sense."""


LIMIT_HINT = "--max-tokens gives another limit"


class StopReading(Exception):  # noqa: N818
    """No one reads on; why is among the errors already."""
