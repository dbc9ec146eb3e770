"""``shadercache bench``: every offered node by every algorithm.

What it measures is figure 8 of Sitthi-amorn et al. 2008.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from shadercache.caching.configuration import DIVISORS
from shadercache.cli import options
from shadercache.cli.measuring import TrialOptions, measured, result_table, summary
from shadercache.cli.profiling import profile_table, profiled
from shadercache.cli.profiling import to_json as profiles_to_json
from shadercache.cli.scenes import choose_nodes, one_by_one
from shadercache.cli.tables import shorten
from shadercache.diagnostics import usage_error
from shadercache.files import file_stem

if TYPE_CHECKING:
    from collections.abc import Sequence

    from shadercache.caching.configuration import Configuration
    from shadercache.linking.linker import Linker
    from shadercache.measure.measurement import Measurement, NodeResult


@dataclass(frozen=True, kw_only=True)
class KindOptions:
    """By which algorithms each node is measured, at which periods, blocks and rates."""

    passes: Annotated[
        str, typer.Option(metavar=",".join(options.PASSES[:-1]), help="Algorithms.")
    ] = "all"
    period: Annotated[str, typer.Option(metavar="N,...", help="Refresh periods, frames.")] = "32"
    rate: Annotated[
        str, typer.Option(metavar=",".join(DIVISORS), help="Payload rates (see rewrite).")
    ] = "full"
    block: Annotated[str, typer.Option(metavar="K,...", help="Block edges, pixels.")] = "4"

    def __post_init__(self) -> None:
        """Raise :class:`UsageError` SC008 for what is none, before anything is compiled."""
        options.parse_passes(self.passes)
        options.parse_rates(self.rate)
        options.parse_periods(self.period)
        options.parse_blocks(self.block)

    def refreshes(self, base: Configuration) -> list[Configuration]:
        """A configuration at each period and block."""
        periods, blocks = options.parse_periods(self.period), options.parse_blocks(self.block)
        return [base.with_refresh(period, block) for period in periods for block in blocks]

    def kinds(self, base: Configuration) -> list[Configuration]:
        """All that are combined."""
        return [
            replace(refreshed, algorithm=name, payload_rate=rate)
            for refreshed in self.refreshes(base)
            for name in options.parse_passes(self.passes)
            for rate in options.parse_rates(self.rate)
        ]


KINDS = KindOptions()
SMALL, TRIAL = options.DrawOptions(size="512"), TrialOptions()


def command(
    context: typer.Context,
    source: options.SceneOptions,
    nodes: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NODES", help=f"{options.NODE_HELP}; a+b is a set, commas part several."
        ),
    ] = None,
    every_node: Annotated[
        bool, typer.Option("--every-node", help="Also nodes of the same value as another.")
    ] = False,
    kind: KindOptions = KINDS,
    trial: TrialOptions = TRIAL,
    draw: options.DrawOptions = SMALL,
    out: Annotated[Path, options.output("For JSON, CSV and plots.")] = Path("out/bench"),
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON, not a table.")] = False,
    profile: Annotated[
        bool, typer.Option("--profile", help="Also where a frame of two passes goes, by ablation.")
    ] = False,
) -> None:
    """Measure nodes by every algorithm: P/T, time, ratio to the original, hit rate, error.

    Of offered nodes that have the same value only the first is measured, and marked with their
    number. --nodes measures what it is given.

    All periods and blocks are drawn interleaved in one process; the ratio's interval is a 95 %
    bootstrap. Writes JSON (with raw samples), CSV and plots into DIR; of few nodes also the hit
    rate of every frame.
    """
    from shadercache.linking.linker import Linker
    from shadercache.measure.measurement import MeasureOptions
    from shadercache.measure.result_files import to_json, write_json
    from shadercache.measure.subjects import subjects_of

    scene, analysis = source.open(context)
    if nodes:
        payloads = choose_nodes(scene, analysis, options.split_names(nodes))
    else:
        offered = [node for node in analysis.nodes if node.offered]
        payloads = one_by_one(analysis, offered, every_node)
    base = draw.configured(scene)
    kinds = kind.kinds(base)
    linker, subjects = Linker(scene, analysis), []
    left_out: list[str] = []
    for payload in payloads:
        chosen = [replace(one, nodes=payload.ids) for one in kinds]
        subjects += subjects_of(linker, payload.label, chosen, payload.equal)
        if nodes:
            left_out += _left_out(linker, payload.label, chosen)
    if not subjects:
        hint = "; ".join(left_out) or "take other --passes or another --rate"
        raise usage_error("SC027", "no node has a variant by what is asked for", hint)
    how = MeasureOptions(
        trial.frames, weigh=draw.weigh, perceptual=trial.perceptual, stop=trial.stop
    )
    results, where = measured(linker, subjects, how, draw, scene.name)
    report = to_json(results, where)
    _store(out, results, report)
    tables = []
    if profile:
        bases = kind.refreshes(base)
        cases = [(one.label, replace(each, nodes=one.ids)) for one in payloads for each in bases]
        profiles = profiled(linker, [chosen for _, chosen in cases], how, draw)
        tables = [
            profile_table(taken, case[0]) for taken, case in zip(profiles, cases, strict=True)
        ]
        # Written once more: the measurement is safe, whatever becomes of the profiles.
        report["profiles"] = profiles_to_json(profiles)
        write_json(out / f"{file_stem(results.scene)}.json", report)
    if as_json:
        print(json.dumps(report, indent=1))
        return
    print(f"mapping: {analysis.mapping}")
    print(f"{summary(results)}\n\n{result_table(results, _label)}\n")
    for line in left_out:
        print(f"{line}\n")
    for table in tables:
        print(f"{table}\n")


def _left_out(linker: Linker, label: str, chosen: Sequence[Configuration]) -> list[str]:
    """A line for each algorithm and payload rate by which the payload has no variant."""
    lines = []
    for configuration in chosen:
        if configuration.algorithm not in linker.fitting(configuration):
            reason = linker.reason(configuration)
            rate, algorithm = configuration.payload_rate, configuration.algorithm
            kind = algorithm if rate == "full" else f"{algorithm} at {rate} rate"
            lines.append(f"{label} has no {kind}: {reason}")
    return list(dict.fromkeys(lines))


def _label(node: NodeResult) -> str:
    if node.label != node.node_id:
        return node.label
    mark = f" ({node.equal} equal)" if node.equal > 1 else ""
    return f"{node.label}{mark} {shorten(node.text, 32)}"


def _store(out: Path, results: Measurement, report: dict[str, Any]) -> None:
    from shadercache.files import write_bytes
    from shadercache.measure.result_files import to_csv, write_json
    from shadercache.report.plots import plot_error, plot_hits, plot_time

    stem = file_stem(results.scene)
    write_json(out / f"{stem}.json", report)
    write_bytes(out / f"{stem}.csv", to_csv(results).encode())
    write_bytes(out / f"{stem}-time.png", plot_time(results))
    write_bytes(out / f"{stem}-error.png", plot_error(results))
    hits = plot_hits(results)
    if hits is not None:
        write_bytes(out / f"{stem}-hits.png", hits)
