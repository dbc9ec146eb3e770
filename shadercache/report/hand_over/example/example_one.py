"""The text of example.py for a scene of one object: no loops but those over what is declared."""

from __future__ import annotations

from string import Template

from shadercache.manifest.interface import AttributeInput, SamplerInput
from shadercache.report.hand_over.example.code_lines import call
from shadercache.report.hand_over.example.example_blocks import (
    ExampleBlocks,
    entries,
    filled,
    template,
)
from shadercache.report.hand_over.example.example_data import ALONE
from shadercache.report.hand_over.example.example_passes import (
    OWN,
    arguments_of,
    as_scalar,
    comment_of,
)
from shadercache.report.hand_over.example.example_targets import variable
from shadercache.report.hand_over.example.example_textures import texture_function
from shadercache.report.hand_over.handed_shaders import HandedShader


def example_of_one(blocks: ExampleBlocks) -> str:
    """The text."""
    [shader] = blocks.shaders
    moving = _moving(blocks)
    texts = {
        "title": blocks.title(),
        "about": blocks.about(),
        "constants": filled(blocks.constants(" ".join(blocks.added.values()))),
        "context": filled(blocks.context()),
        "texture": filled(texture_function(blocks.data.textures.values())),
        "targets": filled(blocks.targets.lines()),
        "inputs": filled(_inputs(blocks, moving)),
        "outputs": blocks.outputs(),
        "vertices": filled(_vertices(blocks, moving), 4),
        "binding": filled(
            [*_written(blocks, moving), *blocks.binding(_sampled(blocks), bool(moving))], 4
        ),
        "count": "vertices=-1 if array.index_buffer else 3" if _screen(blocks) else "",
        "frame": filled(_frame(blocks, shader), 4),
        "original": filled(_original(blocks, shader), 4),
        **blocks.picture(),
    }
    return Template(template("example_one.py.txt")).substitute(texts)


def _moving(blocks: ExampleBlocks) -> dict[str, str]:
    """What values are written to beside uniforms, by name, as code: buffers and textures."""
    [item] = blocks.data.objects[blocks.cached]
    made: dict[str, str] = {}
    for name, entry in blocks.inputs.items():
        original = blocks.twins.get(name, name)
        if original not in item.moving and name not in blocks.blocks:
            continue
        size = blocks.data.arrays[f"values/{original}"].shape
        made[name] = f'ctx.buffer(reserve=VALUES[0]["{original}"].nbytes)'
        if isinstance(entry, SamplerInput):
            made[name] = f'texture({(size[2], size[1])}, {size[3]}, "f4")'
    return made


def _played(blocks: ExampleBlocks) -> list[str]:
    """The textures that change from frame to frame."""
    inputs = blocks.inputs
    return [name for name in _moving(blocks) if isinstance(inputs[name], SamplerInput)]


def _sampled(blocks: ExampleBlocks) -> str:
    """What programs may sample, as code."""
    return "(TEXTURES | textures)" if _played(blocks) else blocks.sampled()


def _forms(blocks: ExampleBlocks) -> dict[str, str]:
    """The attributes of vertices, with their formats as code."""
    return {
        key.removeprefix(f"{ALONE}/"): f'"{array.shape[1]}{array.dtype.kind}"'
        for key, array in blocks.data.arrays.items()
        if key.startswith(f"{ALONE}/")
    }


def _inputs(blocks: ExampleBlocks, moving: dict[str, str]) -> list[str]:
    """Textures, values and vertices."""
    lines = [
        *blocks.textures(),
        'TABLES = {key[7:]: DATA[key] for key in DATA if key.startswith("values/")}',
        "VALUES = [{one: t[at % len(t)] for one, t in TABLES.items()} for at in range(FRAMES)]",
    ]
    lines += entries("MOVING = {", moving, "}") if moving else []
    played = _played(blocks)
    if played:
        equals = "|=" if blocks.data.textures else "="
        lines += entries(f"TEXTURES {equals} {{", {one: f'MOVING["{one}"]' for one in played}, "}")
    forms = _forms(blocks)
    if forms:
        lines += entries("FORMS = {", forms, "}  # of the vertices")
        made = f'(ctx.buffer(DATA[f"{ALONE}/{{one}}"].tobytes()), FORMS[one], one)'
        lines.append(f"MESH = [{made} for one in FORMS]")
        lines.append(f'INDEX = ctx.buffer(DATA["index/{ALONE}"].tobytes())')
    return lines


def _vertices(blocks: ExampleBlocks, moving: dict[str, str]) -> list[str]:
    """What a program draws: the mesh, or three vertices that cover the screen."""
    given = blocks.cached.objects[0].part.inputs
    if not _forms(blocks):
        return ["return made, ctx.vertex_array(made, [])"]
    lines = ["content = [part for part in MESH if part[2] in made]"]
    forms: dict[str, str] = {}
    for name in moving:
        stream = given.instances.streams.get(blocks.twins.get(name, name))
        if stream is not None and isinstance(blocks.inputs[name], AttributeInput):
            forms[name] = f'"{stream.shape[1]}f/i"'
    if forms:
        lines += entries("forms = {", forms, "}  # of the instances")
        lines.append("content += [(MOVING[one], forms[one], one) for one in forms if one in made]")
    index = "INDEX if content else None" if _screen(blocks) else "INDEX"
    if given.instances.number == 1:
        return [*lines, f"return made, ctx.vertex_array(made, content, {index})"]
    number = given.instances.number
    return [
        *lines,
        f"array = ctx.vertex_array(made, content, {index})",
        f"array.instances = {f'{number} if content else 1' if _screen(blocks) else number}",
        "return made, array",
    ]


def _screen(blocks: ExampleBlocks) -> bool:
    """Are there passes over the screen?"""
    return not _forms(blocks) or any(step.over_screen for step in blocks.steps)


def _written(blocks: ExampleBlocks, moving: dict[str, str]) -> list[str]:
    """What fills and binds buffers and textures of changing values."""
    if not moving:
        return []
    lines = ["for one in MOVING.keys() & values.keys():"]
    lines.append("    MOVING[one].write(values[one].tobytes())")
    if blocks.blocks:
        names = ", ".join(f'"{name}"' for name in blocks.blocks)
        lines.append(f"for point, one in enumerate([{names}]):")
        lines.append("    MOVING[one].bind_to_uniform_block(point)")
        lines.append("    if one in made:")
        lines.append("        made[one].binding = point")
    return lines


def _frame(blocks: ExampleBlocks, shader: HandedShader) -> list[str]:
    """A frame by the variant."""
    lines = [f"reset, {blocks.targets.swapped()} = {blocks.resets}, caches"]
    own = {
        one.name: as_scalar(one, _own(shader, one.role)) for one in shader.added if one.role in OWN
    }
    twins = {twin: f'VALUES[frame - 1]["{name}"]' for twin, name in blocks.twins.items()}
    lines += entries("values = VALUES[frame] | {", {**twins, **blocks.added, **own}, "}")
    lines += blocks.clears()
    for step in blocks.steps:
        lines.append(comment_of(step))
        given = [f'"{step.program}"', "values", *arguments_of(step, blocks.targets)]
        if not step.entry.depth.write:
            place = ", ".join(["marks", *blocks.targets.attached(shader, step.entry)])
            lines.append(f"framebuffer({place}).depth_mask = False")
        if step.entry.on_reset:
            lines += call("draw(", given)
        else:
            lines += ["if not reset:", *call("draw(", given, 4)]
    return [*lines, "caches.reverse()"]


def _own(shader: HandedShader, role: str) -> int:
    item = shader.objects[0]
    return {"object": item.number, "mask": item.part.caching.mask}.get(role, 1)


def _original(blocks: ExampleBlocks, shader: HandedShader) -> list[str]:
    name = shader.folder + shader.manifest.original.fragment.removesuffix(".frag")
    colors = ", ".join(variable(target) for target in shader.manifest.original.targets)
    call = f'draw("{name}", VALUES[frame], {{}}, [{colors}], "<")'
    return [*blocks.targets.cleared(), call]
