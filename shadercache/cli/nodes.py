"""``shadercache nodes``: every value of a shader, what it costs, and whether it may be cached."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from shadercache.cli.io import read_source
from shadercache.cli.reading import (
    DefineOption,
    DialectOption,
    IncludeOption,
    TokensOption,
    UndefineOption,
    read_options,
)
from shadercache.cli.scenes import find_scene
from shadercache.cli.tables import format_table, shorten, terminal_width
from shadercache.front.options import MAX_TOKENS

if TYPE_CHECKING:
    from shadercache.analysis.candidates import Candidate
    from shadercache.compiler import Analysis

HEADER = ("id", "path", "at", "type", "cost", "P/T", "twice", "verdict", "inputs", "text")
CHANGES = "changes with"
INPUTS_WIDTH = 24
TEXT_WIDTH = 60


def command(
    fragment: Annotated[str, typer.Argument(metavar="FRAG", help="Fragment shader; - is stdin.")],
    vert: Annotated[
        str | None, typer.Option(metavar="FILE", help="Vertex shader that goes with it.")
    ] = None,
    offered: Annotated[
        bool, typer.Option("--offered/--all", help="Leave out the nodes that are refused.")
    ] = False,
    scene: Annotated[
        str | None,
        typer.Option(metavar="SCENE", help="Scene that says which uniforms change, and why."),
    ] = None,
    sort: Annotated[
        Literal["source", "ratio"], typer.Option(help="By call path and place, or by P/T.")
    ] = "source",
    define: DefineOption = None,
    undefine: UndefineOption = None,
    include: IncludeOption = None,
    dialect: DialectOption = "glsl",
    max_tokens: TokensOption = MAX_TOKENS,
    as_json: Annotated[bool, typer.Option("--json", help="The same as JSON.")] = False,
) -> None:
    """List every value of a shader, its cost, and whether it may be cached.

    A node is one evaluation of one expression, on one path of calls. P/T is the static cost of
    the value over that of the whole shader; "twice" is the share of the shader's cost that the
    payload and the shading that is left both compute. The verdict is "offered" or the code of the
    reason why the value may not be cached. With --scene a column says which inputs change from
    frame to frame: with the view, the light or the time. --json leaves nothing out: nodes that
    have the same value share a "group", and values of uniforms only come with the GLSL to compute
    "on_cpu".
    """
    from shadercache.compiler import analyse
    from shadercache.harness.scene import load_scene

    options = read_options(define, undefine, include, dialect, max_tokens)
    source = read_source(fragment)
    analysis = analyse(source, read_source(vert) if vert else None, options)
    nodes = analysis.nodes
    changes = load_scene(find_scene(scene)).changes if scene else None
    shown = [node for node in nodes if node.offered or not offered]
    if sort == "ratio":
        shown.sort(key=lambda node: node.ratio)
    if as_json:
        found = [_as_json(analysis, node, changes) for node in shown]
        print(json.dumps({"nodes": found}, indent=1))
        return
    rows = [_row(analysis, node, changes) for node in shown]
    header = HEADER if changes is None else (*HEADER[:-1], CHANGES, HEADER[-1])
    print(format_table(header, rows, right="at cost P/T twice", width=terminal_width()))
    print(f"\n{_summary(nodes)}")


def _changes(node: Candidate, changes: Mapping[str, str]) -> dict[str, list[str]]:
    """The inputs of a node that change from frame to frame, by what they change with."""
    found: dict[str, list[str]] = {}
    for name in sorted(node.inputs & changes.keys()):
        found.setdefault(changes[name], []).append(name)
    return found


def _row(analysis: Analysis, node: Candidate, changes: Mapping[str, str] | None) -> tuple[str, ...]:
    line, column = analysis.fragment.position(node.expr.span.start)
    parts = analysis.parts(node) if node.legal else None
    causes = {} if changes is None else _changes(node, changes)
    told = "; ".join(f"{cause}: {' '.join(names)}" for cause, names in causes.items())
    return (
        node.id,
        node.path,
        f"{line}:{column}",
        str(node.type),
        f"{node.cost:.0f}",
        f"{node.ratio:.3f}",
        f"{parts.overlap / (parts.whole or 1.0):.3f}" if parts else "",
        node.refusal.code.code if node.refusal else "offered",
        shorten(" ".join(sorted(node.inputs)), INPUTS_WIDTH),
        *(() if changes is None else (shorten(told, INPUTS_WIDTH),)),
        shorten(node.text, TEXT_WIDTH),
    )


def _as_json(
    analysis: Analysis, node: Candidate, changes: Mapping[str, str] | None
) -> dict[str, Any]:
    from shadercache.analysis.inputs import by_kind

    source = analysis.fragment
    line, column = source.position(node.expr.span.start)
    end_line, end_column = source.position(node.expr.span.end)
    refusal = node.refusal
    return {
        "id": node.id,
        "path": node.path,
        "line": line,
        "column": column,
        "end_line": end_line,
        "end_column": end_column,
        "type": str(node.type),
        "cost": node.cost,
        "ratio": node.ratio,
        "passes": asdict(analysis.parts(node)) if node.legal else None,
        "inputs": sorted(node.inputs),
        "depends_on": by_kind(node.inputs, analysis.input_kinds),
        **({} if changes is None else {"changes_with": _changes(node, changes)}),
        "group": analysis.groups[node].first.id,
        "on_cpu": analysis.on_cpu(node),
        "text": node.text,
        "offered": node.offered,
        "refusal": refusal
        and {
            "code": refusal.code.code,
            "sentence": refusal.sentence,
            "unprofitable": refusal.unprofitable,
        },
    }


def _summary(nodes: Sequence[Candidate]) -> str:
    """How many nodes are offered, and how many are refused for which reason."""
    reasons = Counter(node.refusal.code for node in nodes if node.refusal)
    offered = len(nodes) - reasons.total()
    lines = [f"{len(nodes)} nodes, {offered} offered"]
    for code, count in sorted(reasons.items(), key=lambda item: item[0].code):
        lines.append(f"{count:6} {code.code}: {code.sentence}")
    return "\n".join(lines)
