"""Results of experiments on disk: what was measured, where and when, and what follows from it."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import msgspec

from bench.papers.claims import CLAIMS, Verdict
from bench.papers.experiment import Experiment, Options
from bench.speed import ROOT
from shadercache import __version__
from shadercache.files import write_bytes
from shadercache.measure.result_files import plain, write_json

SCHEMA_VERSION = 1

_MEASURED = ("shadercache", "corpus", "grammars", "bench", ":(exclude)bench/results")
"""What results come from, in words of Git: not the results and the page themselves."""


@dataclass(frozen=True)
class Result:
    """One experiment as it was measured; ``about`` is what ``environment`` says."""

    experiment: Experiment[Any]
    options: Options
    about: Mapping[str, Any]
    seconds: float
    data: Any

    @cached_property
    def verdicts(self) -> tuple[Verdict, ...]:
        """By the rules as they are now."""
        return tuple(self.experiment.judge(self.data))

    @property
    def text(self) -> str:
        """Title, table and verdicts."""
        lines = [
            f"{self.experiment.name}: {self.experiment.title} ({self.seconds:.0f} s)",
            self.experiment.table(self.data),
            "",
        ]
        for verdict in self.verdicts:
            claim = CLAIMS[verdict.claim]
            lines += [
                f"{claim.id}, {claim.paper}, {claim.section}: {claim.sentence}",
                f"    {verdict.word}: {verdict.numbers}",
            ]
        return "\n".join(lines)


@cache
def version() -> str:
    """The commit, marked where programs or scenes differ from it; without Git the version."""
    try:
        commit = _git("rev-parse", "--short=12", "HEAD").strip()
        changed = _git("status", "--porcelain", "--untracked-files=no", "--", *_MEASURED)
    except (OSError, subprocess.CalledProcessError):
        return __version__
    return f"{commit}-dirty" if changed else commit


def _git(*arguments: str) -> str:
    command = ["git", "-C", str(ROOT), *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def _state(options: Options, about: Mapping[str, Any]) -> dict[str, Any]:
    """What a result has to agree in to stand: version, driver, size and thoroughness."""
    return {"version": version(), "gl": about["gl"], "options": plain(options)}


def store(path: Path, result: Result) -> None:
    """Write a result as JSON, and its plots beside it.

    Raises :class:`UsageError` SC025: a path cannot be written.
    """
    state = _state(result.options, result.about)
    written = {
        "schema_version": SCHEMA_VERSION,
        "experiment": result.experiment.name,
        **state,
        "environment": dict(result.about),
        "seconds": round(result.seconds, 1),
        "verdicts": plain(result.verdicts),
        "data": plain(result.data),
    }
    for name, image in result.experiment.draw(result.data).items():
        write_bytes(path.parent / f"{name}.png", image)
    # Last, for a result stands by its JSON: what was interrupted is measured again.
    write_json(path, written)


def stands(path: Path, options: Options, about: Mapping[str, Any]) -> bool:
    """Is there a result of the same version, driver, size and thoroughness?"""
    found = _read(path)
    return found is not None and _state(options, about).items() <= found.items()


def load(path: Path, experiment: Experiment[Any]) -> Result | None:
    """A stored result; None where there is none that can be read as this experiment's."""
    found = _read(path)
    if found is None:
        return None
    try:
        data = msgspec.convert(found["data"], experiment.kind)
        options = msgspec.convert(found["options"], Options)
    except (KeyError, msgspec.ValidationError):
        return None  # of another version: it has to be measured again
    return Result(experiment, options, found["environment"], found["seconds"], data)


def _read(path: Path) -> dict[str, Any] | None:
    try:
        found = json.loads(path.read_bytes())
    except (OSError, ValueError):
        return None
    known = isinstance(found, dict) and found.get("schema_version") == SCHEMA_VERSION
    return found if known else None
