"""``shadercache bench``: every offered node by every algorithm.

What it measures is figure 8 of Sitthi-amorn et al. 2008.
"""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from shadercache.caching.configuration import (
    DEFAULT_EPSILON,
    CacheFormat,
    Configuration,
    HitTest,
    Storage,
)
from shadercache.cli.io import folder
from shadercache.cli.measuring import (
    PASSES,
    WeighOption,
    parse_blocks,
    parse_passes,
    parse_periods,
    parse_size,
    result_table,
    step_progress,
    summary,
)
from shadercache.cli.reading import (
    CacheOption,
    DefineOption,
    DialectOption,
    FetchesOption,
    IncludeOption,
    MappingOption,
    TokensOption,
    UndefineOption,
    UnrollOption,
    read_options,
)
from shadercache.cli.scenes import choose_nodes, configured, find_scene, split_list
from shadercache.cli.tables import shorten
from shadercache.front.read_options import MAX_TOKENS

if TYPE_CHECKING:
    from shadercache.analysis.candidates import Candidate
    from shadercache.measure.measurement import Measurement, NodeResult
    from shadercache.measure.subjects import VariantSubject


def command(
    target: Annotated[
        str, typer.Argument(metavar="SCENE|FRAG", help="Scene, or a full-screen shader.")
    ],
    nodes: Annotated[
        list[str] | None,
        typer.Option(
            metavar="IDS", help="Only these nodes (ids or the scene's names; a+b is a set)."
        ),
    ] = None,
    every_node: Annotated[
        bool, typer.Option("--every-node", help="Also nodes of the same value as another.")
    ] = False,
    passes: Annotated[str, typer.Option(metavar=",".join(PASSES[:-1]), help="Algorithms.")] = "all",
    period: Annotated[str, typer.Option(metavar="N,...", help="Refresh periods, frames.")] = "32",
    block: Annotated[str, typer.Option(metavar="K,...", help="Block edges, pixels.")] = "4",
    size: Annotated[str, typer.Option(metavar="W[xH]", help="Picture size.")] = "512",
    frames: Annotated[int, typer.Option(min=2, help="Frames of each run.")] = 16,
    cache_format: Annotated[
        CacheFormat, typer.Option("--format", help="Texel format of the cache.")
    ] = "rgba16f",
    epsilon: Annotated[
        float, typer.Option(min=0.0, help="Depth tolerance, relative to 1/w.")
    ] = DEFAULT_EPSILON,
    mesh: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Draw this mesh (.npz) instead.")
    ] = None,
    define: DefineOption = None,
    undefine: UndefineOption = None,
    include: IncludeOption = None,
    dialect: DialectOption = "glsl",
    mapping: MappingOption = None,
    max_tokens: TokensOption = MAX_TOKENS,
    unroll: UnrollOption = False,
    fetches: FetchesOption = "whole",
    cache: CacheOption = None,
    weigh: WeighOption = True,
    out: Annotated[
        Path,
        typer.Option(
            "-o", "--output", metavar="DIR", parser=folder, help="For JSON, CSV and plots."
        ),
    ] = Path("out/bench"),
    as_json: Annotated[bool, typer.Option("--json", help="Print JSON, not a table.")] = False,
) -> None:
    """Measure nodes by every algorithm: P/T, time, ratio to the original, hit rate, error.

    Of offered nodes that have the same value only the first is measured, and marked with their
    number. --nodes measures what it is given.

    All periods and blocks are drawn interleaved in one process; the ratio's interval is a 95 %
    bootstrap. Writes JSON (with raw samples), CSV and plots into DIR; of few nodes also the hit
    rate of every frame.
    """
    from shadercache.analysis.value_numbering import one_of_each
    from shadercache.gpu.context import open_context
    from shadercache.linking.linker import Linker
    from shadercache.linking.scene_shaders import open_scene
    from shadercache.linking.user_places import at_home
    from shadercache.measure.measure import measure
    from shadercache.measure.measurement import MeasureOptions
    from shadercache.measure.result_files import environment, to_json
    from shadercache.measure.subjects import subjects_of, with_refreshes
    from shadercache.render.render_scene import RenderScene
    from shadercache.scene.mesh import replacement_mesh

    algorithms, extent = parse_passes(passes), parse_size(size)
    periods, blocks = parse_periods(period), parse_blocks(block)
    reading = read_options(define, undefine, include, dialect, max_tokens, unroll)
    scene, analysis = open_scene(find_scene(target), reading, mapping)
    equal: dict[Candidate, int] = {}
    chosen: list[tuple[str, tuple[Candidate, ...]]]
    if nodes:
        chosen = choose_nodes(scene, analysis, split_list(nodes))
    else:
        offered = [node for node in analysis.nodes if node.offered]
        equal = one_of_each(offered, analysis.groups)
        chosen = [(node.id, (node,)) for node in (offered if every_node else equal)]
    base = configured(
        scene,
        Configuration(
            hit_test=HitTest(epsilon=epsilon), storage=Storage(cache_format), fetches=fetches
        ),
        cache,
    )
    linker = Linker(scene, analysis)
    subjects: list[VariantSubject] = []
    for label, found in chosen:
        payload = replace(base, nodes=tuple(item.id for item in found))
        wanted = [
            replace(one, algorithm=name)
            for one in with_refreshes(payload, periods, blocks)
            for name in algorithms
        ]
        count = 1 if every_node else equal.get(found[0], 1)
        subjects += subjects_of(linker, label, wanted, count)
    replacement = replacement_mesh(scene, mesh)
    how = MeasureOptions(frames, weigh=weigh)
    with (
        open_context() as gpu,
        at_home(analysis),
        RenderScene(gpu, linker.scene, extent, mesh=replacement) as world,
    ):
        with step_progress(scene.name) as tell:
            measured = measure(world, linker.originals(), subjects, how, tell)
        report = to_json(measured, environment(gpu))
    _store(out, measured, report)
    if as_json:
        print(json.dumps(report, indent=1))
    else:
        print(f"mapping: {analysis.mapping}")
        print(f"{summary(measured)}\n\n{result_table(measured, _label)}\n")


def _label(node: NodeResult) -> str:
    if node.label != node.node_id:
        return node.label
    mark = f" ({node.equal} equal)" if node.equal > 1 else ""
    return f"{node.label}{mark} {shorten(node.text, 32)}"


def _store(out: Path, found: Measurement, report: dict[str, Any]) -> None:
    from shadercache.files import write_bytes
    from shadercache.measure.result_files import to_csv, write_json
    from shadercache.report.plots import plot_error, plot_hits, plot_time

    stem = found.scene
    write_json(out / f"{stem}.json", report)
    write_bytes(out / f"{stem}.csv", to_csv(found).encode())
    write_bytes(out / f"{stem}-time.png", plot_time(found))
    write_bytes(out / f"{stem}-error.png", plot_error(found))
    hits = plot_hits(found)
    if hits is not None:
        write_bytes(out / f"{stem}-hits.png", hits)
