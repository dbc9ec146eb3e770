"""The scene's own shaders with one function written anew: fewer octaves of noise, fewer samples.

A file ``fewer/SHADER.FUNCTION.glsl`` has the text that takes the place of the function in
``SHADER.frag``. The rest stays what the corpus has.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

from shadercache.ast import nodes as n
from shadercache.front.parse import parse
from shadercache.linking.linker import Linker
from shadercache.linking.scene_shaders import analyse_scene, read_shader
from shadercache.measure.subjects import OriginalSubject
from shadercache.scene.description import Scene
from shadercache.source import Source

FOLDER = Path(__file__).parent / "fewer"

LABELS: Mapping[str, str] = {
    "dragon": "2 of 5 octaves",
    "trashcan": "9 of 25 samples",
    "heroine": "2 octaves of 4 and 5",
    "colonnade": "2 of 5 octaves",
}
"""What is left, by the name of the scene."""


def fewer_samples(scene: Scene) -> OriginalSubject | None:
    """The scene drawn by its cheaper shaders; None for a scene that has none here."""
    if scene.name not in LABELS:
        return None
    with TemporaryDirectory() as folder:
        paths = {
            part.fragment: _cheaper(part.fragment, Path(folder))
            for part in (scene.common, *scene.objects)
        }
        common, *objects = (
            replace(part, fragment=paths[part.fragment]) for part in (scene.common, *scene.objects)
        )
        linker = Linker(*analyse_scene(replace(scene, common=common, objects=tuple(objects))))
        return OriginalSubject(LABELS[scene.name], *linker.originals())


def _cheaper(fragment: Path, folder: Path) -> Path:
    """Where the shader is that takes the place of another; that one itself, if there is none."""
    source = cheaper_shader(read_shader(fragment))
    if source is None:
        return fragment
    path = folder / fragment.name
    path.write_text(source.text, encoding="utf-8")
    return path


def cheaper_shader(source: Source) -> Source | None:
    """The shader with its functions replaced by those that are here; None where none is.

    Raises:
        ValueError: there is a text for a function that the shader does not have.
    """
    texts = {
        path.name.split(".")[1]: path.read_text(encoding="utf-8")
        for path in FOLDER.glob(f"{Path(source.name).stem}.*.glsl")
    }
    if not texts:
        return None
    spans = {
        decl.name: decl.span
        for decl in parse(source).decls
        if isinstance(decl, n.FunctionDef) and decl.name in texts
    }
    if missing := texts.keys() - spans.keys():
        raise ValueError(f"{source.name} has no function {', '.join(sorted(missing))}")
    text = source.text
    # From the end, so that the spans before it stay right.
    for name in sorted(spans, key=lambda name: -spans[name].start):
        text = text[: spans[name].start] + texts[name] + text[spans[name].end :]
    return Source(source.name, text)
