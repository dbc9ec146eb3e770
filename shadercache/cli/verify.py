"""``shadercache verify``: the laws, on this machine's driver, node by node."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from shadercache.caching.configuration import Configuration
from shadercache.cli.progress import progress
from shadercache.cli.reading import (
    CacheOption,
    DefineOption,
    DialectOption,
    IncludeOption,
    MappingOption,
    TokensOption,
    UndefineOption,
    UnrollOption,
    read_options,
)
from shadercache.cli.scenes import choose_nodes, configured, find_scene
from shadercache.cli.tables import format_table, shorten, terminal_width
from shadercache.front.read_options import MAX_TOKENS

if TYPE_CHECKING:
    from shadercache.verify.verifier import Difference, Verdict

HEADER = ("node", "path", "laws", "plain: largest", "p99.9", "changed", "text")


def command(
    target: Annotated[
        str,
        typer.Argument(
            metavar="SCENE|FRAG", help="Scene, a shader beside its scene, or a full-screen shader."
        ),
    ],
    node: Annotated[
        list[str] | None,
        typer.Option(metavar="ID", help="Only this node, or set A+B; may be repeated."),
    ] = None,
    unprofitable: Annotated[
        bool, typer.Option("--unprofitable", help="Also nodes cheaper than a fetch.")
    ] = False,
    every_node: Annotated[
        bool, typer.Option("--every-node", help="Every node, not one of those of the same value.")
    ] = False,
    plain: Annotated[
        bool, typer.Option("--plain/--proof-only", help="Also measure what plain mode changes.")
    ] = True,
    define: DefineOption = None,
    undefine: UndefineOption = None,
    include: IncludeOption = None,
    dialect: DialectOption = "glsl",
    mapping: MappingOption = None,
    max_tokens: TokensOption = MAX_TOKENS,
    unroll: UnrollOption = False,
    cache: CacheOption = None,
    jobs: Annotated[
        int, typer.Option("-j", "--jobs", min=0, help="Processes; 0 takes one per core.")
    ] = 0,
    as_json: Annotated[bool, typer.Option("--json", help="Print the verdicts as JSON.")] = False,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="FILE", help="Write the JSON there.")
    ] = None,
) -> None:
    """Check laws 1 to 4 for every offered value by rendering it on this machine's driver.

    1: the printed shader renders the same bits. 2: refreshed in every frame, a variant is the
    original. 3: at rest it stays so, and all that is not due is reused. 4: the algorithms agree,
    look where the last frame was, and reuse what that showed. Laws 2 to 4 are decided in proof
    mode, bit by bit; for plain mode the difference is reported. Exit status 1 if a law is broken.
    Of nodes that have the same value one is checked; the others are counted, and --every-node
    checks them too.
    """
    from shadercache.analysis.value_numbering import one_of_each
    from shadercache.gpu.context import open_context
    from shadercache.linking.scene_shaders import open_scene
    from shadercache.measure.result_files import environment, write_json
    from shadercache.verify.parallel import verify_in_parallel
    from shadercache.verify.verifier import Verifier

    equal = 0
    options = read_options(define, undefine, include, dialect, max_tokens, unroll)
    path = find_scene(target)
    scene, analysis = open_scene(path, options, mapping)
    configuration = configured(scene, Configuration(), cache)
    if node:
        chosen = [found for _, found in choose_nodes(scene, analysis, node)]
    else:
        every = [item for item in analysis.nodes if item.offered or (unprofitable and item.legal)]
        kept = every if every_node else list(one_of_each(every, analysis.groups))
        equal = len(every) - len(kept)
        chosen = [(item,) for item in kept]
    for nodes in chosen:
        analysis.require_all(nodes, unprofitable)
    with open_context() as gpu:
        about = environment(gpu)
        verifier = Verifier(gpu, scene, analysis)
        round_trip, ties = verifier.round_trip(), verifier.ties
        verifier.close()
    with progress(f"verifying {scene.name}", len(chosen)) as advance:
        verdicts = verify_in_parallel(
            path,
            ["+".join(item.id for item in nodes) for nodes in chosen],
            min(jobs or os.cpu_count() or 1, max(1, len(chosen))),
            plain,
            lambda _: advance(1),
            options,
            mapping,
            configuration,
        )
    report = _report(scene.name, about, round_trip, ties, verdicts, equal)
    report["mapping"] = analysis.mapping
    if output is not None:
        write_json(output, report)
    text = _text(verdicts, round_trip, ties, equal)
    print(json.dumps(report, indent=1) if as_json else f"{text}\nmapping: {analysis.mapping}")
    if report["broken"]:
        raise typer.Exit(1)


def _report(
    scene: str,
    about: dict[str, Any],
    round_trip: Difference | None,
    ties: float,
    verdicts: Sequence[Verdict],
    equal: int,
) -> dict[str, Any]:
    broken = [verdict.node for verdict in verdicts if verdict.broken]
    return {
        "schema_version": 1,
        "scene": scene,
        "environment": about,
        "round_trip_exact": None if round_trip is None else round_trip.exact,
        "depth_ties": ties,
        "checked": len(verdicts),
        "equal_to_checked": equal,
        "broken": broken + ([] if round_trip is None or round_trip.exact else ["law 1"]),
        "nodes": [verdict.to_json() for verdict in verdicts],
    }


def _law_1(round_trip: Difference | None) -> str:
    if round_trip is None:
        return "not checked: the driver cannot draw the shader as it is written"
    return "holds" if round_trip.exact else "BROKEN"


def _text(
    verdicts: Sequence[Verdict], round_trip: Difference | None, ties: float, equal: int
) -> str:
    from shadercache.verify.verifier import MAX_TIES, PERIOD

    rows = [_row(verdict) for verdict in verdicts]
    right = "p99.9 changed"
    table = format_table(HEADER, rows, right=right, width=terminal_width())
    broken = sum(bool(verdict.broken) for verdict in verdicts)
    plain = sum(any(not found.exact for found in verdict.plain.values()) for verdict in verdicts)
    lines = [
        table,
        "",
        f"law 1: {_law_1(round_trip)}",
        f"laws 2-4: {len(verdicts) - broken} of {len(verdicts)} nodes exact in proof mode",
    ]
    ages = [age for verdict in verdicts for age in verdict.ages.values()]
    if ages:
        lines.append(f"law 7: the oldest payload was {max(ages):g} frames old, of {PERIOD}")
    if any(verdict.plain for verdict in verdicts):
        lines.append(f"plain mode changes bits for {plain} of {len(verdicts)} nodes")
    if equal:
        lines.append(f"{equal} more nodes have the value of one of these (--every-node checks all)")
    lines += [f"{item.node}: {reason}" for item in verdicts for reason in item.reasons]
    lines += [f"{item.node}: {item.cause}" for item in verdicts if item.cause]
    if ties > MAX_TIES:
        lines.append(f"{ties:.2%} of the pixels are depth ties, which are left out")
    return "\n".join(lines)


def _row(verdict: Verdict) -> tuple[str, ...]:
    worst = None
    for found in verdict.plain.values():
        worst = found if worst is None else worst.worst(found)
    laws = "; ".join(verdict.broken) or "hold"
    if verdict.refused:
        laws += f" (not {', '.join(verdict.refused)})"
    figures = (
        ("", "", "")
        if worst is None
        else (f"{worst.maximum:.1e}", f"{worst.p999:.1e}", f"{worst.changed:.1%}")
    )
    return (verdict.node, verdict.path, laws, *figures, shorten(verdict.text, 50))
