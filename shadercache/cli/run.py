"""``shadercache run``: render one variant of a node or set of nodes beside the original."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from shadercache.caching.algorithms import DEFAULT, algorithm
from shadercache.caching.configuration import (
    DEFAULT_EPSILON,
    CacheFormat,
    Configuration,
    HitTest,
    Refresh,
    Storage,
)
from shadercache.cli.io import folder
from shadercache.cli.measuring import (
    PASSES,
    WeighOption,
    one_of,
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
from shadercache.cli.scenes import choose_nodes, configured, find_scene
from shadercache.cli.write_pictures import write_pictures
from shadercache.front.read_options import MAX_TOKENS


def command(
    context: typer.Context,
    target: Annotated[
        str, typer.Argument(metavar="SCENE|FRAG", help="Scene, or a full-screen shader.")
    ],
    node: Annotated[
        list[str],
        typer.Option(metavar="ID", help="Node id, or a name from the scene; several are one set."),
    ],
    passes: Annotated[
        str,
        typer.Option(
            metavar="|".join(PASSES[:-1]), parser=one_of(PASSES[:-1]), help="Passes of the variant."
        ),
    ] = algorithm(DEFAULT).word,
    frame: Annotated[
        int, typer.Option(min=1, max=65_535, help="Frame whose pictures are written.")
    ] = 63,
    period: Annotated[int, typer.Option(min=1, max=65_535, help="Refresh period.")] = 32,
    block: Annotated[int, typer.Option(min=2, help="Block edge, pixels, even.")] = 4,
    size: Annotated[str, typer.Option(metavar="W[xH]", help="Picture size.")] = "1024",
    cache_format: Annotated[
        CacheFormat, typer.Option("--format", help="Texel format of the cache.")
    ] = "rgba16f",
    epsilon: Annotated[
        float, typer.Option(min=0.0, help="Depth tolerance, relative to 1/w.")
    ] = DEFAULT_EPSILON,
    mesh: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Draw this mesh (.npz) instead.")
    ] = None,
    unprofitable: Annotated[
        bool, typer.Option("--unprofitable", help="Also nodes that cost less than a fetch.")
    ] = False,
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
    view: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME",
            help="Debug view; repeat it for several: hits, hit, refresh, clip, depth, id, poison, "
            "age, or all.",
        ),
    ] = None,
    out: Annotated[
        Path,
        typer.Option(
            "-o", "--output", metavar="DIR", parser=folder, help="Folder for the pictures."
        ),
    ] = Path("out/run"),
) -> None:
    """Run a variant from a reset up to a frame; write original, cached, 10x difference, hit map.

    The hit map, and each further --view, shows in false colours what became of each pixel.
    """
    from shadercache.emit.depth_range import depth_warnings
    from shadercache.gpu.context import open_context
    from shadercache.linking.linker import Linker
    from shadercache.linking.scene_shaders import open_scene
    from shadercache.linking.user_places import at_home
    from shadercache.measure.measure import measure
    from shadercache.measure.measurement import MeasureOptions
    from shadercache.measure.subjects import VariantSubject
    from shadercache.render.render_scene import RenderScene
    from shadercache.scene.mesh import replacement_mesh

    extent = parse_size(size)
    every, edge = parse_periods(str(period))[0], parse_blocks(str(block))[0]
    reading = read_options(define, undefine, include, dialect, max_tokens, unroll)
    scene, analysis = open_scene(find_scene(target), reading, mapping)
    [by] = parse_passes(passes)
    [(label, chosen)] = choose_nodes(scene, analysis, ["+".join(node)])
    analysis.require_all(chosen, unprofitable)
    configuration = configured(
        scene,
        Configuration(
            nodes=tuple(item.id for item in chosen),
            algorithm=by,
            refresh=Refresh(period=every, block=edge),
            hit_test=HitTest(epsilon=epsilon),
            storage=Storage(cache_format),
            fetches=fetches,
        ),
        cache,
    )
    context.obj.show(depth_warnings(configuration, scene.camera.near, scene.camera.far))
    linker = Linker(scene, analysis)
    assignment = linker.assign(configuration)
    subject = VariantSubject(label, configuration, linker.link(assignment), assignment)
    how = MeasureOptions(frame + 1, picture_frame=frame, weigh=weigh)
    replacement = replacement_mesh(scene, mesh)
    with (
        open_context() as gpu,
        at_home(analysis),
        RenderScene(gpu, linker.scene, extent, mesh=replacement) as world,
        step_progress(f"running {label}") as tell,
    ):
        found = measure(world, linker.originals(), [subject], how, tell)
    print(f"mapping: {analysis.mapping}")
    print(f"{summary(found)}\n\n{result_table(found, lambda item: item.label)}\n")
    for shot in found.shots:
        for path in write_pictures(out, shot, view or ["hits"]):
            print(path)
