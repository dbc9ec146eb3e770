"""``shadercache assets``: optional data that may not be distributed with the project."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Annotated, Literal

import typer

from shadercache.cli.progress import progress
from shadercache.diagnostics import usage_error

TERMS = """\
The Stanford dragon, from the Stanford 3D Scanning Repository
(https://graphics.stanford.edu/data/3Dscanrep/), by way of an npm package.

Its terms: for research use. Credit the Stanford Computer Graphics Laboratory when you show it.
No commercial use without permission. The dragon is a symbol of Chinese culture: keep what you
make of it in good taste. Do not commit the mesh, and do not pass it on with the project.
"""


def command(
    name: Annotated[Literal["dragon"], typer.Argument(metavar="NAME", help="dragon.")],
    accept_terms: Annotated[
        bool, typer.Option("--accept-terms", help="You have read the terms and keep to them.")
    ] = False,
    out: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="FILE", help="The .npz file to write."),
    ] = None,
) -> None:
    """Fetch the real Stanford dragon for the dragon scene (optional).

    The mesh has 75,000 faces. Nothing needs it; it is for research use only.
    """
    print(TERMS)
    if not accept_terms:
        _ask()
    from shadercache.cli import stanford_dragon

    path = out or _user_folder() / "stanford-dragon.npz"
    with progress("dragon", 3) as advance:
        packed = stanford_dragon.download()
        advance(1)
        points, faces = stanford_dragon.read_ply(packed)
        advance(1)
        stanford_dragon.write_mesh(path, *stanford_dragon.decimate(points, faces))
        advance(1)
    print(f"wrote {path}\nuse it: shadercache bench corpus/dragon/scene.toml --mesh {path}")


def _ask() -> None:
    if not sys.stdin.isatty() or not typer.confirm("Do you accept the terms?"):
        raise usage_error(
            "SC030", "the terms are not accepted", hint="--accept-terms says that you keep to them"
        )


def _user_folder() -> Path:
    """Where the XDG base directory specification puts a user's data."""
    base = Path(os.environ.get("XDG_DATA_HOME", ""))
    return (base if base.is_absolute() else Path.home() / ".local" / "share") / "shadercache"
