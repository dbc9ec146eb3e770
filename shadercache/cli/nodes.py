"""``shadercache nodes``: every value of a shader, what it costs, and whether it may be cached."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Sequence
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
from shadercache.cli.tables import format_table, shorten, terminal_width
from shadercache.front.options import MAX_TOKENS

if TYPE_CHECKING:
    from shadercache.analysis.candidates import Candidate
    from shadercache.source import Source

HEADER = ("id", "path", "at", "type", "cost", "P/T", "verdict", "inputs", "text")
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
    the value over that of the whole shader. The verdict is "offered" or the code of the reason
    why the value may not be cached. --json leaves nothing out.
    """
    from shadercache.compiler import analyse

    options = read_options(define, undefine, include, dialect, max_tokens)
    source = read_source(fragment)
    nodes = analyse(source, read_source(vert) if vert else None, options).nodes
    shown = [node for node in nodes if node.offered or not offered]
    if sort == "ratio":
        shown.sort(key=lambda node: node.ratio)
    if as_json:
        print(json.dumps({"nodes": [_as_json(source, node) for node in shown]}, indent=1))
        return
    rows = [_row(source, node) for node in shown]
    print(format_table(HEADER, rows, right="at cost P/T", width=terminal_width()))
    print(f"\n{_summary(nodes)}")


def _row(source: Source, node: Candidate) -> tuple[str, ...]:
    line, column = source.position(node.expr.span.start)
    return (
        node.id,
        node.path,
        f"{line}:{column}",
        str(node.type),
        f"{node.cost:.0f}",
        f"{node.ratio:.3f}",
        node.refusal.code.code if node.refusal else "offered",
        shorten(" ".join(sorted(node.inputs)), INPUTS_WIDTH),
        shorten(node.text, TEXT_WIDTH),
    )


def _as_json(source: Source, node: Candidate) -> dict[str, Any]:
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
        "inputs": sorted(node.inputs),
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
