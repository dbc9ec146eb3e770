"""What each input of a shader pair is given, and why."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import cos, sin, sqrt

from shadercache.diagnostics import Diagnostic, InputError, input_error
from shadercache.lang.types import Type
from shadercache.linking.first_scene.framing import Frame
from shadercache.linking.first_scene.meanings import (
    EYES,
    array_of_attribute,
    matrix_meaning,
    plain,
    role_of,
)
from shadercache.linking.first_scene.shader_inputs import ShaderInputs, Wanted
from shadercache.linking.made_scene import MADE_TEXTURES, SEMANTIC, constants_of
from shadercache.scene.models.parts import Material, Model

_COLOR = re.compile(r"(?:base|diffuse|albedo|material|kd)?(?:colou?r|factor|albedo|diffuse|kd)")
_VIEWS = {"view", "model-view", "view-projection", "model-view-projection"}
_APART = 1.3
"""Radians between two lights, seen from above."""
_AWAY = sqrt(2.0 * 2.0 + 3.0 * 3.0 + 2.5 * 2.5)
UNKNOWN = "its meaning is not known; this is a stand-in"


@dataclass(frozen=True, slots=True)
class Guess:
    """A key with its value as TOML writes it. ``sure``: the name and the type say it."""

    name: str
    value: str
    why: str
    sure: bool = True


def attributes_of(wanted: Sequence[Wanted], model: Model) -> list[Guess]:
    """An array of the model for each attribute.

    Raises:
        InputError: SC521 for each attribute that nothing of the model fits.
    """
    arrays = model.parts[0].arrays
    first = min((_number(item.name) for item in wanted if _is_morph(item)), default=0)
    guesses: list[Guess] = []
    problems: list[Diagnostic] = []
    taken: set[str] = set()
    for item in wanted:
        named = array_of_attribute(item.name, item.type)
        if named is not None and _is_morph(item) and first == 1:
            named = re.sub(r"\d+", lambda digits: str(int(digits[0]) - 1), named)
        array = named or _by_type(item.type, taken, set(arrays))
        if array is None or array not in arrays:
            problems += _no_match(item, named, model).diagnostics
            continue
        taken.add(array)
        why = item.spelt if named else f"{item.spelt}; its name says nothing, and its type fits"
        lacking = [part.name for part in model.parts if array in part.computed]
        if lacking:
            why += f"; computed, or filled in, for {_listed(lacking)}"
        guesses.append(Guess(item.name, f'"{array}"', why, bool(named) and not lacking))
    if problems:
        raise InputError(problems)
    return guesses


def uniforms_of(inputs: ShaderInputs, model: Model, frame: Frame) -> list[Guess]:
    """A value for each uniform, those of the first part's material where it has one."""
    guesses = [_uniform(item, model, frame) for item in inputs.uniforms]
    flat = [guess for group in guesses for guess in group]
    return list(_with_lone_matrix(flat, inputs))


def material_values(inputs: ShaderInputs, material: Material) -> dict[str, str]:
    """The uniforms that a material has a value for."""
    found = {item.name: _of_material(item, material) for item in inputs.uniforms}
    return {name: value for name, value in found.items() if value is not None}


def sampler_roles(samplers: Sequence[Wanted]) -> dict[str, str | None]:
    """What each sampler is for, one of ``parts.ROLES``.

    Raises:
        InputError: SC524 for a sampler that the harness cannot give a texture.
    """
    for item in samplers:
        if item.type.name not in MADE_TEXTURES:
            given = "2D and 3D textures, cube maps and arrays of 2D textures only"
            what = f"{item.name} ({item.spelt}) is none"
            raise input_error("SC524", f"the harness gives {given}, {what}")
    roles = {item.name: role_of(item.name) for item in samplers if item.type.name == "sampler2D"}
    if len(roles) == 1:
        # Whatever its name, the only texture is most likely the colour.
        return {name: role or "albedo" for name, role in roles.items()}
    return roles


def numbers(values: Sequence[float]) -> str:
    """Numbers as TOML writes them: one alone, or several in brackets."""
    texts = [_number_text(value) for value in values]
    return texts[0] if len(texts) == 1 else f"[{', '.join(texts)}]"


def _number_text(value: float) -> str:
    text = f"{value:.6g}"
    return text if any(sign in text for sign in ".en") else f"{text}.0"


def _is_morph(item: Wanted) -> bool:
    return (array_of_attribute(item.name, item.type) or "").startswith("morph")


def _number(name: str) -> int:
    digits = re.findall(r"\d+", name)
    return int(digits[-1]) if digits else 0


def _by_type(kind: Type, taken: set[str], there: set[str]) -> str | None:
    """The first array left over that such an attribute commonly is."""
    wanted = {
        1: ("uv", "uv1", "color", "position"),
        2: ("uv", "uv1"),
        3: ("position", "normal"),
        4: ("position", "tangent"),
    }
    candidates = wanted.get(kind.rows, ()) if kind.is_float and not kind.is_matrix else ()
    return next((name for name in candidates if name in there and name not in taken), None)


def _no_match(item: Wanted, array: str | None, model: Model) -> InputError:
    widths = {1: "float", 2: "vec2", 3: "vec3", 4: "vec4"}
    arrays = {**model.parts[0].arrays}
    have = ", ".join(f"{name} ({widths[arrays[name].shape[1]]})" for name in arrays)
    looked = f", which looks like {array}," if array else ""
    message = f"nothing in {model.path} fits the attribute {item.name} ({item.spelt}){looked}"
    return input_error("SC521", message.rstrip(","), f"the model has: {have}")


def _listed(names: list[str]) -> str:
    shown = ", ".join(names[:3])
    return shown if len(names) <= 3 else f"{shown} and {len(names) - 3} more"


def _uniform(item: Wanted, model: Model, frame: Frame) -> list[Guess]:
    word, kind = plain(item.name), item.type
    if kind.struct is not None:
        return [
            guess
            for part, values in constants_of(item.name, word, kind).items()
            for guess in [_member(part, values, frame)]
        ]
    known = _known(item, word, model, frame) or _lights(kind, word, frame)
    if known is not None:
        return [Guess(item.name, known[0], f"{item.spelt}{known[1]}", not known[1])]
    return [
        Guess(name, numbers(values), f"{item.spelt}: {UNKNOWN}", False)
        for name, values in constants_of(item.name, word, kind).items()
    ]


def _member(name: str, values: tuple[float, ...], frame: Frame) -> Guess:
    """A part of a struct, of which only the number of components is told."""
    word, root = plain(name), plain(name.partition(".")[0])
    at = re.search(r"\[(\d+)\]", name)
    if len(values) == 3:
        light = _light(word, root, frame, int(at[1]) if at else 0)
        if light is not None:
            return Guess(name, light[0], f"vec3{light[1]}", False)
    known = _number_of(word, frame) if len(values) == 1 else None
    if known is not None:
        return Guess(name, known[0], f"one number{known[1]}", False)
    return Guess(name, numbers(values), UNKNOWN, False)


def _known(item: Wanted, word: str, model: Model, frame: Frame) -> tuple[str, str] | None:
    """A value, and what was guessed about it; no remark where name and type say it."""
    kind = item.type
    if (kind.element if kind.is_array else kind).is_matrix:
        return _matrix(item, word, model)
    if kind.is_array:
        weights = re.search(r"morph|influence|weight|blend", word)
        if weights and kind.element.is_float and kind.element.is_scalar:
            return '"morph-weights"', ""
        return None
    if word in SEMANTIC and SEMANTIC[word] != "resolution" and kind.is_scalar:
        return f'"{SEMANTIC[word]}"', ""
    if SEMANTIC.get(word) == "resolution" and kind.rows in (2, 3):
        return ('"resolution"' if kind.rows == 2 else '"resolution-aspect"'), ""
    if not kind.is_float:
        return None
    color = _of_material(item, model.parts[0].material)
    if color is not None:
        return color, " of the material"
    if kind.rows == 3:
        return ('"eye"', "") if EYES.match(word) else _light(word, "", frame)
    if kind.rows == 4 and re.search(r"colou?r|albedo|diffuse|tint", word):
        return "[0.8, 0.8, 0.8, 1.0]", ": a light grey (guess)"
    return _number_of(word, frame) if kind.is_scalar else None


def _matrix(item: Wanted, word: str, model: Model) -> tuple[str, str] | None:
    kind = item.type
    if kind.is_array:
        square = kind.rows == kind.cols == 4
        if not square or re.search(r"bone|joint|skin|palette|matri", word) is None:
            return None
        _check_bones(item, model)
        return '"bones"', "" if model.skeleton.skins else ": the model has no bones (unit)"
    meaning = matrix_meaning(item.name, kind)
    return None if meaning is None else (f'"{meaning}"', "")


def _check_bones(item: Wanted, model: Model) -> None:
    most = max((len(skin.joints) for skin in model.skeleton.skins), default=0)
    size = item.type.dims[0]
    if size is not None and size < most:
        message = f"{item.name} has {size} matrices, and a skin of {model.path} has {most} bones"
        raise input_error("SC523", message, f"declare mat4 {item.name}[{most}]")


def _lights(kind: Type, word: str, frame: Frame) -> tuple[str, str] | None:
    """The same for an array of them, each in another direction."""
    if len(kind.dims) != 1 or kind.is_unsized or not kind.element.is_float or kind.rows != 3:
        return None
    each = [_light(word, "", frame, number) for number in range(kind.dims[0] or 1)]
    known = [light for light in each if light is not None]
    return (f"[{', '.join(value for value, _ in known)}]", known[0][1]) if known else None


def _light(word: str, around: str, frame: Frame, number: int = 0) -> tuple[str, str] | None:
    """Where a light is, where it comes from, or its colour; ``around``: what it is a member of."""
    turn = number * _APART
    # Each further one stands elsewhere about the upright axis.
    x, z = (2.0 * cos(turn) - 2.5 * sin(turn), 2.0 * sin(turn) + 2.5 * cos(turn))
    away = frame.upright(x, 3.0, z)
    # Near enough for lights whose strength falls with the square of the distance.
    near = 0.5 * frame.radius
    place = [at + near * step for at, step in zip(frame.centre, away, strict=True)]
    towards = [round(step / _AWAY, 3) for step in away]
    if re.search(r"light|sun|lamp|key", word + around):
        if re.search(r"colou?r|intensity|radiance|diffuse|specular|power", word):
            return "[1.0, 1.0, 1.0]", ": white light (guess)"
        if re.search(r"ambient", word):
            return "[0.1, 0.1, 0.1]", ": dim light (guess)"
        if "pos" in word:
            return numbers(place), ": a light above the model, in the world (guess)"
        if around and word == "direction":
            return numbers([-step for step in towards]), ": from the light, unit length (guess)"
        return numbers(towards), ": towards the light, unit length (guess)"
    if re.search(r"ambient", word):
        return "[0.1, 0.1, 0.1]", ": dim light (guess)"
    if re.search(r"colou?r|albedo|diffuse|tint", word):
        return "[0.8, 0.8, 0.8]", ": a light grey (guess)"
    return None


def _number_of(word: str, frame: Frame) -> tuple[str, str] | None:
    known = {
        r"^near": (frame.near, ": of the camera"),
        r"^far": (frame.far, ": of the camera"),
        r"rough": (0.5, ": half rough (guess)"),
        r"metal": (0.0, ": no metal (guess)"),
        r"shin|specularpower|gloss": (32.0, ": an exponent (guess)"),
        r"alpha|opacity": (1.0, ": opaque (guess)"),
        r"^constant$": (1.0, ": of the attenuation (guess)"),
        r"^linear$": (0.09, ": of the attenuation (guess)"),
        r"^quadratic$": (0.032, ": of the attenuation (guess)"),
        r"outer": (0.95, ": cosine of a cone (guess)"),
        r"cutoff|inner": (0.97, ": cosine of a cone (guess)"),
        r"intensity|exposure|strength|scale|^ao$": (1.0, ": one (guess)"),
    }
    for pattern, (value, why) in known.items():
        if re.search(pattern, word):
            return numbers([value]), why
    return None


def _of_material(item: Wanted, material: Material) -> str | None:
    word, kind = plain(item.name), item.type
    if kind.is_array or not kind.is_float or kind.is_matrix or kind.struct is not None:
        return None
    if kind.rows in (3, 4) and material.color is not None and _COLOR.match(word):
        return numbers([*material.color, 1.0][: kind.rows])
    if kind.is_scalar and "rough" in word and material.roughness is not None:
        return numbers([material.roughness])
    if kind.is_scalar and "metal" in word and material.metallic is not None:
        return numbers([material.metallic])
    if kind.rows == 3 and "emiss" in word and material.emissive is not None:
        return numbers(material.emissive)
    return None


def _with_lone_matrix(guesses: list[Guess], inputs: ShaderInputs) -> Iterator[Guess]:
    """What other matrices are there tells what the rest is, and in which space normals are."""
    types = {item.name: item.type for item in inputs.uniforms}
    have = {guess.value.strip('"') for guess in guesses}
    projects = have & {"projection", "view-projection", "model-view-projection"}
    for guess in guesses:
        if guess.value == '"projection"' and guess.name in inputs.placing and not have & _VIEWS:
            whole = "view-projection" if "model" in have else "model-view-projection"
            why = f"{guess.why} (guess): there is no matrix of the view beside it"
            yield Guess(guess.name, f'"{whole}"', why, False)
            continue
        kind = types.get(guess.name)
        square = kind is not None and kind.cols == kind.rows == 4 and not kind.is_array
        if square and (not guess.sure or (guess.value == '"model"' and not projects)):
            other = "model" if projects else "model-view-projection"
            if other not in have or guess.value == '"model"':
                have.add(other)
                why = f"mat4 (guess): '{plain(guess.name)}' is what the others leave"
                guess = Guess(guess.name, f'"{other}"', why, False)
        if guess.value == '"normal-matrix"' and "model-view" not in have and "eye" in have:
            why = f'{guess.why} (guess): of the world, since the eye is; else "normal-matrix"'
            guess = Guess(guess.name, '"world-normal-matrix"', why, False)
        yield guess


def unknown(guesses: Sequence[Guess]) -> list[str]:
    """The names of those whose meaning is not known."""
    return [guess.name for guess in guesses if UNKNOWN in guess.why]
