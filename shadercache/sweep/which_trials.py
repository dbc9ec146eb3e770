"""``--where``: which trials are meant, by the words of their choices."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace

from shadercache.caching.configuration import Configuration
from shadercache.diagnostics import usage_error
from shadercache.sweep.plan import SweepTrial
from shadercache.sweep.row import Machine

Condition = Callable[[Mapping[str, str]], bool]


def read_conditions(texts: Sequence[str], known: Mapping[str, str]) -> Condition:
    """What holds for a trial's words if all of the texts do: ``KEY=VALUE,VALUE...``, one of them.

    Args:
        known: the words of any trial; its keys are those that can be asked about.

    Raises :class:`UsageError` SC008 for a text of another form, or an unknown key.
    """
    wanted: list[tuple[str, frozenset[str]]] = []
    for text in texts:
        key, equals, values = text.partition("=")
        if key not in known or not equals:
            hint = f"give KEY=VALUE,... with one of {', '.join(known)}"
            raise usage_error("SC008", f"'{text}' is no value for --where", hint)
        wanted.append((key, frozenset(values.split(","))))
    return lambda words: all(words[key] in values for key, values in wanted)


def chosen(
    trials: Sequence[SweepTrial], wanted: Callable[[SweepTrial, Configuration], bool]
) -> list[SweepTrial]:
    """The trials with the configurations that are wanted; those without any are left out."""
    cut = [trial.only(wanted) for trial in trials]
    return [trial for trial in cut if trial.configurations]


def on_each(trials: Iterable[SweepTrial], machines: Iterable[Machine]) -> list[SweepTrial]:
    """The trials as they are on each of the machines, which may be alike."""
    kinds = list(dict.fromkeys(machines))
    return [replace(trial, machine=machine) for machine in kinds for trial in trials]
