"""``shadercache scene``: the first scene file for a model and a pair of shaders."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from shadercache.cli import options
from shadercache.cli.io import atomic_folder, read_pair
from shadercache.cli.scenes import SCENE_FILE
from shadercache.diagnostics import Diagnostic, Severity, usage_error

READ = options.ShaderOptions()


def command(
    context: typer.Context,
    model: Annotated[
        Path, typer.Argument(metavar="MODEL", help="A .glb, .gltf, .obj, .ply or .stl file.")
    ],
    frag: Annotated[Path, typer.Option(metavar="FILE", help="Fragment shader.")],
    out: Annotated[Path, options.output("Folder to write.")],
    vert: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Vertex shader; if left out, FRAG with .vert."),
    ] = None,
    up: Annotated[
        Literal["y", "z"], typer.Option(help="The axis of the model that points up.")
    ] = "y",
    force: Annotated[
        bool, typer.Option("--force", help="Write over a scene.toml that is there.")
    ] = False,
    reading: options.ShaderOptions = READ,
) -> None:
    """Write a scene.toml for your own model and shaders, ready for run, bench and verify.

    Attributes are matched by name and type, matrices by their meaning; the camera sees all of the
    model, which turns. What was guessed stands in comments.
    """
    from shadercache.compiler import analyse
    from shadercache.linking.first_scene.scene_text import Sources, first_scene
    from shadercache.scene.models.load import load_model

    if (out / SCENE_FILE).exists() and not force:
        hint = "--force writes over it"
        raise usage_error("SC038", f"there is a {out / SCENE_FILE} already", hint)
    vertex = vert or frag.with_suffix(".vert")
    if not vertex.is_file():
        raise usage_error("SC005", "the vertex shader is missing", "name it with --vert")
    analysis = analyse(*read_pair(str(frag), str(vertex)), reading.read_options(), "surface")
    sources = Sources(load_model(model), frag, vertex, up)
    with atomic_folder(out) as folder:
        scene = first_scene(sources, analysis, folder, out)
        (folder / SCENE_FILE).write_text(scene.text, encoding="utf-8", newline="")
    if scene.unknown:
        message = f"neither names nor model say what these are: {', '.join(scene.unknown)}"
        hint = f"they have stand-ins in {out / SCENE_FILE}"
        context.obj.show([Diagnostic("SC039", message, None, None, hint, Severity.WARNING)])
    objects = "1 object" if scene.objects == 1 else f"{scene.objects} objects"
    print(f"wrote {out / SCENE_FILE}: {objects}\nnext: shadercache bench {out / SCENE_FILE}")
