"""What determines a trial, as short hashes: the content of every file that a scene is made of."""

from __future__ import annotations

import json
from collections.abc import Iterator
from hashlib import sha256
from pathlib import Path
from typing import Any

from shadercache import __version__
from shadercache.linking.linker import Linker
from shadercache.scene.description import SceneObject
from shadercache.scene.models.load import is_model, load_model
from shadercache.scene.object_inputs import Rows


def short_hash(value: Any) -> str:
    """A name for a value that can be written as JSON: equal values have equal names."""
    text = json.dumps(value, sort_keys=True, separators=(",", ":"))
    return sha256(text.encode()).hexdigest()[:32]


def scene_fingerprint(linker: Linker) -> str:
    """A name for all that a scene is drawn from: its file, shaders, meshes, textures, animations.

    Shaders count as they stand and as they are printed, with includes and macros expanded.
    """
    shaders = [sorted(bundle.files.items()) for bundle in linker.originals()]
    files = sorted({path for part in linker.scene.parts for path in _files(part)})
    # A full-screen shader has no scene file: the path is the shader's, which is counted anyway.
    own = [linker.scene.path] if linker.scene.path.suffix == ".toml" else []
    if linker.scene.recording is not None:
        own.append(linker.scene.recording.path)
    contents = [_content(path) for path in (*own, *files)]
    text = linker.analysis.fragment.text
    return short_hash([__version__, linker.analysis.mapping, text, shaders, contents])


def _files(part: SceneObject) -> Iterator[Path]:
    """The files of an object beside its shaders."""
    if part.mesh is not None:
        yield from load_model(part.mesh).files if is_model(part.mesh) else (part.mesh,)
    for texture in part.inputs.textures.values():
        if not texture.generated:
            yield texture.path
    for animation in part.inputs.animated.values():
        if isinstance(animation, Rows):
            yield animation.path


def _content(path: Path) -> str:
    try:
        return sha256(path.read_bytes()).hexdigest()
    except OSError:  # told where the scene is drawn
        return "missing"
