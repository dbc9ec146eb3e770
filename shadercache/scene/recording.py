"""What an engine had for uniforms, frame by frame, laid over a scene."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches
from pathlib import Path

from shadercache.diagnostics import Diagnostic, InputError, input_error
from shadercache.scene.object_inputs import Track, with_aliases
from shadercache.scene.recorded_files import RecordedFile, RecordedName, from_csv, from_toml
from shadercache.scene.toml_reader import read_described

MAX_RECORDING = 64 << 20
"""Bytes of a recording."""

_READERS = {".csv": from_csv, ".toml": from_toml}

_MATRICES = (9, 16)


@dataclass(frozen=True, eq=False)
class Recording:
    """The values of uniforms in every frame; matrices column by column, as OpenGL uploads them.

    ``cuts``: the frames in which the camera jumps. ``file`` tells where each name stands.
    """

    path: Path
    tracks: Mapping[RecordedName, Track]
    cuts: frozenset[int]
    file: RecordedFile

    @property
    def frames(self) -> int:
        """How many frames it has, two at least."""
        return min(len(track.rows) for track in self.tracks.values())

    def of(self, name: str | None) -> dict[str, Track]:
        """The tracks of an object by its name; None for those of all objects."""
        return {key.name: track for key, track in self.tracks.items() if key.object == name}

    def with_aliases(self, renamed: Mapping[str, str]) -> Recording:
        """The same, with everything also under its new name."""
        tracks = {
            RecordedName(owner, name): track
            for owner in {key.object for key in self.tracks}
            for name, track in with_aliases(self.of(owner), renamed).items()
        }
        return replace(self, tracks=tracks)


def read_recording(path: Path) -> Recording:
    """Read a ``.csv`` or ``.toml`` file of what an engine had.

    Raises:
        InputError: SC501 for a file that cannot be read or is neither; SC502, SC504, SC505 for
            TOML, SC550 for numbers that are not the same in every frame, not finite, or missing.
    """
    reader = _READERS.get(path.suffix.lower())
    if reader is None:
        message = f"the recording {path} is neither a .csv nor a .toml file"
        raise input_error("SC501", message)
    file = reader(read_described(path, "recording", MAX_RECORDING))
    for rows in file.values.values():
        rows.flags.writeable = False
    tracks = {key: Track(rows) for key, rows in file.values.items()}
    return Recording(path, tracks, file.cuts, file)


def causes_of(recording: Recording) -> dict[str, str]:
    """Why what the scene says nothing of may change: matrices do with the view."""
    return {
        key.name: "view" if track.rows.shape[1] in _MATRICES else "time"
        for key, track in recording.tracks.items()
        if track.moves
    }


def check_objects(recording: Recording, scene: str, objects: Sequence[str]) -> None:
    """Raise :class:`InputError` SC551 for objects that a scene of that name does not have."""
    known = list(objects)
    problems: list[Diagnostic] = []
    for key in recording.tracks:
        if key.object is None or key.object in known:
            continue
        near = get_close_matches(key.object, known, 1)
        meant = f"did you mean {near[0]}? " if near else ""
        message = f"{key}: the scene {scene} has no object {key.object!r}"
        hint = f"{meant}it has: {', '.join(known)}"
        problems.append(recording.file.problem("SC551", key, message, hint))
        known.append(key.object)  # told once
    if problems:
        raise InputError(problems)
