"""Finding the scene that a command is about, and the nodes that are meant in it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, NamedTuple

from shadercache.analysis.mapping import MappingKind
from shadercache.diagnostics import Diagnostic, Severity, usage_error
from shadercache.front.read_options import ReadOptions
from shadercache.paths import data_path

if TYPE_CHECKING:
    from typer import Context

    from shadercache.analysis.candidates import Candidate
    from shadercache.compiler import Analysis
    from shadercache.scene.description import Scene
    from shadercache.scene.recording import Recording

SCENE_FILE = "scene.toml"


class Payload(NamedTuple):
    """Nodes that are cached together, and for how many of the same value they stand."""

    label: str
    nodes: tuple[Candidate, ...]
    equal: int = 1

    @property
    def ids(self) -> tuple[str, ...]:
        """What names them."""
        return tuple(node.id for node in self.nodes)


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
        from shadercache.scene.description import load_scene

        beside = path.with_name(SCENE_FILE)
        own = beside.is_file() and load_scene(beside).common.fragment.samefile(path)
        return beside if own else path
    elif not path.exists() and path.name == target and not path.suffix:
        # Only a bare word is the name of a scene of ours; a path that is not there is a mistake.
        path = data_path("corpus", target, SCENE_FILE)
    if path.is_file():
        return path
    known = ", ".join(sorted(path.parent.name for path in data_path("corpus").glob("*/*.toml")))
    hint = f"give a scene file, its folder, a shader beside a {SCENE_FILE}, or one of: {known}"
    raise usage_error("SC006", f"no scene is meant by '{target}'", hint)


class OpenedTarget(NamedTuple):
    """What a command draws, and how other processes open the same.

    ``path``: a scene file, or a full-screen shader with its ``mapping`` and ``vertex`` shader.
    """

    scene: Scene
    analysis: Analysis
    path: Path
    mapping: MappingKind | None
    vertex: Path | None = None

    def played(self, reading: ReadOptions, recording: Recording) -> OpenedTarget:
        """The same with a recording laid over it. Raises as ``open_scene``."""
        from shadercache.linking.scene_shaders import open_scene

        again = open_scene(self.path, reading, self.mapping, recording, self.vertex)
        return OpenedTarget(*again, self.path, self.mapping, self.vertex)


def open_target(
    context: Context,
    target: str,
    vertex: Path | None,
    reading: ReadOptions,
    mapping: MappingKind | None,
) -> OpenedTarget:
    """The scene that a command is about; a shader without one may be shown by a made object.

    That lies in a folder which is there until the command ends. Of what was guessed the user is
    told. Raises as :func:`find_scene`, ``open_scene`` and ``open_shader``, and :class:`UsageError`
    SC008 for a vertex shader beside a scene.
    """
    from shadercache.linking.made_object import open_shader
    from shadercache.linking.scene_shaders import open_scene

    path = find_scene(target)
    if path.suffix == ".toml":
        if vertex is not None:
            raise usage_error("SC008", f"--vert: the scene {path} names its vertex shader itself")
        return OpenedTarget(*open_scene(path, reading, mapping), path, mapping)
    folder = context.with_resource(TemporaryDirectory(prefix="shadercache-"))
    scene, analysis, notes = open_shader(path, vertex, reading, mapping, Path(folder))
    if notes:
        message = f"{path} has no scene, and what it needs is guessed: {'; '.join(notes)}"
        hint = "'shadercache scene' writes a scene file for your own model, to be corrected"
        context.obj.show([Diagnostic("SC040", message, None, None, hint, Severity.NOTE)])
    vertex = scene.common.vertex if scene.path == path else None
    # Nobody who opens it again looks at how the vertices are moved.
    return OpenedTarget(scene, analysis, scene.path, "screen" if vertex else mapping, vertex)


def choose_nodes(scene: Scene, analysis: Analysis, wanted: Sequence[str]) -> list[Payload]:
    """The payload for each that is wanted: by a name from the scene's ``[nodes]``, an id, a text or
    a place (see :mod:`analysis.naming`).

    One of the wanted is a node, or a set of nodes that are cached together: ``a+b``. Raises
    :class:`UsageError` SC010 to SC012 for what is not the name of one node.
    """
    return [Payload(label, analysis.nodes_of(label, scene.nodes)) for label in wanted]


def choose_set(scene: Scene, analysis: Analysis, wanted: Sequence[str]) -> Payload:
    """One payload of all that is wanted. Raises as :func:`choose_nodes`."""
    payloads = choose_nodes(scene, analysis, wanted)
    nodes = tuple(node for payload in payloads for node in payload.nodes)
    return Payload("+".join(wanted), nodes)


def one_by_one(analysis: Analysis, nodes: Sequence[Candidate], every_node: bool) -> list[Payload]:
    """Each node by itself; unless it is ``every_node``, one stands for all of the same value."""
    from shadercache.analysis.value_numbering import one_of_each

    counts = dict.fromkeys(nodes, 1) if every_node else one_of_each(nodes, analysis.groups)
    return [Payload(node.id, (node,), count) for node, count in counts.items()]
