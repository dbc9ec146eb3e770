"""The passes of an example's code: what is set for them, and the calls that draw them."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import UNSET

from shadercache.caching.algorithms import PARKED, algorithm
from shadercache.manifest.pass_model import AddedUniform, Role
from shadercache.render.depth_spec import depth_spec
from shadercache.report.hand_over.example.example_targets import ExampleTargets, variable
from shadercache.report.hand_over.frame_order import PassStep
from shadercache.report.hand_over.handed_shaders import HandedShader
from shadercache.scene.description import Scene

OWN: tuple[Role, ...] = ("object", "mask", "group")
"""Roles whose values each object has for itself."""

_OF_FRAME: dict[Role, str] = {
    "clock": "frame % PERIOD",
    "period": "PERIOD",
    "block": "BLOCK",
    "reset": "reset",
    "viewport": "[0, 0, *SIZE]",
    "previous-viewport": "[0, 0, *SIZE]",
    "scale": "[SMALL[0] / SIZE[0], SMALL[1] / SIZE[1], 0, 0]",
}


def added_values(shaders: Iterable[HandedShader], scene: Scene) -> dict[str, str]:
    """What each uniform that was added is set to, as code; without samplers, and without what
    objects have for themselves."""
    camera = scene.view.camera
    unit = repr(2.0 * camera.near * camera.far / (camera.far - camera.near))
    values: dict[str, str] = {}
    for shader in shaders:
        for one in shader.added:
            if "sampler" not in one.type and one.role not in OWN:
                usual = unit if one.role == "unit" else repr(one.default)
                number = _OF_FRAME.get(one.role, usual)
                if one.on_reset is not UNSET and one.role != "reset" and shader.on_reset(one.name):
                    number = f"{one.on_reset!r} if reset else {number}"
                values[one.name] = as_scalar(one, number)
    return values


def as_scalar(uniform: AddedUniform, number: object) -> str:
    """A number as code that has the uniform's bytes."""
    kind = "int32" if uniform.type.startswith("i") else "float32"
    return f"np.{kind}({number})"


def comment_of(step: PassStep) -> str:
    """What a pass does."""
    variant = step.shader.variant
    if not step.cached or variant is None:
        return f"# {step.shader.title} is not cached: it comes first, with no cache attached."
    words = algorithm(variant.variants[0].algorithm).words_of(step.entry.name)
    return f"# {step.entry.name}: {words}."


def arguments_of(step: PassStep, targets: ExampleTargets) -> list[str]:
    """What the call of ``draw`` has behind the name and the values."""
    entry = step.entry
    spec = depth_spec(entry.depth, targets.divisor > 1 and "color" not in entry.targets)
    samplers = [
        f'"{one.name}": {variable(one.role)}'
        for one in step.shader.added
        if one.role in entry.reads and one.name in entry.uniforms
    ]
    textures = f"{{{', '.join(samplers)}}}"
    if any(one.startswith(PARKED) for one in entry.reads):
        textures = targets.parked(step.shader)
    attached = f"[{', '.join(targets.attached(step.shader, entry))}]"
    given = [textures, attached, f'"{spec.test}"']
    buffer = {"marks": "marks", "apart": "small_depth"}.get(spec.buffer)
    return [*given, buffer] if buffer else given
