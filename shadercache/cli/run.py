"""``shadercache run``: render one variant of a node or set of nodes beside the original."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from shadercache.caching.algorithms import DEFAULT, algorithm
from shadercache.cli import options
from shadercache.cli.measuring import measured, result_table, summary
from shadercache.cli.scenes import choose_set

WORDS = options.PASSES[:-1]
DRAWN = options.DrawOptions()


def command(
    context: typer.Context,
    source: options.SceneOptions,
    node: Annotated[
        list[str],
        typer.Option(metavar="NODE", help=f"{options.NODE_HELP}; several are one set."),
    ],
    passes: Annotated[
        str,
        typer.Option(
            metavar="|".join(WORDS), parser=options.one_of(WORDS), help="Passes of the variant."
        ),
    ] = algorithm(DEFAULT).word,
    frame: Annotated[
        int, typer.Option(min=1, max=65_535, help="Frame whose pictures are written.")
    ] = 63,
    period: Annotated[int, typer.Option(min=1, max=65_535, help="Refresh period.")] = 32,
    block: Annotated[int, typer.Option(min=2, help="Block edge, pixels, even.")] = 4,
    rate: options.RateOption = "full",
    draw: options.DrawOptions = DRAWN,
    unprofitable: options.UnprofitableOption = False,
    view: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME",
            help="Debug view; repeat it for several: hits, hit, refresh, clip, depth, id, poison, "
            "age, or all.",
        ),
    ] = None,
    out: Annotated[Path, options.output("Folder for the pictures.")] = Path("out/run"),
) -> None:
    """Run a variant from a reset up to a frame; write original, cached, error, hit map.

    The hit map, and each further --view, shows in false colours what became of each pixel.
    """
    from shadercache.emit.depth_range import depth_warnings
    from shadercache.linking.linker import Linker
    from shadercache.measure.measurement import MeasureOptions
    from shadercache.measure.subjects import PayloadFacts, VariantSubject
    from shadercache.report.variant_pictures import write_pictures

    [edge] = options.parse_blocks(str(block))
    scene, analysis = source.open(context)
    [by] = options.parse_passes(passes)
    payload = choose_set(scene, analysis, node)
    analysis.require_all(payload.nodes, unprofitable)
    cached = replace(draw.configured(scene), nodes=payload.ids, algorithm=by, payload_rate=rate)
    cached = cached.with_refresh(period, edge)
    context.obj.show(depth_warnings(cached, scene.view.camera.near, scene.view.camera.far))
    linker = Linker(scene, analysis)
    linker.require_cached()
    assignment = linker.assign(cached)
    facts = PayloadFacts(static_ratio=analysis.static_ratio(payload.nodes))
    subject = VariantSubject(payload.label, cached, linker.link(assignment), assignment, facts)
    how = MeasureOptions(frame + 1, picture_frame=frame, weigh=draw.weigh)
    results, _ = measured(linker, [subject], how, draw, f"running {payload.label}")
    print(f"mapping: {analysis.mapping}")
    print(f"{summary(results)}\n\n{result_table(results, lambda node: node.label)}\n")
    for shot in results.shots:
        for path in write_pictures(out, shot, view or ["hits"]):
            print(path)
