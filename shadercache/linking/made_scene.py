"""A scene for a shader that has none: a triangle over the whole picture, inputs by name and type.

What the host of a Shadertoy gives, and what others commonly call the same, is recognised by name
(``iTime``, ``u_time``, ``time``): see :data:`SEMANTIC` and :data:`CONSTANT`. Every other uniform
has a value by its type: 0.5 for a number, 0.8, 0.6, 0.4 and 1.0 for the components of a vector, the
unit matrix, 1 for an integer, ``true``. A sampler gets a generated texture. A uniform with an
initialiser keeps that. The attributes of a vertex shader are the triangle's corners, or texture
coordinates or a normal if they are called so.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path

from shadercache.compiler import Analysis
from shadercache.lang.types import Type
from shadercache.linking.inputs_declared import inputs_declared
from shadercache.scene.description import Scene, SceneObject, View
from shadercache.scene.object_inputs import Inputs, TextureSpec

START = 4.0
"""Seconds that the clock shows in frame 0: at zero many a shader is still dark."""

SEMANTIC: Mapping[str, str] = {
    "time": "time",
    "globaltime": "time",
    "timedelta": "time-delta",
    "deltatime": "time-delta",
    "frame": "frame",
    "resolution": "resolution",
    "viewport": "resolution",
    "screensize": "resolution",
}
"""Names without prefix and case, and what they are tied to."""

CONSTANT: Mapping[str, tuple[float, ...]] = {
    "mouse": (0.0,) * 4,
    "date": (2008.0, 3.0, 15.0, 43_200.0),
    "framerate": (60.0,),
    "samplerate": (44_100.0,),
    "channeltime": (START,) * 4,
    # The size of generated textures, and the shape of their pixels.
    "channelresolution": (64.0, 64.0, 1.0) * 4,
}
"""The same for what does not change; a shorter uniform takes the first numbers."""

MADE_TEXTURES = {
    **{"sampler2D": "pixels", "samplerCube": "faces", "sampler2DArray": "layers"},
    **{"sampler3D": "volume", "isampler2D": "integers", "usampler2D": "naturals"},
}
"""The samplers there are textures for, and what those hold (:func:`textures.made_pixels`)."""

_VECTOR = (0.8, 0.6, 0.4, 1.0)
# `iTime` and `uTime` lose their first letter, `intensity` keeps it.
_PREFIX = re.compile(r"(?:[ug]_|[iu](?=[A-Z]))")


def made_scene(fragment: Path, analysis: Analysis, vertex: Path | None = None) -> Scene:
    """The scene of a full-screen shader, with the vertex shader it was analysed with, if any."""
    constants: dict[str, tuple[float, ...]] = {}
    semantics: dict[str, str] = {}
    textures: dict[str, TextureSpec] = {}
    old = {new: name for name, new in analysis.renamed.items()}
    for name, kind in inputs_declared(analysis.raised, "uniform", old):
        word = word_of(name)
        texture = MADE_TEXTURES.get(kind.name)
        if texture is not None:
            textures[name] = TextureSpec(Path(texture), "linear", True, "repeat", 1.0, True)
        elif word in SEMANTIC and _fits(SEMANTIC[word], kind):
            wide = SEMANTIC[word] == "resolution" and kind.components == 3
            semantics[name] = "resolution-aspect" if wide else SEMANTIC[word]
        else:
            constants |= constants_of(name, word, kind)
    attributes = {name: _array(name) for name, _ in inputs_declared(analysis.raised[1:], "in", old)}
    inputs = Inputs(attributes, constants, semantics, textures=textures)
    return Scene(
        path=fragment,
        name=fragment.stem,
        title=fragment.stem,
        common=SceneObject(fragment.stem, fragment, vertex, inputs=inputs),
        view=View(start_time=START),
        changes=inputs.causes,
        mapping=analysis.mapping,
    )


def word_of(name: str) -> str:
    """What a name says, without prefix and case: ``time`` of ``u_time`` or ``a.uTime``."""
    return _PREFIX.sub("", name.rpartition(".")[2], count=1).replace("_", "").lower()


def _array(attribute: str) -> str:
    """The array of the triangle that an attribute is, by its name."""
    word = attribute.lower()
    if "uv" in word or "tex" in word:
        return "uv"
    return "normal" if "normal" in word else "position"


def _fits(semantic: str, kind: Type) -> bool:
    wanted = (2, 3) if semantic == "resolution" else (1,)
    return not kind.is_array and kind.struct is None and kind.components in wanted


def constants_of(name: str, word: str, kind: Type) -> dict[str, tuple[float, ...]]:
    """The values of a uniform of any type, by the names that GL has for its parts."""
    if kind.struct is not None and not kind.is_array:
        return {
            part: values
            for field, inner in kind.struct.fields.items()
            for part, values in constants_of(f"{name}.{field}", "", inner).items()
        }
    if kind.is_array:
        count = kind.dims[0] or 1
        if kind.element.struct is not None or kind.element.is_array:
            return {
                part: values
                for at in range(count)
                for part, values in constants_of(f"{name}[{at}]", "", kind.element).items()
            }
        by_type = _by_type(kind.element) * count
        known = CONSTANT.get(word, ())
        # Too many numbers do no harm: `Uniform.encode` takes those that the driver kept.
        return {name: known if len(known) >= len(by_type) else by_type}
    known = CONSTANT.get(word, ())
    wanted = kind.components or 0
    return {name: known[:wanted] if len(known) >= wanted > 0 else _by_type(kind)}


def _by_type(kind: Type) -> tuple[float, ...]:
    count = kind.components or 1
    if kind.base != "float":
        return (1.0,) * count
    if kind.is_matrix:
        # Column by column, which is the order of upload.
        rows = count // kind.cols
        return tuple(float(at // rows == at % rows) for at in range(count))
    return (0.5,) if count == 1 else _VECTOR[:count]
