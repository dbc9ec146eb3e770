"""``shadercache nodes``: every value of a shader, what it costs, and whether it may be cached."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from shadercache.cli.io import read_source
from shadercache.cli.node_views.nodes_json import changes_of, print_nodes
from shadercache.cli.node_views.shortlist import MAPPINGS, told_in_one_look
from shadercache.cli.options import FragmentArgument, ShaderOptions
from shadercache.cli.scenes import find_scene
from shadercache.cli.tables import format_table, shorten, terminal_width

if TYPE_CHECKING:
    from shadercache.analysis.candidates import Candidate
    from shadercache.compiler import Analysis

HEADER = ("id", "path", "at", "type", "cost", "P/T", "twice", "verdict", "class", "inputs", "text")
INPUTS_WIDTH = 24
TEXT_WIDTH = 60
READ = ShaderOptions()


def command(
    context: typer.Context,
    fragment: FragmentArgument,
    vert: Annotated[
        str | None, typer.Option(metavar="FILE", help="Vertex shader that goes with it.")
    ] = None,
    offered: Annotated[
        bool | None,
        typer.Option(
            "--offered/--all", help="A table of all that is offered, or of everything there is."
        ),
    ] = None,
    scene: Annotated[
        str | None,
        typer.Option(metavar="SCENE", help="Scene that says which uniforms change, and why."),
    ] = None,
    sort: Annotated[
        Literal["source", "ratio"] | None,
        typer.Option(help="The table by call path and place, or by P/T; --all if nothing is said."),
    ] = None,
    reading: ShaderOptions = READ,
    as_json: Annotated[bool, typer.Option("--json", help="Everything as JSON.")] = False,
) -> None:
    """Say which values of a shader are worth caching, or list them all.

    A node is one evaluation of one expression, on one path of calls. Shown are ten values at most,
    one of those that are equal or alike: the share of the shader that caching it would save at most
    (by static costs, the look-up paid), where it stands, and what changes it: with --scene, the
    view, the light or the time.

    --all and --offered print a table instead. P/T is the static cost of the value over that of the
    whole shader; "twice" is the share of the shader's cost that the payload and the shading that is
    left both compute. The verdict is "offered" or the code of the reason why the value may not be
    cached. The class is "surface", "view" (it changes with the camera) or "screen" (it depends on
    where or how large a surface is seen: offered with --approximate, exact at rest).

    --json leaves nothing out, and says everything once: nodes have numbers of expressions, paths,
    inputs and refusals in tables of these. Nodes that have the same value share a "group", and
    values of uniforms only come with the GLSL to compute "on_cpu".
    """
    from shadercache.analysed import value_classes
    from shadercache.compiler import analyse
    from shadercache.linking.scene_shaders import read_as_in
    from shadercache.scene.description import load_scene

    options, source = reading.read_options(), read_source(fragment)
    given = load_scene(find_scene(scene)) if scene else None
    if given is not None:
        options = read_as_in(given, options)
    changes = given.changes if given else None
    mapping = reading.mapping or (given.mapping if given else None)
    analysis = analyse(source, read_source(vert) if vert else None, options, mapping)
    context.obj.show(analysis.kept_loops)
    shown = [node for node in analysis.nodes if node.offered or not offered]
    if sort == "ratio":
        shown.sort(key=lambda node: node.ratio)
    if as_json:
        print(print_nodes(analysis, shown, changes))
        return
    if offered is None and sort is None:
        print(told_in_one_look(analysis, changes, [fragment, *(["--vert", vert] if vert else [])]))
        return
    classes = value_classes(analysis, changes)
    rows = [_row(analysis, node, classes(node), changes) for node in shown]
    header = HEADER if changes is None else (*HEADER[:-1], "changes with", HEADER[-1])
    print(format_table(header, rows, right="at cost P/T twice", width=terminal_width()))
    print(f"\n{_summary(analysis.nodes)}")
    print(f"\nmapping: {analysis.mapping}, {MAPPINGS[analysis.mapping]}")


def _row(
    analysis: Analysis, node: Candidate, value_class: str, changes: Mapping[str, str] | None
) -> tuple[str, ...]:
    line, column = analysis.fragment.position(node.expr.span.start)
    parts = analysis.shared_work.parts((node,)) if node.legal else None
    causes = {} if changes is None else changes_of(node, changes)
    changing = "; ".join(f"{cause}: {' '.join(names)}" for cause, names in causes.items())
    return (
        node.id,
        node.path,
        f"{line}:{column}",
        str(node.type),
        f"{node.cost:.0f}",
        f"{node.ratio:.3f}",
        f"{parts.overlap / (parts.whole or 1.0):.3f}" if parts else "",
        node.refusal.code.code if node.refusal else "offered",
        value_class,
        shorten(" ".join(sorted(node.inputs)), INPUTS_WIDTH),
        *(() if changes is None else (shorten(changing, INPUTS_WIDTH),)),
        shorten(node.text, TEXT_WIDTH),
    )


def _summary(nodes: Sequence[Candidate]) -> str:
    """How many nodes are offered, and how many are refused for which reason."""
    reasons = Counter(node.refusal.code for node in nodes if node.refusal)
    lines = [f"{len(nodes)} nodes, {len(nodes) - reasons.total()} offered"]
    for code, count in sorted(reasons.items(), key=lambda reason: reason[0].code):
        lines.append(f"{count:6} {code.code}: {code.sentence}")
    return "\n".join(lines)
