"""``shadercache rewrite``: the variants that cache a node or a set, and the engine's manifest."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from shadercache.caching.configuration import CacheFormat, Configuration, Mode, Storage
from shadercache.caching.settings import with_settings
from shadercache.cli.io import MANIFEST, atomic_folder, folder, read_pair
from shadercache.cli.measuring import PASSES, one_of, parse_passes
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
from shadercache.diagnostics import usage_error
from shadercache.front.read_options import MAX_TOKENS

if TYPE_CHECKING:
    from shadercache.compiler import Emission
    from shadercache.manifest.model import Manifest


def command(
    context: typer.Context,
    fragment: Annotated[str, typer.Argument(metavar="FRAG", help="Fragment shader; - is stdin.")],
    node: Annotated[
        list[str],
        typer.Option(metavar="ID", help="The node to cache, from 'nodes'; several are one set."),
    ],
    out: Annotated[
        Path,
        typer.Option("-o", "--output", metavar="DIR", parser=folder, help="Folder to write."),
    ],
    vert: Annotated[
        str | None,
        typer.Option(metavar="FILE", help="Vertex shader; if left out, FRAG with .vert."),
    ] = None,
    passes: Annotated[
        str,
        typer.Option(
            metavar="|".join(PASSES), parser=one_of(PASSES), help="Geometry passes of the variant."
        ),
    ] = "all",
    cache_format: Annotated[
        CacheFormat, typer.Option("--format", help="Texel format of the cache.")
    ] = "rgba16f",
    mode: Annotated[
        Mode, typer.Option(help="proof pins the arithmetic down (#version 400, 320 es).")
    ] = "plain",
    unprofitable: Annotated[
        bool, typer.Option("--unprofitable", help="Also nodes that cost less than a fetch.")
    ] = False,
    carry: Annotated[
        bool, typer.Option("--carry", help="Also cache what payload and shading both compute.")
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
) -> None:
    """Write the shaders that cache one node, or several together, and how to run them.

    Several nodes (--node A --node B, or A+B) share the texels of one cache, the look-up and the
    refresh: up to seven channels in all. How to run them is in manifest.json, which is written
    last.
    """
    from shadercache.compiler import analyse, rewrite

    options = read_options(define, undefine, include, dialect, max_tokens, unroll)
    analysis = analyse(*read_pair(fragment, vert), options, mapping)
    if analysis.vertex is None and not analysis.full_screen:
        hint = "name it with --vert, or draw full-screen with --mapping screen"
        raise usage_error("SC005", "the vertex shader is missing", hint)
    nodes = analysis.nodes_of("+".join(node))
    analysis.require_all(nodes, unprofitable)
    told = () if carry else analysis.overlap_notes(nodes)
    chosen = with_settings(
        Configuration(
            nodes=tuple(item.id for item in (analysis.carrying(nodes) if carry else nodes)),
            storage=Storage(cache_format),
            fetches=fetches,
            mode=mode,
        ),
        cache or (),
    )
    wanted = [replace(chosen, algorithm=name) for name in parse_passes(passes)]
    emission = rewrite(analysis, wanted, unprofitable=unprofitable)
    _write(emission, out)
    context.obj.show((*analysis.notes, *emission.notes, *told))
    print(
        f"wrote {len(emission.files)} shaders and {MANIFEST} to {out} (mapping: {analysis.mapping})"
    )


def _write(emission: Emission[Manifest], out: Path) -> None:
    from shadercache.manifest.codec import encode

    with atomic_folder(out) as folder:
        for name, text in emission.files.items():
            (folder / name).write_text(text, encoding="utf-8", newline="")
        (folder / MANIFEST).write_text(encode(emission.manifest), encoding="utf-8", newline="")
