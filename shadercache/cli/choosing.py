"""What ``tune`` and ``rewrite --auto`` share: bounds, budgets, and the files of what was chosen."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from shadercache.cli import options
from shadercache.cli.io import MANIFEST, atomic_folder
from shadercache.cli.measuring import opened
from shadercache.cli.tables import shorten
from shadercache.diagnostics import usage_error
from shadercache.measure.metrics.frame_errors import Metric

if TYPE_CHECKING:
    from collections.abc import Mapping

    from shadercache.compiler import Analysis
    from shadercache.linking.linker import Linker
    from shadercache.scene.description import Scene
    from shadercache.scene.mesh import Mesh
    from shadercache.tuning.bound import Bound
    from shadercache.tuning.budget import Budget
    from shadercache.tuning.choose import Answer, TuneQuestion, Tuning

AUTO, LARGEST = "auto", "512"
_SECONDS = re.compile(r"(\d+(?:\.\d+)?)\s*(s|m|min)?")
_MINUTE = 60


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


@dataclass(frozen=True, kw_only=True)
class LookOptions:
    """In which metric errors are measured, and how long is looked."""

    metric: Annotated[
        Metric, typer.Option(help="In which metric; flip needs the extra 'metrics'.")
    ] = "rmse"
    budget: Annotated[
        str, typer.Option(metavar="75s", help="How long to look; 2m are two minutes.")
    ] = "75s"

    @property
    def seconds(self) -> float:
        """``60s``, ``2m`` or ``90`` in seconds. Raises :class:`UsageError` SC008."""
        match = _SECONDS.fullmatch(self.budget.strip())
        if match is None or float(match[1]) == 0.0:
            message = f"'{self.budget}' is no value for --budget"
            raise usage_error("SC008", message, "give 60s or 2m")
        return float(match[1]) * (_MINUTE if (match[2] or "s").startswith("m") else 1)

    def bounds(self, text: str) -> tuple[Bound, ...]:
        """The bounds of ``0.002,0.005``. Raises :class:`UsageError` SC008."""
        from shadercache.tuning.bound import Bound

        try:
            limits = [float(part) for part in text.split(",")]
        except ValueError:
            hint = "give numbers above 0, separated by commas"
            raise usage_error("SC008", f"'{text}' is no value for --max-error", hint) from None
        return tuple(Bound(self.metric, limit) for limit in dict.fromkeys(limits))


@dataclass(frozen=True)
class Chosen:
    """What was found in a scene, as it is and as JSON, and the folders that were written."""

    found: Tuning
    report: dict[str, Any]
    written: tuple[str, ...] = ()


@dataclass(frozen=True)
class TuneFiles:
    """What is to be written: a folder for an engine, a page."""

    out: Path | None = None
    page: Path | None = None


def choose(
    scene: tuple[Scene, Analysis],
    question: TuneQuestion,
    picture: TunePicture,
    clock: Budget,
    wanted: TuneFiles,
) -> Chosen:
    """Tune a scene, and write what is wanted of it.

    Raises as ``tune``, ``hand_over`` and ``page_of``; :class:`UsageError` SC031 for a page without
    plotly, before minutes are spent.
    """
    from shadercache.files import write_bytes
    from shadercache.linking.linker import Linker
    from shadercache.measure.result_files import environment
    from shadercache.report.parts.page_parts import plotly_script
    from shadercache.report.tuning_page.tuning_page import page_of
    from shadercache.scene.mesh import replacement_mesh
    from shadercache.tuning.choose import tune
    from shadercache.tuning.front import worth_a_look
    from shadercache.tuning.result import to_json

    if wanted.page is not None:
        plotly_script()
    linker = Linker(*scene)
    drawn = picture if question.size_is_fixed else replace(picture, size=LARGEST)
    with opened(linker, drawn, linker.scene.name) as (world, tell):

        def told(spent: float, what: str) -> None:
            tell(int(1000 * min(1.0, spent)), 1000, what)

        found = tune(world, linker, question, clock, told)
        where = environment(world.gpu)
        report: dict[str, Any] = to_json(found, linker.scene, where)
        if wanted.page is not None:
            plans = worth_a_look(found, linker.scene)
            write_bytes(wanted.page, page_of(report, world, linker, plans, tell))
    written = [] if wanted.page is None else [f"wrote {wanted.page}"]
    if wanted.out is not None:
        mesh = replacement_mesh(linker.scene, picture.mesh)
        folders = _write_choices(wanted.out, linker, found, mesh, where)
        written += [f"wrote {folder}: begin with {folder / 'INTEGRATION.md'}" for folder in folders]
    return Chosen(found, report, tuple(written))


def _write_choices(
    out: Path, linker: Linker, found: Tuning, mesh: Mesh | None, where: Mapping[str, Any]
) -> list[Path]:
    """Write what an engine needs of each choice: into the folder, or of several bounds each into a
    folder in it, named by the bound. Returns those that were written.

    Raises :class:`UsageError` SC002; and as ``hand_over``.
    """
    chosen = [answer for answer in found.answers if answer.chosen is not None]
    written = []
    for answer in chosen:
        folder = out if len(found.answers) == 1 else out / f"{answer.bound.limit:g}"
        files = _files(linker, found, answer, mesh, where)
        with atomic_folder(folder) as staged:
            # Manifests last: a folder with one is whole.
            for name in sorted(files, key=lambda name: name.endswith(MANIFEST)):
                path = staged / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(files[name])
        written.append(folder)
    return written


def _files(
    linker: Linker, found: Tuning, answer: Answer, mesh: Mesh | None, where: Mapping[str, Any]
) -> dict[str, bytes]:
    from shadercache.report.hand_over.expected import Expected
    from shadercache.report.hand_over.handed_files import hand_over

    proven = answer.chosen
    assert proven is not None
    ratio = proven.speedup
    expected = Expected(
        speedup=ratio.median,
        low=ratio.low,
        high=ratio.high,
        metric=answer.bound.metric,
        mean=proven.mean,
        worst=proven.worst,
        bound=answer.bound.limit,
        size=found.drawings.size,
        frames=sum(len(drawn.errors) for _, drawn in proven.passages),
        renderer=where["gl"]["renderer"],
    )
    return hand_over(linker, proven.plan.assignment(linker.scene), expected, mesh)


def told_choice(chosen: Chosen) -> str:
    """What was found, in words, and where it was written."""
    found = chosen.found
    parts = [_head(found), *(_told(answer) for answer in found.answers)]
    return "\n\n".join([*parts, *chosen.written])


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


def _told(answer: Answer) -> str:
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
