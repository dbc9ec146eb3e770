"""What the names of attributes, uniforms and samplers commonly mean."""

from __future__ import annotations

import re
from collections.abc import Mapping

from shadercache.lang.types import Type
from shadercache.linking.made_scene import word_of

MATRICES: Mapping[str, str] = {
    **dict.fromkeys(("model", "world", "m", "object", "objecttoworld", "localtoworld"), "model"),
    **dict.fromkeys(("modeltoworld", "modeltransform", "worldtransform", "transform"), "model"),
    **dict.fromkeys(("view", "v", "camera", "worldtoview", "worldtocamera", "lookat"), "view"),
    **dict.fromkeys(("projection", "proj", "p", "perspective", "viewtoclip"), "projection"),
    **dict.fromkeys(("modelview", "mv", "worldview", "viewmodel"), "model-view"),
    **dict.fromkeys(
        ("viewprojection", "viewproj", "vp", "pv", "projectionview"), "view-projection"
    ),
    **dict.fromkeys(("projview", "worldtoclip"), "view-projection"),
    **dict.fromkeys(("modelviewprojection", "modelviewproj", "mvp"), "model-view-projection"),
    **dict.fromkeys(("worldviewprojection", "worldviewproj", "wvp"), "model-view-projection"),
    **dict.fromkeys(("projectionmodelview", "pvm", "objecttoclip"), "model-view-projection"),
}
"""Matrices by their names, without prefixes, case and the word matrix."""

EYES = re.compile(
    r"^(?:ws|world|worldspace)?(?:camera|cam|eye|view|viewer)(?:world)?(?:pos|position|location)?(?:ws|world)?$"
)

ROLES: Mapping[str, re.Pattern[str]] = {
    "normal": re.compile(r"normal|bump|nrm"),
    "roughness": re.compile(r"rough|metal|orm$|gloss|specular"),
    "occlusion": re.compile(r"occlu|^ao|ambient"),
    "emissive": re.compile(r"emiss|glow"),
    "albedo": re.compile(r"diffuse|albedo|colou?r|base|^map\d?$|^tex(?:ture)?\d?$|main|image|skin"),
}
"""The role of a texture by the name of its sampler, tried in this order."""

_ARRAYS: Mapping[str, re.Pattern[str]] = {
    "weights": re.compile(r"weight"),
    "joints": re.compile(r"joint|bone|skinind|blendind"),
    "bitangent": re.compile(r"bitan|binorm"),
    "tangent": re.compile(r"(?<!ins)tan"),
    "normal": re.compile(r"norm|nrm"),
    "uv1": re.compile(r"(?:uv|(?<!ver)tex.*|st)[1-9]$|lightmap"),
    "uv": re.compile(r"uv|(?<!ver)tex|^st$"),
    "color": re.compile(r"colou?r|^col$|tint"),
    "position": re.compile(r"pos|vert|coord|^p$|point"),
}
"""The array of an attribute by its name, tried in this order."""

_WIDTHS: Mapping[str, tuple[int, ...]] = {
    **{"position": (2, 3, 4), "normal": (3, 4), "tangent": (3, 4), "bitangent": (3,)},
    **{"uv": (2, 3, 4), "uv1": (2, 3, 4), "color": (3, 4), "joints": (4,), "weights": (4,)},
}
_MORPH = re.compile(r"(?:morph|target|blendshape|shape)\D*(\d*)", re.IGNORECASE)
_KNOWN_MATRIX = re.compile(r"(?:matrix|mat|mtx|transform)$")


def array_of_attribute(name: str, kind: Type) -> str | None:
    """The array of a model that an attribute is by its name; None for a name that says nothing."""
    word = plain(name)
    morph = _MORPH.search(name)
    if morph is not None:
        which = "normal" if "norm" in word else "position"
        return f"morph{int(morph[1] or 0)}_{which}"
    for array, pattern in _ARRAYS.items():
        if pattern.search(word) and kind.rows in _WIDTHS[array]:
            return array
    return None


def matrix_meaning(name: str, kind: Type) -> str | None:
    """The semantic of a matrix by its name."""
    word = _without_matrix(plain(name))
    inverse = _without_matrix(re.sub(r"^inv(?:erse)?|inv(?:erse)?$", "", word))
    if kind.cols == 3 and kind.rows == 3:
        return "normal-matrix" if "norm" in word or word == "n" else None
    if kind.cols != 4 or kind.rows != 4:
        return None
    if inverse != word and inverse in MATRICES:
        return f"inverse-{MATRICES[inverse]}"
    return MATRICES.get(word)


def _without_matrix(word: str) -> str:
    return _KNOWN_MATRIX.sub("", word) or word


def role_of(name: str) -> str | None:
    """What a sampler is for by its name."""
    word = plain(name)
    return next((role for role, pattern in ROLES.items() if pattern.search(word)), None)


def plain(name: str) -> str:
    """A name without prefix, case and underscores: ``position`` of ``a_Position``."""
    last = name.rpartition(".")[2]
    short = re.sub(r"^(?:gl_|(?:in|vs|attr|vertex)_|[a-z]_|[aiuv](?=[A-Z])|in(?=[A-Z]))", "", last)
    return word_of(short) or word_of(last)
