"""``shadercache sweep``: every combination of choices into a result store, as often interrupted as
need be."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from shadercache.caching.configuration import DIVISORS
from shadercache.cli import options
from shadercache.cli.measuring import TrialOptions
from shadercache.cli.progress import progress
from shadercache.cli.scenes import find_scene, open_target
from shadercache.cli.tables import format_table
from shadercache.diagnostics import usage_error

if TYPE_CHECKING:
    from shadercache.caching.configuration import Configuration
    from shadercache.sweep.choices import Choices
    from shadercache.sweep.crew import Crew
    from shadercache.sweep.plan import SceneFile, SweepTrial
    from shadercache.sweep.row import Machine, Row
    from shadercache.sweep.store import Store


@dataclass(frozen=True, kw_only=True)
class ChoiceOptions:
    """The lists that are combined, and how each trial is drawn."""

    choices: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="TOML file with the lists, in place of these options."),
    ] = None
    nodes: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NODES",
            help=f"{options.NODE_HELP}; a+b is a set, commas part several. Without it one node of "
            "each value.",
        ),
    ] = None
    every_node: Annotated[
        bool, typer.Option("--every-node", help="Also nodes of the same value as another.")
    ] = False
    passes: Annotated[
        str, typer.Option(metavar=",".join(options.PASSES[:-1]), help="Algorithms.")
    ] = "all"
    period: Annotated[str, typer.Option(metavar="N,...", help="Refresh periods, frames.")] = "32"
    block: Annotated[str, typer.Option(metavar="K,...", help="Block edges, pixels.")] = "4"
    rate: Annotated[
        str, typer.Option(metavar=",".join(DIVISORS), help="Payload rates (see rewrite).")
    ] = "full"
    cache_format: Annotated[
        str, typer.Option("--format", metavar="FORMAT,...", help="Texel formats.")
    ] = "rgba16f"
    cache: Annotated[
        list[str] | None,
        typer.Option(
            metavar="KEY=VALUE,...",
            help="An alternative for how the cache works, as 'bench --cache'; may be repeated.",
        ),
    ] = None
    size: Annotated[str, typer.Option(metavar="W[xH]", help="Picture size.")] = "512"
    profile: Annotated[
        bool, typer.Option("--profile", help="Also where the frames of two passes go, by ablation.")
    ] = False

    def read(self, targets: Sequence[str], trial: TrialOptions) -> Choices:
        """The choices of the file, or of the options.

        Raises:
            UsageError: SC003, both a file and lists; SC007, SC008 for a value.
            InputError: SC035 for the file.
        """
        import msgspec

        from shadercache.sweep.choices import Choices, check_choices, read_choices

        if self.choices is not None:
            # Typer does not tell what was said, but what differs from its default was.
            if (replace(self, choices=None), trial) != (ChoiceOptions(), TRIAL):
                message = "--choices stands in place of the other lists"
                raise usage_error("SC003", message, "say everything in the file, or nothing")
            read = read_choices(self.choices)
            return msgspec.structs.replace(read, scenes=(*targets, *read.scenes))
        texts = {
            "scenes": list(targets),
            "nodes": options.split_names(self.nodes or ()),
            "every_node": self.every_node,
            "passes": [name.partition("-")[0] for name in options.parse_passes(self.passes)],
            "periods": options.parse_periods(self.period),
            "blocks": options.parse_blocks(self.block),
            "rates": options.parse_rates(self.rate),
            "formats": [part for part in self.cache_format.split(",") if part],
            "cache": self.cache or [""],
            "size": options.parse_size(self.size),
            "frames": trial.frames,
            "until": trial.until,
            "seconds": trial.seconds,
            "perceptual": trial.perceptual,
            "profile": self.profile,
        }
        try:
            return check_choices(msgspec.convert(texts, Choices))
        except msgspec.ValidationError as error:
            raise usage_error("SC008", f"the sweep's choices: {error}") from None


@dataclass(frozen=True, kw_only=True)
class WhichOptions:
    """Which trials of a plan are carried out; without any of these those that the store lacks."""

    force: Annotated[bool, typer.Option("--force", help="Also trials that are in the store.")] = (
        False
    )
    where: Annotated[
        list[str] | None,
        typer.Option(
            metavar="KEY=VALUE,...", help="Only these trials, e.g. passes=2,3; may be repeated."
        ),
    ] = None
    stale: Annotated[
        bool, typer.Option("--stale", help="Only trials whose sources have changed since.")
    ] = False

    def left(
        self, trials: Sequence[SweepTrial], machines: Sequence[Machine], store: Store
    ) -> list[SweepTrial]:
        """The trials that are to be carried out. Raises :class:`UsageError` SC008."""
        from shadercache.sweep.which_trials import chosen, on_each, read_conditions

        done, old = store.keys(), store.stale_identities()
        condition = read_conditions(self.where or (), trials[0].words(trials[0].configurations[0]))

        def wanted(trial: SweepTrial, one: Configuration) -> bool:
            places = on_each([trial], machines)
            return (
                condition(trial.words(one))
                # Done on one machine of a cluster is done: a trial is drawn by whichever is idle.
                and (self.force or not any(place.key(one) in done for place in places))
                and (not self.stale or any(place.identity(one) in old for place in places))
            )

        return chosen(trials, wanted)


@dataclass(frozen=True, kw_only=True)
class CrewOptions:
    """Who carries out trials."""

    cluster: options.ClusterOption = None
    patience: Annotated[
        float,
        typer.Option(
            min=1.0,
            metavar="SECONDS",
            help="A trial is given up when nothing is drawn for so long and for as long as 100 "
            "frames of the original.",
        ),
    ] = 90.0

    @contextmanager
    def open(self) -> Iterator[Crew]:
        """Raises as ``open_cluster`` and ``Worker.machine``."""
        from shadercache.cluster import open_cluster
        from shadercache.sweep.crew import ClusterCrew, LocalCrew

        if self.cluster is None:
            with LocalCrew(self.patience) as crew:
                yield crew
        else:
            with open_cluster(self.cluster) as client:
                yield ClusterCrew(client, self.patience)


TRIAL = TrialOptions(frames=24)
CHOICES, READ, WHICH, CREW = ChoiceOptions(), options.ShaderOptions(), WhichOptions(), CrewOptions()


def command(
    context: typer.Context,
    targets: Annotated[
        list[str] | None,
        typer.Argument(metavar="SCENE|FRAG...", help="Scenes, or shaders without one."),
    ] = None,
    choice: ChoiceOptions = CHOICES,
    trial: TrialOptions = TRIAL,
    reading: options.ShaderOptions = READ,
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="STORE", help="The result store.")
    ] = Path("out/sweep.db"),
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="Only print the plan and its estimated time.")
    ] = False,
    which: WhichOptions = WHICH,
    crew: CrewOptions = CREW,
    export: Annotated[
        list[Path] | None,
        typer.Option(metavar="FILE", help="Write all rows as .json, .csv or .parquet."),
    ] = None,
) -> None:
    """Measure every combination of nodes, algorithms, periods, blocks, formats and cache options.

    Each finished trial is a row of the store, under a key of all that determines it: the same
    command goes on where it was stopped, in whatever way. A shader that hangs or crashes the driver
    is a row with its error, and the sweep goes on. Lists are separated by commas. Without a scene
    only --export is done.
    """
    from shadercache.sweep.exports import check_export, write_export
    from shadercache.sweep.store import Store

    exports = [check_export(path) for path in export or ()]
    choices = choice.read(targets or (), trial)
    if not (choices.scenes or exports):
        raise usage_error("SC003", "there is nothing to sweep", "give a scene, or --export")
    trials = _planned(context, choices, reading)
    if trials:
        with crew.open() as workers:
            _sweep(trials, workers, output, which, dry_run)
    if exports and not dry_run:
        with Store(output) as store:
            rows = store.rows()
        for path in exports:
            write_export(path, rows)


def _planned(
    context: typer.Context, choices: Choices, reading: options.ShaderOptions
) -> list[SweepTrial]:
    from shadercache.sweep.plan import plan_scene

    files = [_file(context, target, reading) for target in choices.scenes]
    return [trial for file in files for trial in plan_scene(file, choices)]


def _file(context: typer.Context, target: str, reading: options.ShaderOptions) -> SceneFile:
    """What is opened by whoever carries out trials."""
    from shadercache.sweep.plan import SceneFile

    path, read = find_scene(target), reading.read_options()
    if path.suffix == ".toml":
        return SceneFile(path, read, reading.mapping)
    opened = open_target(context, target, None, read, reading.mapping)
    made = None if opened.path == path else opened.path
    return SceneFile(path, read, opened.mapping, made)


def _sweep(
    trials: Sequence[SweepTrial],
    crew: Crew,
    output: Path,
    which: WhichOptions,
    dry_run: bool,
) -> None:
    from shadercache.sweep.store import Store
    from shadercache.sweep.which_trials import on_each

    # A dry run leaves no store behind.
    if dry_run and not output.exists():
        _print_plan(trials, trials, crew)
        return
    with Store(output, create=True) as store:
        everywhere = on_each(trials, crew.machines)
        planned = {trial.identity(one): trial.key(one) for trial, one in _each(everywhere)}
        count = store.mark_stale(planned)
        if count:
            print(f"{_rows(count)} stale: the scene, or shadercache, has changed since")
        left = which.left(trials, crew.machines, store)
        _print_plan(trials, left, crew)
        if not dry_run:
            rows = _carried_out(left, crew, store)
            # Rows that were replaced leave their shaders and pictures behind.
            store.drop_unused()
            _print_end(rows, frozenset(planned.values()), output)


def _each(trials: Sequence[SweepTrial]) -> Iterator[tuple[SweepTrial, Configuration]]:
    return ((trial, one) for trial in trials for one in trial.configurations)


def _print_plan(trials: Sequence[SweepTrial], left: Sequence[SweepTrial], crew: Crew) -> None:
    from shadercache.sweep.estimate import plan_seconds

    originals: dict[SceneFile, float] = {}
    rows = []
    for file in dict.fromkeys(trial.file for trial in trials):
        of_scene = [trial for trial in trials if trial.file == file]
        to_do = [trial for trial in left if trial.file == file]
        frame = ""
        if to_do:
            seconds = crew.original_seconds(file, to_do[0].scene.size)
            if isinstance(seconds, float):
                originals[file], frame = seconds, f"{seconds * 1e3:.1f} ms"
            else:  # the rows will say so too
                frame = f"fails: {seconds.code}"
        payloads = len({trial.payload.label for trial in of_scene})
        counts = (payloads, len(list(_each(of_scene))), len(list(_each(to_do))))
        rows.append((of_scene[0].scene.name, *map(str, counts), frame))
    header = ("scene", "payloads", "rows", "to do", "original")
    print(format_table(header, rows, right="payloads rows original"))
    entry = trials[0].scene
    minutes = plan_seconds(left, originals) / 60.0 / len(crew.machines)
    about = f"about {minutes:.0f} min" if minutes >= 1.0 else "less than a minute"
    drawn = f"{entry.size[0]}x{entry.size[1]}, {entry.frames} frames and more"
    print(f"{drawn}; {about if left else 'nothing to do'}")


def _carried_out(trials: Sequence[SweepTrial], crew: Crew, store: Store) -> list[Row]:
    """Carry out what is left; returns the new rows."""
    rows: list[Row] = []
    with progress("sweep", len(list(_each(trials)))) as advance:

        def heard(row: Row) -> None:
            advance(1)
            rows.append(row)

        crew.carry_out(trials, store, heard)
    return rows


def _print_end(rows: Sequence[Row], planned: frozenset[str], output: Path) -> None:
    failures = [row for row in rows if row.failure is not None]
    print(f"written to {output}: {len(rows)}, of which failures: {len(failures)}")
    for row in failures:
        failure = row.failure
        assert failure is not None and row.configuration is not None
        where = f"{row.scene.name} {row.label} {row.configuration['algorithm']}"
        print(f"  {where}: {failure.kind}: {failure.message} [{failure.code}]")
    changed = sum(row.key not in planned for row in rows)
    if changed:
        print(
            f"the scene changed under the sweep: {_rows(changed)} of what it is now; "
            "the same command brings the others up to date"
        )
    where_drawn = sorted({row.machine.name for row in rows})
    if len(where_drawn) > 1:
        print(f"drawn on {' and '.join(where_drawn)}: never compare times of different machines")


def _rows(count: int) -> str:
    return "1 row is" if count == 1 else f"{count} rows are"
