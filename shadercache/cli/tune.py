"""``shadercache tune``: choose what to cache, within a bound of the error, and prove the choice."""

from __future__ import annotations

import json
import re
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from shadercache.cli import options
from shadercache.cli.measuring import opened
from shadercache.cli.tables import shorten
from shadercache.diagnostics import usage_error
from shadercache.measure.metrics.frame_errors import Metric

if TYPE_CHECKING:
    from shadercache.tuning.bound import Bound
    from shadercache.tuning.choose import Answer, Tuning

AUTO, LARGEST = "auto", "512"
_SECONDS = re.compile(r"(\d+(?:\.\d+)?)\s*(s|m|min)?")
_BESIDE = 60


@dataclass(frozen=True, kw_only=True)
class TunePicture(options.PictureOptions):
    """As for other commands, but the size may be left to the tool."""

    size: Annotated[
        str,
        typer.Option(
            metavar="W[xH]", help="Picture size; auto is 512, or less where a frame takes long."
        ),
    ] = AUTO

    def __post_init__(self) -> None:
        if self.size != AUTO:
            super().__post_init__()


PICTURE = TunePicture()


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
    metric: Annotated[
        Metric, typer.Option(help="In which metric; flip needs the extra 'metrics'.")
    ] = "rmse",
    budget: Annotated[
        str, typer.Option(metavar="75s", help="How long to look; 2m are two minutes.")
    ] = "75s",
    frames: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Play what an engine recorded (.csv, .toml)."),
    ] = None,
    picture: TunePicture = PICTURE,
    as_json: Annotated[bool, typer.Option("--json", help="Print all that was found.")] = False,
    page: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Also write it as one page; needs the extra 'report'."),
    ] = None,
) -> None:
    """Choose the values to cache, how, and how often to refresh them; prove it on other frames.

    What is printed holds on frames that the choice was not made by: another part of the scene's
    path, and a part at twice the speed, each with the error of every frame within the bound. Where
    nothing is faster than the original it says so: leave the shader alone.
    """
    from shadercache.files import write_bytes
    from shadercache.linking.linker import Linker
    from shadercache.measure.result_files import environment
    from shadercache.report.parts.page_parts import plotly_script
    from shadercache.report.tuning_page.tuning_page import page_of
    from shadercache.tuning.budget import Budget
    from shadercache.tuning.choose import TuneQuestion, tune
    from shadercache.tuning.front import worth_a_look
    from shadercache.tuning.result import to_json

    if page is not None:
        plotly_script()  # raised before minutes are spent, where it is missing
    clock = Budget(parse_seconds(budget))
    fixed = picture.size != AUTO
    question = TuneQuestion(parse_bounds(max_error, metric), clock.seconds, fixed)
    picture = picture if fixed else replace(picture, size=LARGEST)
    linker = Linker(*source.open(context, frames))
    with opened(linker, picture, linker.scene.name) as (world, tell):
        found = tune(
            world,
            linker,
            question,
            clock,
            lambda spent, what: tell(int(1000 * min(1.0, spent)), 1000, what),
        )
        everything = to_json(found, linker.scene, environment(world.gpu))
        if page is not None:
            plans = worth_a_look(found, linker.scene)
            write_bytes(page, page_of(everything, world, linker, plans, tell))
    if as_json:
        print(json.dumps(everything, indent=1))
        return
    print(_head(found))
    for answer in found.answers:
        print(f"\n{_told(found, answer)}")
    if page is not None:
        print(f"\nwrote {page}")


def parse_seconds(text: str) -> float:
    """``60s``, ``2m`` or ``90`` in seconds. Raises :class:`UsageError` SC008."""
    match = _SECONDS.fullmatch(text.strip())
    if match is None or float(match[1]) == 0.0:
        raise usage_error("SC008", f"'{text}' is no value for --budget", "give 60s or 2m")
    return float(match[1]) * (_BESIDE if (match[2] or "s").startswith("m") else 1)


def parse_bounds(text: str, metric: Metric) -> tuple[Bound, ...]:
    """The bounds of ``0.002,0.005``. Raises :class:`UsageError` SC008."""
    from shadercache.tuning.bound import Bound

    try:
        limits = [float(part) for part in text.split(",")]
    except ValueError:
        hint = "give numbers above 0, separated by commas"
        raise usage_error("SC008", f"'{text}' is no value for --max-error", hint) from None
    return tuple(Bound(metric, limit) for limit in dict.fromkeys(limits))


def _head(found: Tuning) -> str:
    drawings = found.drawings
    trials, (width, height) = drawings.trials, drawings.size
    tried = len({(one.group, one.value.ids) for one in trials.families})
    offered = sum(node.offered for group in found.pools for node in group.analysis.nodes)
    lines = [
        f"original {drawings.original * 1e3:.1f} ms at {width}x{height}; {tried} values of "
        f"{offered:,} offered nodes tried, {found.drawn} of {found.combinations:,} combinations "
        f"drawn in {drawings.spent:.0f} s"
    ]
    if trials.failed:
        lines.append(f"{len(trials.failed)} could not be drawn, such as: {trials.failed[0].why}")
    return "\n".join(lines)


def _told(found: Tuning, answer: Answer) -> str:
    from shadercache.tuning.result import told

    bound, proven = answer.bound, answer.chosen
    if proven is None:
        return f"{bound}: leave it alone; {answer.why}"
    ratio = proven.speedup
    lines = [
        f"{bound}: {ratio.median:.2f}x [{ratio.low:.2f}-{ratio.high:.2f}] as fast as the original, "
        f"error {bound.told(proven.mean)}, in the worst frame {bound.told(proven.worst)}"
    ]
    for family, period in proven.plan.parts:
        source = family.group.analysis.fragment
        for node in family.value.nodes:
            line, column = source.position(node.expr.span.start)
            name = source.part(node.expr.span.start).name
            lines.append(f"  cache {shorten(node.text, 60)}   {name}:{line}:{column} ({node.id})")
        lines.append(f"  by {told(family.at(period))}")
    lines += [
        f"  {passage.name}: {drawn.speedup.median:.2f}x, error {bound.told(drawn.worst)} at most"
        for passage, drawn in proven.passages
    ]
    return "\n".join(lines)
