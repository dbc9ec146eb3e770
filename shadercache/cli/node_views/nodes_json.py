"""The nodes of a shader as JSON, in which everything is said once.

A shader of 28 KB may have 80,000 nodes, but only some thousand expressions, paths and lists of
inputs. These stand in tables, and a node has their numbers in them (from 0). The form is described
in ``docs/use/nodes-json.md``.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Hashable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from shadercache.analysis.candidates import Candidate
    from shadercache.compiler import Analysis

SCHEMA_VERSION = 2

Changes = Mapping[str, str]
"""Which inputs change from frame to frame, and with what."""

_encode = json.JSONEncoder().encode


def print_nodes(analysis: Analysis, nodes: Sequence[Candidate], changes: Changes | None) -> str:
    """The JSON text: the tables and the nodes have a line for each entry."""
    writer = _Writer(analysis, changes)
    # A list may leave out nodes that are refused, so numbers are those of this list.
    places = {node: number for number, node in enumerate(nodes)}
    written = [writer.node(node, places[analysis.groups[node].first]) for node in nodes]
    head = {
        "schema_version": SCHEMA_VERSION,
        "mapping": analysis.mapping,
        "whole": _plain(analysis.shared_work.whole),
    }
    parts = [f" {_encode(name)}: {_encode(value)}" for name, value in head.items()]
    for name, values in {**writer.tables, "nodes": written}.items():
        lines = ",\n".join(f"  {_encode(value)}" for value in values)
        parts.append(f" {_encode(name)}: [\n{lines}\n ]" if values else f" {_encode(name)}: []")
    return "{\n" + ",\n".join(parts) + "\n}"


def changes_of(node: Candidate, changes: Changes) -> dict[str, list[str]]:
    """The inputs of a node that change from frame to frame, by what they change with."""
    by_cause: dict[str, list[str]] = {}
    for name in sorted(node.inputs & changes.keys()):
        by_cause.setdefault(changes[name], []).append(name)
    return by_cause


class _Writer:
    """Fills the tables while nodes are written."""

    def __init__(self, analysis: Analysis, changes: Changes | None) -> None:
        from shadercache.analysed import value_classes

        self._analysis, self._changes = analysis, changes
        self._class_of = value_classes(analysis, changes)
        names = ("expressions", "paths", "inputs", "refusals", "on_cpu")
        self.tables: dict[str, list[Any]] = {name: [] for name in names}
        self._numbers: dict[str, dict[Hashable, int]] = {name: {} for name in names}

    def node(self, node: Candidate, group: int) -> dict[str, Any]:
        """One node; ``group`` is the number of the one that stands for its value."""
        expression = (node.expr.span, node.type)
        return {
            "id": node.id,
            "path": self._number("paths", node.path, lambda: node.path),
            "expression": self._number("expressions", expression, lambda: self._expression(node)),
            "cost": _plain(node.cost),
            "ratio": round(node.ratio, 6),
            **self._passes(node),
            "inputs": self._number("inputs", node.inputs, lambda: self._inputs(node)),
            "group": group,
            "class": self._class_of(node),
            "offered": node.offered,
            **self._verdict(node),
        }

    def _number(self, table: str, key: Hashable, make: Callable[[], Any]) -> int:
        """The place in a table of what ``key`` stands for; ``make`` gives it when it is new."""
        numbers = self._numbers[table]
        if key not in numbers:
            numbers[key] = len(numbers)
            self.tables[table].append(make())
        return numbers[key]

    def _passes(self, node: Candidate) -> dict[str, float]:
        if not node.legal:
            return {}
        parts = self._analysis.shared_work.parts((node,))
        return {"payload": _plain(parts.payload), "remainder": _plain(parts.remainder)}

    def _expression(self, node: Candidate) -> dict[str, Any]:
        position = self._analysis.fragment.position
        (line, column), (end_line, end_column) = map(position, node.expr.span)
        return {
            **{"line": line, "column": column, "end_line": end_line, "end_column": end_column},
            **{"type": str(node.type), "text": node.text},
        }

    def _inputs(self, node: Candidate) -> dict[str, Any]:
        from shadercache.analysed import unchanged_for
        from shadercache.analysis.input_reads import by_kind, input_kinds

        program = self._analysis.program
        kinds = input_kinds(program.module, program.facts)
        unchanged = unchanged_for(self._analysis, (node,))
        return {
            "names": sorted(node.inputs),
            "depends_on": by_kind(node.inputs, kinds),
            **({} if unchanged is None else {"exact_while_unchanged": list(unchanged)}),
            **({} if self._changes is None else {"changes_with": changes_of(node, self._changes)}),
        }

    def _verdict(self, node: Candidate) -> dict[str, int]:
        """Why a node is refused, and what to compute on the CPU in its place."""
        refusal = node.refusal
        if refusal is None:
            return {}
        from shadercache.analysed import on_cpu

        verdict = {
            "refusal": self._number(
                "refusals",
                (refusal.code, refusal.detail),
                lambda: {
                    "code": refusal.code.code,
                    "sentence": refusal.sentence,
                    "unprofitable": refusal.unprofitable,
                },
            )
        }
        text = on_cpu(self._analysis, node)
        if text is not None:
            verdict["on_cpu"] = self._number("on_cpu", text, lambda: text)
        return verdict


def _plain(cost: float) -> float:
    """A cost without the ``.0`` that most of them end in."""
    return int(cost) if cost.is_integer() else cost
