"""The names of a recording, against what the shaders of a scene declare."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from difflib import get_close_matches

from shadercache.compiler import Analysis
from shadercache.diagnostics import Diagnostic, InputError
from shadercache.linking.inputs_declared import uniform_sizes
from shadercache.scene.recorded_files import RecordedName
from shadercache.scene.recording import Recording

_MOST_TOLD = 20


def check_recorded(recording: Recording, shaders: Mapping[str, Analysis]) -> None:
    """Is each name a uniform that takes so many numbers?

    Args:
        shaders: of each object, by its name.

    Raises:
        InputError: SC551 for a name that is none, SC523 for another number of numbers.
    """
    # Objects that share a shader share its analysis.
    each = {id(analysis): uniform_sizes(analysis) for analysis in shaders.values()}
    problems: list[Diagnostic] = []
    for key in recording.file.values:
        own = None if key.object is None else each[id(shaders[key.object])]
        problems += _problems(recording, key, [*each.values()] if own is None else [own])
    if problems:
        raise InputError(problems[:_MOST_TOLD])


def _problems(
    recording: Recording, key: RecordedName, shaders: list[dict[str, int | None]]
) -> Iterator[Diagnostic]:
    """What is wrong with a name in the shaders that might have it."""
    file, given = recording.file, recording.file.values[key].shape[1]
    having = [sizes[key.name] for sizes in shaders if key.name in sizes]
    if not having:
        names = sorted({name for sizes in shaders for name in sizes})
        near = get_close_matches(key.name, names, 1)
        meant = f"did you mean {near[0]}? " if near else ""
        owner = "the scene's shaders have" if key.object is None else "its shaders have"
        message = f"{key}: {owner} no uniform {key.name} that takes numbers"
        yield file.problem("SC551", key, message, f"{meant}there are: {', '.join(names)}")
        return
    wrong = next((size for size in having if size not in (None, given)), None)
    if wrong is not None:
        message = f"{key} takes {wrong} numbers, and the recording has {given}"
        yield file.problem("SC523", key, message, None)
