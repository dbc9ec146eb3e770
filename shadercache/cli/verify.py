"""``shadercache verify``: the laws, on this machine's driver, node by node."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from shadercache.caching.configuration import Configuration
from shadercache.cli.options import (
    NODE_HELP,
    PASSES,
    ClusterOption,
    RateOption,
    SceneOptions,
    SettingsOption,
    parse_passes,
)
from shadercache.cli.progress import progress
from shadercache.cli.scenes import choose_nodes, one_by_one
from shadercache.cli.tables import format_table, shorten, terminal_width

if TYPE_CHECKING:
    from shadercache.verify.round_trip import RoundTrip
    from shadercache.verify.verdict import Verdict

HEADER = ("node", "path", "laws", "plain: largest", "p99.9", "changed", "text")


@dataclass(frozen=True, kw_only=True)
class VariantOptions:
    """Which variants of a node are verified."""

    passes: Annotated[
        str, typer.Option(metavar=",".join(PASSES), help="Algorithms; all: the first three.")
    ] = "all"
    cache: SettingsOption = None
    rate: RateOption = "full"


VARIANTS = VariantOptions()


@dataclass(frozen=True, slots=True)
class WholeScene:
    """What is true of all nodes of a scene.

    ``round_trip`` is None where there is nothing to compare with. ``ties``: the share of pixels
    that are left out. ``equal``: how many nodes have the value of one that is checked.
    ``left_out``: how many values are not checked.
    """

    round_trip: RoundTrip | None
    ties: float
    equal: int
    left_out: int


def command(
    context: typer.Context,
    source: SceneOptions,
    node: Annotated[
        list[str] | None,
        typer.Option(metavar="NODE", help=f"{NODE_HELP}, or a set A+B; may be repeated."),
    ] = None,
    unprofitable: Annotated[
        bool, typer.Option("--unprofitable", help="Also nodes cheaper than a fetch.")
    ] = False,
    every: Annotated[
        bool, typer.Option("--all", help="Every value, not only the dearest and some of each kind.")
    ] = False,
    every_node: Annotated[
        bool, typer.Option("--every-node", help="Also every node that has the value of another.")
    ] = False,
    plain: Annotated[
        bool, typer.Option("--plain/--proof-only", help="Also measure what plain mode changes.")
    ] = True,
    variants: VariantOptions = VARIANTS,
    jobs: Annotated[
        int, typer.Option("-j", "--jobs", min=0, help="Processes; 0 takes one per core.")
    ] = 0,
    cluster: ClusterOption = None,
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
    Of what is offered 20 values are checked: the dearest, and one of each type and kind of place.
    --all checks all of them, and --every-node also the nodes that have the same value as another.
    """
    from shadercache.cluster import open_cluster
    from shadercache.gpu.context import open_context
    from shadercache.linking.cache_settings import configured
    from shadercache.measure.result_files import environment, write_json
    from shadercache.verify.parallel import VerifiedScene, verify_in_parallel, verify_on
    from shadercache.verify.quick_choice import quick_choice
    from shadercache.verify.verifier import Verifier

    algorithms = parse_passes(variants.passes)
    opened, read_options = source.opened(context), source.read_options()
    scene, analysis = opened.scene, opened.analysis
    configuration = configured(scene, Configuration(payload_rate=variants.rate), variants.cache)
    if node:
        payloads = choose_nodes(scene, analysis, node)
    else:
        legal = [node for node in analysis.nodes if node.offered or (unprofitable and node.legal)]
        payloads = one_by_one(analysis, legal, every_node)
    left_out = 0
    if not (node or every or every_node):
        stand = quick_choice(analysis.savings, [payload.nodes[0] for payload in payloads])
        left_out = len(payloads) - len(stand)
        payloads = [payload for payload in payloads if payload.nodes[0] in stand]
    # All of them before anything is drawn: that may take minutes.
    for payload in payloads:
        analysis.require_all(payload.nodes, unprofitable)
    equal = sum(payload.equal - 1 for payload in payloads)
    with open_context() as gpu, closing(Verifier(gpu, (scene, analysis))) as verifier:
        about = environment(gpu)
        whole = WholeScene(verifier.round_trip(), verifier.references.ties, equal, left_out)
    with progress(f"verifying {scene.name}", len(payloads)) as advance:
        verified = VerifiedScene(
            opened.path, read_options, opened.mapping, configuration, algorithms, opened.vertex
        )
        ids = ["+".join(payload.ids) for payload in payloads]
        if cluster is None:
            count = min(jobs or os.cpu_count() or 1, max(1, len(ids)))
            verdicts = verify_in_parallel(verified, ids, count, plain, lambda _: advance(1))
        else:
            with open_cluster(cluster) as client:
                verdicts = verify_on(client, verified, ids, plain, lambda _: advance(1))
    report = {
        "schema_version": 1,
        "scene": scene.name,
        "environment": about,
        **_report(whole, verdicts),
        "mapping": analysis.mapping,
    }
    if output is not None:
        write_json(output, report)
    text = f"{_text(whole, verdicts)}\nmapping: {analysis.mapping}"
    print(json.dumps(report, indent=1) if as_json else text)
    if report["broken"]:
        raise typer.Exit(1)


def _report(whole: WholeScene, verdicts: Sequence[Verdict]) -> dict[str, Any]:
    law_1 = None if whole.round_trip is None else whole.round_trip.exact
    broken = [verdict.node for verdict in verdicts if verdict.broken]
    return {
        "round_trip_exact": law_1,
        "depth_ties": whole.ties,
        "checked": len(verdicts),
        "equal_to_checked": whole.equal,
        "left_out": whole.left_out,
        "broken": broken + (["law 1"] if law_1 is False else []),
        "nodes": [verdict.to_json() for verdict in verdicts],
    }


def _text(whole: WholeScene, verdicts: Sequence[Verdict]) -> str:
    from shadercache.verify.verdict import MAX_TIES, PERIOD, worst_of

    law_1 = "not checked: the driver cannot draw the shader as it is written"
    if whole.round_trip is not None:
        law_1 = "holds" if whole.round_trip.exact else "BROKEN"
        if not whole.round_trip.by_rule.exact:
            law_1 += f"; raised, a discard ends loops, by which {whole.round_trip.by_rule}"
    exact = sum(not verdict.broken for verdict in verdicts)
    lines = [
        format_table(HEADER, map(_row, verdicts), right="p99.9 changed", width=terminal_width()),
        "",
        f"law 1: {law_1}",
        f"laws 2-4: {exact} of {len(verdicts)} nodes exact in proof mode",
    ]
    if not verdicts:
        lines.append("no value is offered, so laws 2-4 say nothing ('shadercache nodes' says why)")
    lines += _of_screen([verdict for verdict in verdicts if verdict.approximate])
    ages = [age for verdict in verdicts for age in verdict.ages.values()]
    if ages:
        lines.append(f"law 7: the oldest payload was {max(ages):g} frames old, of {PERIOD}")
    if any(verdict.plain for verdict in verdicts):
        changed = sum(not worst_of(verdict.plain.values()).exact for verdict in verdicts)
        lines.append(f"plain mode changes bits for {changed} of {len(verdicts)} nodes")
    if whole.equal:
        lines.append(
            f"{whole.equal} more nodes have the value of one of these (--every-node checks all)"
        )
    if whole.left_out:
        lines.append(
            f"{whole.left_out} more values are not checked: these are the dearest, and one of each "
            "type and kind of place (--all checks all)"
        )
    for verdict in verdicts:
        lines += [f"{verdict.node}: {reason}" for reason in verdict.reasons]
    lines += [f"{verdict.node}: {verdict.cause}" for verdict in verdicts if verdict.cause]
    if whole.ties > MAX_TIES:
        lines.append(f"{whole.ties:.2%} of the pixels are depth ties, which are left out")
    return "\n".join(lines)


def _of_screen(verdicts: Sequence[Verdict]) -> list[str]:
    """Which laws hold for values of the screen, and how far reuse of them is off."""
    from shadercache.verify.verdict import PERIOD

    if not verdicts:
        return []
    off = [(error, one.node) for one in verdicts for error in (one.moving or {}).values()]
    lines = [
        f"{len(verdicts)} of them are values of the screen: laws 2-4 are judged for these as for "
        "all others (exact with all refreshed, exact at rest, the same by each algorithm)"
    ]
    if off:
        worst, node = max(off)
        lines.append(
            "no law bounds how far their reuse is off in motion: here, at a period of "
            f"{PERIOD}, an RMSE of up to {worst:.2g} ({node})"
        )
    return lines


def _row(verdict: Verdict) -> tuple[str, ...]:
    from shadercache.verify.verdict import worst_of

    laws = "; ".join(verdict.broken) or "hold"
    if verdict.refused:
        laws += f" (not {', '.join(verdict.refused)})"
    figures = ("", "", "")
    if verdict.plain:
        worst = worst_of(verdict.plain.values())
        figures = (f"{worst.maximum:.1e}", f"{worst.p999:.1e}", f"{worst.changed:.1%}")
    return (verdict.node, verdict.path, laws, *figures, shorten(verdict.text, 50))
