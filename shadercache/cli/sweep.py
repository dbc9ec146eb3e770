"""``shadercache sweep``: every combination of choices into a result store, as often interrupted as
need be."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from shadercache.cli import options
from shadercache.cli.progress import progress
from shadercache.cli.scenes import find_scene
from shadercache.cli.tables import format_table
from shadercache.diagnostics import DiagnosticError, usage_error

if TYPE_CHECKING:
    from shadercache.sweep.choices import Choices
    from shadercache.sweep.plan import SweepTrial
    from shadercache.sweep.row import Row
    from shadercache.sweep.store import Store
    from shadercache.sweep.worker import Worker


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
            metavar="IDS",
            help="Ids or the scene's names; a+b is a set. Without it one node of each value.",
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
    frames: Annotated[int, typer.Option(min=2, help="Frames that every trial draws.")] = 24
    until: Annotated[
        float,
        typer.Option(metavar="PERCENT", help="Then frames are timed until ratios are this sure,"),
    ] = 3.0
    seconds: Annotated[
        float, typer.Option(min=0.0, help="or for so long, whichever comes first.")
    ] = 30.0

    def read(self, targets: Sequence[str]) -> Choices:
        """The choices of the file, or of the options.

        Raises:
            UsageError: SC003, both a file and lists; SC007, SC008 for a value.
            InputError: SC035 for the file.
        """
        import msgspec

        from shadercache.sweep.choices import Choices, check_choices, read_choices

        if self.choices is not None:
            if replace(self, choices=None) != ChoiceOptions():
                message = "--choices stands in place of the other lists"
                raise usage_error("SC003", message, "say everything in the file, or nothing")
            read = read_choices(self.choices)
            return msgspec.structs.replace(read, scenes=(*targets, *read.scenes))
        texts = {
            "scenes": list(targets),
            "nodes": [part for text in self.nodes or () for part in text.split(",") if part],
            "every_node": self.every_node,
            "passes": [name.partition("-")[0] for name in options.parse_passes(self.passes)],
            "periods": options.parse_periods(self.period),
            "blocks": options.parse_blocks(self.block),
            "formats": [part for part in self.cache_format.split(",") if part],
            "cache": self.cache or [""],
            "size": options.parse_size(self.size),
            "frames": self.frames,
            "until": self.until,
            "seconds": self.seconds,
        }
        try:
            return check_choices(msgspec.convert(texts, Choices))
        except msgspec.ValidationError as error:
            raise usage_error("SC008", f"the sweep's choices: {error}") from None


CHOICES, READ = ChoiceOptions(), options.ShaderOptions()


def command(
    targets: Annotated[
        list[str] | None,
        typer.Argument(metavar="SCENE|FRAG...", help="Scenes, or full-screen shaders."),
    ] = None,
    choice: ChoiceOptions = CHOICES,
    reading: options.ShaderOptions = READ,
    output: Annotated[
        Path, typer.Option("-o", "--output", metavar="STORE", help="The result store.")
    ] = Path("out/sweep.db"),
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="Only print the plan and its estimated time.")
    ] = False,
    force: Annotated[
        bool, typer.Option("--force", help="Also trials that are in the store.")
    ] = False,
    where: Annotated[
        list[str] | None,
        typer.Option(
            metavar="KEY=VALUE,...", help="Only these trials, e.g. passes=2,3; may be repeated."
        ),
    ] = None,
    stale: Annotated[
        bool, typer.Option("--stale", help="Only trials whose sources have changed since.")
    ] = False,
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
    from shadercache.sweep.worker import Worker

    exports = [check_export(path) for path in export or ()]
    choices = choice.read(targets or ())
    if not (choices.scenes or exports):
        raise usage_error("SC003", "there is nothing to sweep", "give a scene, or --export")
    trials = _planned(choices, reading)
    with Worker() as worker:
        if trials:
            machine = worker.machine()
            trials = [replace(trial, machine=machine) for trial in trials]
        if dry_run and not output.exists():
            _print_plan(trials, trials, worker)
            return
        with Store(output, create=bool(trials)) as store:
            left = _left(trials, store, where or (), force, stale)
            if trials:
                _print_plan(trials, left, worker)
            if dry_run:
                return
            failures = _carried_out(left, worker, store)
            for path in exports:
                write_export(path, store.rows())
    _print_end(left, failures, output)


def _planned(choices: Choices, reading: options.ShaderOptions) -> list[SweepTrial]:
    from shadercache.sweep.plan import SceneFile, plan_scene

    read = reading.read_options()
    return [
        trial
        for target in choices.scenes
        for trial in plan_scene(SceneFile(find_scene(target), read, reading.mapping), choices)
    ]


def _left(
    trials: Sequence[SweepTrial], store: Store, where: Sequence[str], force: bool, stale: bool
) -> list[SweepTrial]:
    """The trials that are to be carried out."""
    from shadercache.sweep.which_trials import chosen, read_conditions

    if not trials:
        return []
    keys = {trial.identity(one): trial.key(one) for trial in trials for one in trial.configurations}
    count = store.mark_stale(keys)
    if count:
        print(f"{count} rows of the store are stale: the scene, or shadercache, has changed since")
    done, old = store.keys(), store.stale_identities()
    condition = read_conditions(where, trials[0].words(trials[0].configurations[0]))
    return chosen(
        trials,
        lambda trial, one: (
            condition(trial.words(one))
            and (force or trial.key(one) not in done)
            and (not stale or trial.identity(one) in old)
        ),
    )


def _print_plan(trials: Sequence[SweepTrial], left: Sequence[SweepTrial], worker: Worker) -> None:
    from shadercache.sweep.estimate import plan_seconds

    originals: dict[object, float] = {}
    rows = []
    for file in dict.fromkeys(trial.file for trial in trials):
        of_scene = [trial for trial in trials if trial.file == file]
        to_do = [trial for trial in left if trial.file == file]
        entry = of_scene[0].scene
        frame = "not drawn"
        try:
            if to_do:
                originals[file] = worker.original_seconds(file, entry.size)
                frame = f"{originals[file] * 1e3:.1f} ms"
        except DiagnosticError as error:
            frame = error.diagnostics[0].code
        except Exception as error:  # the worker is lost; carrying out says so in rows
            frame = str(error)
        payloads = len({trial.payload.label for trial in of_scene})
        every = sum(len(trial.configurations) for trial in of_scene)
        now = sum(len(trial.configurations) for trial in to_do)
        rows.append((entry.name, str(payloads), str(every), str(now), frame))
    header = ("scene", "payloads", "configurations", "to do", "original")
    print(format_table(header, rows, right="payloads configurations do original"))
    minutes = plan_seconds(left, originals) / 60.0
    entry = trials[0].scene
    print(
        f"{entry.size[0]}x{entry.size[1]}, {entry.frames} frames; "
        f"about {max(1, round(minutes))} min"
    )


def _carried_out(trials: Sequence[SweepTrial], worker: Worker, store: Store) -> list[Row]:
    """Carry out what is left; returns the rows that are failures."""
    from shadercache.sweep.carry_out import carry_out

    failures: list[Row] = []
    count = sum(len(trial.configurations) for trial in trials)
    with progress("sweep", count) as advance:

        def heard(row: Row) -> None:
            advance(1)
            if row.failure is not None:
                failures.append(row)

        carry_out(trials, worker, store, heard)
    if trials:
        store.drop_unused()
    return failures


def _print_end(trials: Sequence[SweepTrial], failures: Sequence[Row], output: Path) -> None:
    count = sum(len(trial.configurations) for trial in trials)
    print(f"{count} rows written to {output}, {len(failures)} of them failures")
    for row in failures:
        failure = row.failure
        assert failure is not None and row.configuration is not None
        algorithm = row.configuration["algorithm"]
        where = f"{row.scene.name} {row.label} {algorithm}"
        print(f"  {where}: {failure.kind}: {failure.message} [{failure.code}]")
