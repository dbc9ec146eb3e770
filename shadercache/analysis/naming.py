"""Which node is meant by a name: its id, its text, or where it stands.

``main.16-7891657a``, ``marble(v_position)`` and ``:95:30`` may all be one node. White space and
comments in a text do not matter. A line means what saves most of what is offered on it. Names
joined by ``+`` are a set; the longest text that is there is meant, so a ``+`` in it parts nothing.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cached_property

from shadercache.analysis.candidates import Candidate, Candidates
from shadercache.analysis.costs.savings import Savings, is_inside
from shadercache.analysis.value_numbering import ValueGroup
from shadercache.diagnostics import (
    Diagnostic,
    Severity,
    UsageError,
    shortened,
    usage_error,
)
from shadercache.source import Source

MOST_TOLD = 8
"""Candidates that are listed where a name means several."""

NO_NAMES: Mapping[str, str] = {}

_ID = re.compile(r"\w+\.\d+u?-[0-9a-f]*")
_UNROLLED = re.compile(r"\.\d+u-")
_PLACE = re.compile(r":(\d+)(?::(\d+))?")
_IGNORED = re.compile(r"/\*.*?\*/|//[^\n]*|\s+", re.DOTALL)
_OPENING, _CLOSING = "([{", ")]}"


@dataclass(frozen=True)
class NodeNames:
    """The nodes of one shader by their names.

    ``groups`` and ``savings`` are asked for only where they decide. ``unroll``: were loops taken
    apart?
    """

    source: Source
    candidates: Candidates
    groups: Callable[[], Mapping[Candidate, ValueGroup]]
    savings: Callable[[], Savings]
    unroll: bool

    def several(self, text: str, named: Mapping[str, str] = NO_NAMES) -> tuple[Candidate, ...]:
        """The nodes of a set; ``named`` are further names, of sets too.

        Raises :class:`UsageError` SC010 or SC011 if there is none, SC012 if a name means several.
        """
        parts, found = text.split("+"), list[Candidate]()
        while parts:
            count = self._longest(parts, named)
            name = "+".join(parts[:count]).strip()
            if not name and text != name:
                raise usage_error("SC010", f"'{text}' lacks an id beside a '+'")
            if name in named:
                found += self.several(named[name])
            else:
                found.append(self.one(name, named))
            del parts[:count]
        return tuple(found)

    def one(self, name: str, named: Mapping[str, str] = NO_NAMES) -> Candidate:
        """The node with this name. Raises as :meth:`several`."""
        if name in self._by_id:
            return self._by_id[name]
        if place := _PLACE.fullmatch(name):
            return self._placed(name, int(place[1]), int(place[2]) if place[2] else None)
        if same := self._by_text.get(_squeezed(name)):
            return self._chosen(name, same)
        if _ID.match(name) and (node := self._by_other_id(name)):
            return node
        raise self._unknown(name, named)

    def _longest(self, parts: Sequence[str], named: Mapping[str, str]) -> int:
        """How many of the parts are the first name."""
        for count in range(len(parts), 0, -1):
            name = "+".join(parts[:count]).strip()
            if name in named or name in self._by_id or _squeezed(name) in self._by_text:
                return count
        # What is not known ends where its brackets are closed.
        for count in range(1, len(parts)):
            text = "+".join(parts[:count])
            if sum(map(text.count, _OPENING)) == sum(map(text.count, _CLOSING)):
                return count
        return len(parts)

    @cached_property
    def _by_id(self) -> dict[str, Candidate]:
        return {node.id: node for node in self.candidates.nodes}

    @cached_property
    def _by_text(self) -> dict[str, list[Candidate]]:
        texts: dict[str, list[Candidate]] = {}
        for node in self.candidates.nodes:
            # On one line a comment to its end would hide the rest.
            whole = self.source.excerpt(node.expr.span) if "//" in node.text else node.text
            texts.setdefault(_squeezed(whole), []).append(node)
        return texts

    def _by_other_id(self, name: str) -> Candidate | None:
        """The node whose long id this is; or whose short one, where it is longer here."""
        ids, several = self.candidates.ids, list[str]()
        for node in self.candidates.nodes:
            if node.instance is None or node.place is None:
                continue
            if name.startswith(node.id) and ids.long(node.instance, node.place) == name:
                return node
            if node.id.startswith(name) and ids.short(node.instance, node.place) == name:
                several.append(node.id)
        if several:
            message = f"'{name}' is short for {len(several)} nodes of {self.source.name}"
            raise usage_error("SC012", message, f"they are {', '.join(several)}")
        return None

    def _placed(self, name: str, line: int, column: int | None) -> Candidate:
        """What saves most of what begins there; else the innermost that the place is a part of."""
        if column is None:
            here = [node for node in self._own if self._begins(node)[0] == line]
        else:
            here = [node for node in self._own if self._begins(node) == (line, column)]
        if column is not None and not any(node.offered for node in here):
            around = [node for node in self._own if self._covers(node, (line, column))]
            offered = [node for node in around if node.offered]
            around = offered or ([] if here else around)
            shortest = min(map(_length, around), default=0)
            here = [node for node in around if _length(node) == shortest] or here
        if not here:
            raise self._nothing_at(name, line)
        return self._chosen(name, here)

    def _chosen(self, name: str, nodes: Sequence[Candidate]) -> Candidate:
        """The one that is meant. Raises :class:`UsageError` SC012 where others are as good."""
        offered = [node for node in nodes if node.offered]
        offered = offered or [node for node in nodes if node.legal]
        if not offered:
            # Whoever asks for it is told why not: the outermost speaks for what is in it.
            return max(nodes, key=_length)
        outermost = [
            node
            for node in offered
            if not any(
                other is not node and other.instance is node.instance and _holds(other, node)
                for other in offered
            )
        ]
        groups = self.groups()
        values = dict.fromkeys(groups[node] for node in outermost)
        if len(values) > 1:
            firsts = [next(one for one in outermost if groups[one] is value) for value in values]
            raise self._ambiguous(name, firsts)
        if len(offered) == len(outermost):
            return offered[0]
        savings = self.savings()
        return max(offered, key=lambda node: savings.of(node).share)

    @cached_property
    def _own(self) -> tuple[Candidate, ...]:
        """The nodes in the shader's own file: lines are counted there."""
        return tuple(
            node
            for node in self.candidates.nodes
            if self.source.part(node.expr.span.start) is self.source
        )

    def _begins(self, node: Candidate) -> tuple[int, int]:
        return self.source.position(node.expr.span.start)

    def _covers(self, node: Candidate, place: tuple[int, int]) -> bool:
        start, end = map(self.source.position, node.expr.span)
        return start <= place < end

    def _ambiguous(self, name: str, nodes: Sequence[Candidate]) -> UsageError:
        """SC012, with each of the nodes at its place."""
        count = len(nodes)
        message = f"'{shortened(name)}' means {count} different values of {self.source.name}"
        more = f"; {count - MOST_TOLD} more are not shown" if count > MOST_TOLD else ""
        return UsageError(
            [
                Diagnostic("SC012", message, hint=f"give the id of one of these{more}"),
                *(self._told(node) for node in nodes[:MOST_TOLD]),
            ]
        )

    def _told(self, node: Candidate) -> Diagnostic:
        message = f"{node.id}, on the path {node.path}"
        about = "SC012", message, self.source, node.expr.span
        return Diagnostic(*about, severity=Severity.NOTE)

    def _nothing_at(self, name: str, line: int) -> UsageError:
        lines = {self._begins(node)[0] for node in self._own if node.offered}
        near = sorted(sorted(lines, key=lambda other: abs(other - line))[:3])
        hint = f"the nearest lines with some are {', '.join(map(str, near))}" if near else None
        return usage_error("SC010", f"{self.source.name} has no value at '{name}'", hint)

    def _unknown(self, name: str, named: Mapping[str, str]) -> UsageError:
        options = "--unroll --all" if self.unroll else "--all"
        hint = f"'shadercache nodes {self.source.name} {options}' lists the nodes"
        # Behind the last dash stands a hash of the functions on the call path.
        stem = name.rpartition("-")[0]
        stale = any(node.id.rpartition("-")[0] == stem for node in self.candidates.nodes)
        if not self.unroll and _UNROLLED.search(name):
            hint = "it is of the shader with its loops unrolled: add --unroll"
        elif not stale and (close := self._close(name, named)):
            hint = f"did you mean {' or '.join(close)}? {hint}"
        if stale:
            message = (
                f"node '{name}' is not from this source of {self.source.name}: "
                "a function on its call path has changed since"
            )
            return usage_error("SC011", message, hint)
        return usage_error("SC010", f"{self.source.name} has no node '{name}'", hint)

    def _close(self, name: str, named: Mapping[str, str]) -> list[str]:
        """Names that are much like this one."""
        known: Iterable[str] = (node.text for node in self.candidates.nodes if node.offered)
        if _ID.match(name):
            known = self._by_id
        words = [word for word in (*named, *dict.fromkeys(known)) if len(word) < 4 * len(name) + 4]
        return [f"'{shortened(word)}'" for word in get_close_matches(name, words, 2, 0.7)]


def _squeezed(text: str) -> str:
    return _IGNORED.sub("", text)


def _length(node: Candidate) -> int:
    return node.expr.span.end - node.expr.span.start


def _holds(outer: Candidate, inner: Candidate) -> bool:
    """Is one expression a part of the other?"""
    return is_inside(inner, outer) and _length(outer) > _length(inner)
