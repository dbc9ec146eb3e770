"""``shadercache tune``: choose what to cache, within a bound of the error, and prove the choice."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Annotated

import typer

from shadercache.cli import options
from shadercache.cli.choosing import (
    AUTO,
    LookOptions,
    TuneFiles,
    TunePicture,
    choose,
    told_choice,
)

LOOK, PICTURE = LookOptions(), TunePicture()


def command(
    context: typer.Context,
    source: options.SceneOptions,
    max_error: Annotated[
        str,
        typer.Option(
            metavar="E,...",
            help="What the error of a frame may be at most; of psnr in dB, at least.",
        ),
    ],
    look: LookOptions = LOOK,
    frames: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Play what an engine recorded (.csv, .toml)."),
    ] = None,
    picture: TunePicture = PICTURE,
    out: Annotated[
        Path | None, options.output("Write all that an engine needs to run the choice.")
    ] = None,
    page: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Also write it as one page; needs the extra 'report'."),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print all that was found.")] = False,
) -> None:
    """Choose the values to cache, how, and how often to refresh them; prove it on other frames.

    What is printed holds on frames that the choice was not made by: another part of the scene's
    path, and a part at twice the speed, each with the error of every frame within the bound. Where
    nothing is faster than the original it says so: leave the shader alone.
    """
    from shadercache.tuning.budget import Budget
    from shadercache.tuning.choose import TuneQuestion

    clock = Budget(look.seconds)
    question = TuneQuestion(look.bounds(max_error), clock.seconds, picture.size != AUTO)
    scene = source.open(context, frames)
    chosen = choose(scene, question, picture, clock, TuneFiles(out, page))
    print(json.dumps(chosen.report, indent=1) if as_json else told_choice(chosen))
