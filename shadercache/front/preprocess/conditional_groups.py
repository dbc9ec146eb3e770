"""The groups of lines between ``#if``, ``#elif``, ``#else`` and ``#endif``, and which are read.

Source: The OpenGL Shading Language 4.60, section 3.3.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from shadercache.front.preprocess.directive_errors import DirectiveError
from shadercache.source import Span


@dataclass(slots=True)
class _Group:
    """An ``#if`` that is open: where it stands, and what is known of its branches."""

    span: Span
    outer: bool
    live: bool
    taken: bool
    last: bool = False


@dataclass(slots=True)
class Groups:
    """The conditional groups that are open in one file, innermost last."""

    _open: list[_Group] = field(default_factory=list)

    @property
    def live(self) -> bool:
        """Is what stands here read?"""
        return not self._open or self._open[-1].live

    @property
    def asks(self) -> bool:
        """Does the condition of an ``#elif`` here matter?"""
        return bool(self._open) and self._open[-1].outer and not self._open[-1].taken

    @property
    def around(self) -> bool:
        """Is the text around the innermost group read?"""
        return self._open[-1].outer

    def begin(self, span: Span, holds: bool) -> None:
        """``#if``, ``#ifdef`` or ``#ifndef``."""
        self._open.append(_Group(span, self.live, self.live and holds, holds))

    def skip(self, span: Span) -> None:
        """An ``#if`` whose condition is wrong: none of its branches is read."""
        self._open.append(_Group(span, self.live, False, True))

    def go_on(self, name: str, holds: bool | None) -> None:
        """``#elif`` or ``#else``; where a condition is wrong (``None``) no more is read."""
        if not self._open:
            raise DirectiveError("SC121", f"#{name} without an #if")
        group = self._open[-1]
        if group.last:
            raise DirectiveError("SC121", f"#{name} behind the #else of its #if")
        group.live = group.outer and bool(holds) and not group.taken
        group.taken |= holds is not False
        group.last = name == "else"

    def end(self) -> None:
        """``#endif``."""
        if not self._open:
            raise DirectiveError("SC121", "#endif without an #if")
        self._open.pop()

    def unclosed(self) -> list[Span]:
        """Where the groups begin that are still open."""
        return [group.span for group in self._open]
