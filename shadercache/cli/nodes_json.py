"""The nodes of a shader as JSON, in which everything is said once.

A shader of 28 KB may have 80,000 nodes, but only some thousand expressions, paths and lists of
inputs. These stand in tables, and a node has their numbers in them (from 0). The form is described
in ``docs/use/nodes-json.md``.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from shadercache.analysis.candidates import Candidate
    from shadercache.analysis.refusals import Refusal
    from shadercache.compiler import Analysis

SCHEMA_VERSION = 2

Changes = Mapping[str, str]
"""Which inputs change from frame to frame, and with what."""


@dataclass(slots=True)
class _Table:
    """Values, each once, with their numbers."""

    values: list[Any] = field(default_factory=list)
    _numbers: dict[Hashable, int] = field(default_factory=dict)

    def number(self, key: Hashable, make: Callable[[], Any]) -> int:
        """The number of what ``key`` stands for; ``make`` gives its value when it is new."""
        found = self._numbers.get(key)
        if found is None:
            found = self._numbers[key] = len(self.values)
            self.values.append(make())
        return found


def print_nodes(analysis: Analysis, nodes: Sequence[Candidate], changes: Changes | None) -> str:
    """The JSON text: the tables and the nodes have a line for each entry."""
    writer = _Writer(analysis, changes)
    groups = analysis.groups
    places = {node: number for number, node in enumerate(nodes)}
    found = [writer.node(node, places[groups[node].first]) for node in nodes]
    head: dict[str, Any] = {"schema_version": SCHEMA_VERSION, "mapping": analysis.mapping}
    head["whole"] = _plain(analysis.whole)
    parts = [f" {json.dumps(name)}: {json.dumps(value)}" for name, value in head.items()]
    parts += [_list(name, table.values) for name, table in writer.tables.items()]
    return "{\n" + ",\n".join([*parts, _list("nodes", found)]) + "\n}"


def _list(name: str, values: Sequence[Any]) -> str:
    lines = ",\n".join(f"  {_ENCODER.encode(value)}" for value in values)
    return f" {json.dumps(name)}: [\n{lines}\n ]" if values else f" {json.dumps(name)}: []"


_ENCODER = json.JSONEncoder()


def changes_of(node: Candidate, changes: Changes) -> dict[str, list[str]]:
    """The inputs of a node that change from frame to frame, by what they change with."""
    found: dict[str, list[str]] = {}
    for name in sorted(node.inputs & changes.keys()):
        found.setdefault(changes[name], []).append(name)
    return found


class _Writer:
    """Fills the tables while the nodes are told."""

    def __init__(self, analysis: Analysis, changes: Changes | None) -> None:
        self._analysis, self._changes = analysis, changes
        self.tables = {
            name: _Table() for name in ("expressions", "paths", "inputs", "refusals", "on_cpu")
        }

    def node(self, node: Candidate, group: int) -> dict[str, Any]:
        """One node; ``group`` is the number of the one that stands for its value."""
        return {
            "id": node.id,
            "path": self.tables["paths"].number(node.path, lambda: node.path),
            "expression": self.tables["expressions"].number(
                (node.expr.span, node.type), lambda: self._expression(node)
            ),
            "cost": _plain(node.cost),
            "ratio": round(node.ratio, 6),
            **self._passes(node),
            "inputs": self.tables["inputs"].number(node.inputs, lambda: self._inputs(node)),
            "group": group,
            "offered": node.offered,
            **self._verdict(node),
        }

    def _passes(self, node: Candidate) -> dict[str, float]:
        if not node.legal:
            return {}
        parts = self._analysis.parts(node)
        return {"payload": _plain(parts.payload), "remainder": _plain(parts.remainder)}

    def _expression(self, node: Candidate) -> dict[str, Any]:
        position = self._analysis.fragment.position
        (line, column), (end_line, end_column) = map(position, node.expr.span)
        return {
            **{"line": line, "column": column, "end_line": end_line, "end_column": end_column},
            **{"type": str(node.type), "text": node.text},
        }

    def _inputs(self, node: Candidate) -> dict[str, Any]:
        from shadercache.analysis.input_reads import by_kind

        unchanged = self._analysis.unchanged_for(node)
        return {
            "names": sorted(node.inputs),
            "depends_on": by_kind(node.inputs, self._analysis.input_kinds),
            **({} if unchanged is None else {"exact_while_unchanged": list(unchanged)}),
            **({} if self._changes is None else {"changes_with": changes_of(node, self._changes)}),
        }

    def _verdict(self, node: Candidate) -> dict[str, int]:
        """Why a node is refused, and what to compute on the CPU in its place."""
        refusal = node.refusal
        if refusal is None:
            return {}
        key = (refusal.code, refusal.detail)
        found = {"refusal": self.tables["refusals"].number(key, lambda: _refusal(refusal))}
        text = self._analysis.on_cpu(node)
        if text is not None:
            found["on_cpu"] = self.tables["on_cpu"].number(text, lambda: text)
        return found


def _plain(cost: float) -> float:
    """A cost without the ``.0`` that most of them end in."""
    return int(cost) if cost.is_integer() else cost


def _refusal(refusal: Refusal) -> dict[str, Any]:
    return {
        "code": refusal.code.code,
        "sentence": refusal.sentence,
        "unprofitable": refusal.unprofitable,
    }
