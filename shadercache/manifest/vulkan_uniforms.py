"""Where the added uniforms stand in Vulkan GLSL."""

from __future__ import annotations

from collections.abc import Iterable

from msgspec import UNSET, UnsetType, structs

from shadercache.emit.program_set import ProgramSet
from shadercache.emit.vulkan import BLOCK, BLOCK_BINDING, binding_of, uniform_block
from shadercache.lang.block_layout import alignment, up
from shadercache.lang.types import builtin_type
from shadercache.manifest.pass_model import AddedBlock, AddedUniform

_UNIT = 16
_MEANINGS = {
    "viewport": "left, top, width and height of the viewport",
    "object": "in place of the number of an object: for each draw the number of its first instance "
    "less the draw's firstInstance, from which gl_InstanceIndex counts",
}
"""What is said otherwise than of OpenGL."""


def in_block(uniforms: Iterable[AddedUniform], programs: ProgramSet) -> tuple[AddedUniform, ...]:
    """The uniforms with their places, of Vulkan GLSL."""
    places = programs.vulkan
    if places is None:
        return tuple(uniforms)
    offsets = dict(_offsets(programs))
    return tuple(_placed(uniform, offsets, programs) for uniform in uniforms)


def _placed(uniform: AddedUniform, offsets: dict[str, int], programs: ProgramSet) -> AddedUniform:
    if uniform.name not in offsets:
        binding = binding_of(uniform.name.removeprefix(programs.prefix))
        return structs.replace(uniform, binding=binding)
    meaning = uniform.meaning
    if uniform.role == "viewport" or uniform.name.endswith("first_object"):
        meaning = _MEANINGS[uniform.role]
    return structs.replace(uniform, offset=offsets[uniform.name], meaning=meaning)


def added_block(programs: ProgramSet) -> AddedBlock | UnsetType:
    """The block that they are in, of Vulkan GLSL."""
    places = programs.vulkan
    if places is None:
        return UNSET
    *_, (_, offset) = _offsets(programs)
    return AddedBlock(
        name=f"{programs.prefix}{BLOCK}",
        set=places.set,
        binding=BLOCK_BINDING,
        size=up(offset + 4, _UNIT),
    )


def _offsets(programs: ProgramSet) -> Iterable[tuple[str, int]]:
    """The members in order, and where they begin (std140)."""
    assert programs.vulkan is not None
    at = 0
    for field in uniform_block(programs.prefix, programs.vulkan.instanced).fields:
        kind = builtin_type(field.type.name)
        assert kind is not None
        unit, size = alignment(kind, "std140")
        at = up(at, unit)
        yield field.declarators[0].name, at
        at += size
