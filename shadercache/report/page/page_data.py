"""All that the page's script reads: plain data, texts and pictures."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Any

import msgspec

from shadercache import __version__
from shadercache.report.debug_views import AGED, TOO_OLD, YOUNG
from shadercache.report.images import LEGEND, Color
from shadercache.report.page.page_contents import Blob
from shadercache.report.page.page_group import METRICS, PageGroup
from shadercache.report.page.page_rows import page_node, page_row, repeat_command, scene_in_words
from shadercache.report.page.page_summary import summary
from shadercache.sweep.row import Row


@dataclass(frozen=True, eq=False)
class PageSource:
    """Where a page's rows come from: the store's name, its rows, and what its hashes stand for.

    ``stale`` rows are left out, since their sources have changed.
    """

    name: str
    rows: Sequence[Row]
    blob: Blob
    stale: int = 0


def page_data(source: PageSource, groups: Sequence[PageGroup]) -> dict[str, Any]:
    """Everything but the pictures. ``groups`` are those of the source's rows."""
    return {
        "store": source.name,
        "version": __version__,
        "made": datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC"),
        "metrics": dict(METRICS),
        "legend": {name: [_css(color), words] for name, (color, words) in LEGEND.items()},
        "ages": [_css(color) for color in (YOUNG, AGED, TOO_OLD)],
        "groups": [_group(group, source.name) for group in groups],
        "pictures": {},
        "missing": 0,
        "stale": source.stale,
    }


def _group(group: PageGroup, store: str) -> dict[str, Any]:
    nodes: dict[str, int] = {}
    payloads: list[dict[str, Any]] = []
    rows = []
    for row in group.rows:
        if row.payload is not None and row.label not in nodes:
            nodes[row.label] = len(payloads)
            payloads.append(page_node(row.payload))
        shown = page_row(row, nodes.get(row.label) if row.payload is not None else None)
        rows.append(shown | {"texts": row.texts, "repeat": repeat_command(row, store)})
    found: dict[str, Any] = {
        "name": group.name,
        "scene": msgspec.to_builtins(group.scene) | {"path": scene_in_words(group.scene)},
        "machine": msgspec.to_builtins(group.machine),
        "versions": sorted({row.written.version for row in group.rows}),
        "dates": _span([row.written.date for row in group.rows]),
        "summary": summary(group),
        "nodes": payloads,
        "rows": rows,
    }
    if group.measured:
        best = group.best or group.measured[0]
        found |= {
            "chosen": best.place,
            "geometry": group.geometry,
            "original": [1e3 * value for value in group.original],
            "fronts": {metric: _fronts(group, metric) for metric in group.metrics},
        }
    return found


def _fronts(group: PageGroup, metric: str) -> dict[str, list[int]]:
    return {
        kind: [one.place for one in group.front(metric, among)]
        for kind, among in (("variant", group.variants), ("peer", group.peers))
    }


def _span(dates: Sequence[str]) -> list[str]:
    return [min(dates), max(dates)]


def _css(color: Color) -> str:
    return "#{:02x}{:02x}{:02x}".format(*color)
