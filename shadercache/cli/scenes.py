"""Finding the scene that a command is about, and the nodes that are meant in it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from shadercache.caching.configuration import Configuration
from shadercache.caching.settings import with_settings
from shadercache.diagnostics import usage_error
from shadercache.paths import data_path

if TYPE_CHECKING:
    from shadercache.analysis.candidates import Candidate
    from shadercache.compiler import Analysis
    from shadercache.scene.description import Scene

SCENE_FILE = "scene.toml"


def find_scene(target: str) -> Path:
    """The scene file meant by ``target``.

    That is a scene file, its folder, a fragment shader with a scene file of its own beside it, or
    the name of a scene that comes with shadercache. A fragment shader without a scene stands for
    itself, since it may be a full-screen shader. Raises :class:`UsageError` SC006 if there is none.
    """
    path = Path(target)
    if path.is_dir():
        path = path / SCENE_FILE
    elif path.suffix != ".toml" and path.is_file():
        beside = path.with_name(SCENE_FILE)
        return beside if beside.is_file() and _names(beside, path) else path
    elif not path.exists() and path.name == target and not path.suffix:
        path = data_path("corpus", target, SCENE_FILE)
    if path.is_file():
        return path
    known = ", ".join(sorted(path.parent.name for path in data_path("corpus").glob("*/*.toml")))
    hint = f"give a scene file, its folder, a shader beside a {SCENE_FILE}, or one of: {known}"
    raise usage_error("SC006", f"no scene is meant by '{target}'", hint)


def _names(scene: Path, fragment: Path) -> bool:
    """Is it the scene of this fragment shader?"""
    from shadercache.scene.description import load_scene

    return load_scene(scene).common.fragment.samefile(fragment)


def choose_nodes(
    scene: Scene, analysis: Analysis, wanted: Sequence[str]
) -> list[tuple[str, tuple[Candidate, ...]]]:
    """Label and nodes for each wanted id, or name from the scene's ``[nodes]``.

    One of the wanted is a node, or a set of nodes that are cached together: ``a+b``. Raises
    :class:`UsageError` SC010 or SC011 for a node that does not exist.
    """
    return [
        (item, analysis.nodes_of("+".join(scene.nodes.get(part, part) for part in item.split("+"))))
        for item in wanted
    ]


def configured(
    scene: Scene, configuration: Configuration, settings: Sequence[str] | None
) -> Configuration:
    """A configuration with the settings of ``--cache``. Raises :class:`UsageError` SC028.

    Objects that share a cache are told apart by their numbers, unless ``ids=off`` is said.
    """
    several = ["ids=on"] if sum(thing.caching.on for thing in scene.objects) > 1 else []
    return with_settings(configuration, [*several, *(settings or ())])
