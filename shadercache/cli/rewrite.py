"""``shadercache rewrite``: the variants that cache a node or a set, and the engine's manifest."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Annotated

import typer

from shadercache.caching.configuration import Mode
from shadercache.caching.settings import with_settings
from shadercache.cli import options
from shadercache.cli.choosing import (
    AUTO,
    LookOptions,
    TuneFiles,
    TunePicture,
    choose,
    told_choice,
)
from shadercache.cli.io import MANIFEST, atomic_folder, read_pair
from shadercache.diagnostics import usage_error

READ, CACHED = options.ShaderOptions(), options.CacheOptions()


@dataclass(frozen=True, kw_only=True)
class AutoOptions(LookOptions):
    """What is asked for in place of a node."""

    auto: Annotated[
        bool,
        typer.Option("--auto", help="Choose for me, as 'tune' does, on a scene that is made up."),
    ] = False
    max_error: Annotated[
        float | None, typer.Option(metavar="E", help="With --auto: the largest error of a frame.")
    ] = None
    size: Annotated[
        str,
        typer.Option(
            metavar="W[xH]",
            help="With --auto: picture size; auto is 512, or less where a frame takes long.",
        ),
    ] = AUTO

    def __post_init__(self) -> None:
        """Raises :class:`UsageError` SC003 for what says nothing without ``--auto``."""
        if not self.auto and (self.max_error is not None or self.size != AUTO):
            option = "--size" if self.max_error is None else "--max-error"
            raise usage_error("SC003", f"{option} goes with --auto", "add --auto, or leave it out")


@dataclass(frozen=True, kw_only=True)
class PayloadOptions:
    """Which values may be cached, and how they are computed."""

    mode: Annotated[
        Mode, typer.Option(help="proof pins the arithmetic down (#version 400, 320 es).")
    ] = "plain"
    unprofitable: options.UnprofitableOption = False
    rate: options.RateOption = "full"
    carry: Annotated[
        bool, typer.Option("--carry", help="Also cache what payload and shading both compute.")
    ] = False


BY_HAND, PAYLOAD = AutoOptions(), PayloadOptions()


def command(
    context: typer.Context,
    fragment: options.FragmentArgument,
    out: Annotated[Path, options.output("Folder to write.")],
    node: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NODE",
            help="What to cache, from 'nodes': an id, a text 'f(x)' or a place :LINE[:COLUMN];"
            " several are one set.",
        ),
    ] = None,
    auto: AutoOptions = BY_HAND,
    vert: Annotated[
        str | None,
        typer.Option(metavar="FILE", help="Vertex shader; if left out, FRAG with .vert."),
    ] = None,
    passes: Annotated[
        str,
        typer.Option(
            metavar="|".join(options.PASSES),
            parser=options.one_of(options.PASSES),
            help="Geometry passes of the variant.",
        ),
    ] = "all",
    how: PayloadOptions = PAYLOAD,
    reading: options.ShaderOptions = READ,
    caching: options.CacheOptions = CACHED,
) -> None:
    """Write the shaders that cache one node, or several together, and how to run them.

    Several nodes (--node A --node B, or A+B) share the texels of one cache, the look-up and the
    refresh: up to seven channels in all. How to run them is in manifest.json, which is written
    last. With --auto and --max-error the node is chosen as well, and all else: see tune.
    """
    from shadercache.analysed import carrying, overlap_notes
    from shadercache.compiler import analyse, rewrite
    from shadercache.manifest.codec import encode

    if auto.auto:
        shown = {one.name: getattr(reading, one.name) for one in fields(reading)}
        beside = None if vert is None else Path(vert)
        scene = options.SceneOptions(target=fragment, vert=beside, **shown)
        _choose(context, scene, auto, node, out)
        return
    if not node:
        raise usage_error("SC003", "missing option '--node'", "or --auto with --max-error")
    read_options = reading.read_options()
    analysis = analyse(*read_pair(fragment, vert), read_options, reading.mapping)
    if analysis.vertex is None and not analysis.full_screen:
        hint = "name it with --vert, or draw full-screen with --mapping screen"
        raise usage_error("SC005", "the vertex shader is missing", hint)
    # One by one: joined, two texts might be a third.
    nodes = tuple(found for name in node for found in analysis.nodes_of(name))
    analysis.require_all(nodes, how.unprofitable)
    overlaps = () if how.carry else overlap_notes(analysis, nodes)
    payload = tuple(node.id for node in (carrying(analysis, nodes) if how.carry else nodes))
    chosen = replace(caching.base, nodes=payload, mode=how.mode, payload_rate=how.rate)
    chosen = with_settings(chosen, caching.cache or ())
    wanted = [replace(chosen, algorithm=name) for name in options.parse_passes(passes)]
    emission = rewrite(analysis, wanted, unprofitable=how.unprofitable)
    with atomic_folder(out) as folder:
        for name, text in {**emission.files, MANIFEST: encode(emission.manifest)}.items():
            # Line ends as they were emitted, on every system.
            (folder / name).write_text(text, encoding="utf-8", newline="")
    context.obj.show((*analysis.notes, *emission.notes, *overlaps))
    print(
        f"wrote {len(emission.files)} shaders and {MANIFEST} to {out} (mapping: {analysis.mapping})"
    )


def _choose(
    context: typer.Context,
    source: options.SceneOptions,
    auto: AutoOptions,
    node: list[str] | None,
    out: Path,
) -> None:
    """What ``tune`` does, for one bound."""
    from shadercache.tuning.budget import Budget
    from shadercache.tuning.choose import TuneQuestion

    if node or auto.max_error is None:
        message = "--auto chooses the node" if node else "--auto needs a bound"
        raise usage_error("SC003", message, "give --auto --max-error 0.01, or --node")
    clock, picture = Budget(auto.seconds), TunePicture(size=auto.size)
    bounds = auto.bounds(str(auto.max_error))
    question = TuneQuestion(bounds, clock.seconds, picture.size != AUTO)
    chosen = choose(source.open(context), question, picture, clock, TuneFiles(out))
    print(told_choice(chosen))
