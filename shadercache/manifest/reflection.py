"""What an engine gives a shader, with its kind, type and place: the user's part of the interface.

It is read from the checked trees of both stages; the twins of the last frame follow from it.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping
from math import isfinite, prod
from typing import Any

from msgspec import UNSET, UnsetType, structs

from shadercache.ast import nodes as n
from shadercache.emit.packing import Packing, has_word, is_default
from shadercache.emit.printer import print_node
from shadercache.emit.vertex import LastFrame
from shadercache.emit.vulkan import PUSH_CONSTANT, VulkanPlaces
from shadercache.front.preprocess import enabled_extensions
from shadercache.lang.availability import VULKAN
from shadercache.lang.block_layout import LAID_OUT, up
from shadercache.manifest import interface
from shadercache.manifest.block_members import block_members, number_of, struct_members
from shadercache.manifest.interface import BOUND, InputEntry
from shadercache.manifest.model import DependencyEntry
from shadercache.manifest.vulkan_inputs import twin_in_vulkan
from shadercache.sema.facts import Facts, Stage
from shadercache.sema.fold import Value, flattened, fold_construct

_BLOCKS = (interface.UniformBlockInput, interface.StorageBlockInput)
_STORAGES = ("uniform", "buffer")

_TEXTURE = re.compile(
    r"([iu]?)(?:sampler|image|texture)(1D|2D|3D|Cube|Buffer|ExternalOES)(Rect)?(MS)?(Array)?(Shadow)?"
)
_DIMENSIONS = {"Cube": "cube", "Buffer": "buffer", "ExternalOES": "2D"}
_COMPONENTS = {"": "float", "i": "int", "u": "uint"}
_BUFFER_UNIT = 16  # Drivers count a block up to a whole vec4.


def inputs_of(stages: Iterable[tuple[n.Module, Facts, Stage]]) -> tuple[InputEntry, ...]:
    """What the stages of a program are given; what two of them declare is listed once."""
    inputs: dict[tuple[type, str], InputEntry] = {}
    for module, facts, stage in stages:
        for entry in _inputs(module, facts, stage):
            key = interface.name_space(entry), entry.name
            inputs[key] = _joined(inputs[key], entry) if key in inputs else entry
    return tuple(inputs.values())


def declared_inputs(
    inputs: Iterable[InputEntry],
    last_frame: LastFrame,
    uniforms: Collection[str],
    attributes: Collection[str],
    vulkan: VulkanPlaces | None = None,
) -> tuple[InputEntry, ...]:
    """Those of the inputs that programs declare, with the twins of the last frame behind them."""
    known, previous, bindings = tuple(inputs), last_frame.twins, last_frame.bindings
    # What the fragment shader alone declares may share its name with a block that has a twin.
    twins = tuple(
        _twin(entry, previous, bindings.get(entry.name))
        for entry in known
        if entry.name in previous and "vertex" in entry.stages
    )
    if vulkan is not None:
        twins = tuple(twin_in_vulkan(twin, vulkan) for twin in twins)
    return interface.declared_of(known + twins, uniforms, attributes)


def dependencies(
    read: Mapping[Stage, frozenset[str]], inputs: Iterable[InputEntry]
) -> tuple[DependencyEntry, ...]:
    """What a value depends on, in the order of ``inputs``; built-in inputs come last.

    ``read``: the names of variables, of members and instances of blocks that each stage reads.
    """
    entries: list[DependencyEntry] = []
    for entry in inputs:
        members = [member.name for member in entry.members] if isinstance(entry, _BLOCKS) else []
        # Reads are known by variable. Of a block with an instance that is the whole of it.
        if isinstance(entry, _BLOCKS) and entry.instance is not None:
            known, members = {entry.instance}, []
        else:
            known = set(members) or {entry.name}
        stages = tuple(stage for stage in entry.stages if known & read.get(stage, frozenset()))
        if stages:
            parts = tuple(m for m in members if any(m in read[stage] for stage in stages))
            kind: Any = type(entry).__struct_config__.tag
            entries.append(
                DependencyEntry(kind=kind, name=entry.name, stages=stages, members=parts)
            )
    return (
        *entries,
        *(
            DependencyEntry(kind="built-in", name=name, stages=(stage,))
            for stage, names in read.items()
            for name in sorted(names)
            if name.startswith("gl_")
        ),
    )


def _joined(one: InputEntry, other: InputEntry) -> InputEntry:
    """One input that both stages declare; a place may stand in one of them only."""
    changed: dict[str, Any] = {"stages": (*one.stages, *other.stages)}
    for name in ("location", "binding", "default"):
        # 0 stands for an input that has no such field.
        if getattr(one, name, 0) in (None, UNSET):
            changed[name] = getattr(other, name, getattr(one, name))
    if isinstance(one, _BLOCKS) and isinstance(other, _BLOCKS):
        read = {member.name for member in other.members if member.read}
        changed["members"] = tuple(
            structs.replace(member, read=member.read or member.name in read)
            for member in one.members
        )
    return structs.replace(one, **changed)


def _twin(entry: InputEntry, previous: Mapping[str, str], binding: int | None) -> InputEntry:
    """It has no location of its own, and stands in the vertex shader alone."""
    changed: dict[str, Any] = {
        "name": previous[entry.name],
        "stages": ("vertex",),
        "previous_of": entry.name,
    }
    if isinstance(entry, interface.UniformInput | interface.AttributeInput):
        return structs.replace(entry, location=None, **changed)
    if not isinstance(entry, _BLOCKS):
        return structs.replace(entry, binding=binding, **changed)
    if entry.instance is None:
        changed["members"] = tuple(
            structs.replace(member, name=previous[member.name]) for member in entry.members
        )
    else:
        changed["instance"] = previous[entry.instance]
    # Of a packed block a program may leave out what it does not read.
    same = entry.packing != "packed"
    return structs.replace(entry, binding=binding, takes_the_last_buffer=same, **changed)


def twin_bindings(inputs: Iterable[InputEntry]) -> dict[str, int]:
    """The bindings that twins would have, by the name of what has one: of inputs of the vertex
    shader that have a binding themselves, the next that nothing of their kind has."""
    placed = [(entry, entry.binding) for entry in inputs if isinstance(entry, BOUND)]
    free: dict[type, int] = {}
    for entry, binding in placed:
        end = 0 if binding is None else binding + prod(entry.dims)
        free[type(entry)] = max(free.get(type(entry), 0), end)
    bindings: dict[str, int] = {}
    for entry, binding in placed:
        if "vertex" in entry.stages and binding is not None:
            bindings[entry.name] = free[type(entry)]
            free[type(entry)] += prod(entry.dims)
    return bindings


def _inputs(module: n.Module, facts: Facts, stage: Stage) -> Iterator[InputEntry]:
    vulkan = VULKAN in enabled_extensions(module)
    # OpenGL leaves open how a block is laid out that does not say it; Vulkan does not.
    usual = ("std140", "std430") if vulkan else ("shared", "shared")
    defaults = {word: Packing(packing) for word, packing in zip(_STORAGES, usual, strict=True)}
    for decl in module.decls:
        # `layout(std140) uniform;` holds for the blocks behind it, so declarations are taken in
        # order (GLSL 4.60 section 4.4.5).
        if isinstance(decl, n.QualifierDecl):
            for storage in _STORAGES:
                if is_default(decl, storage):
                    defaults[storage] = defaults[storage].under(decl.qualifiers)
        elif isinstance(decl, n.BlockDecl) and decl.qualifiers.has(*_STORAGES):
            storage = next(word for word in _STORAGES if decl.qualifiers.has(word))
            pushed = has_word(decl.qualifiers, PUSH_CONSTANT)
            default = Packing("std430") if pushed else defaults[storage]
            packing = default.under(decl.qualifiers)
            yield _block(decl, module, facts, stage, packing)
        # What a fragment shader has as `in` are varyings, which no engine gives.
        elif isinstance(decl, n.VarDecl) and has_word(decl.qualifiers, "constant_id"):
            yield _specialised(decl, facts, stage)
        elif isinstance(decl, n.VarDecl) and (
            decl.qualifiers.has("uniform") or (stage == "vertex" and decl.qualifiers.has("in"))
        ):
            for node in decl.declarators:
                yield _variable(decl.qualifiers, node, facts, stage)


def _variable(
    qualifiers: n.Qualifiers, node: n.Declarator, facts: Facts, stage: Stage
) -> InputEntry:
    kind = facts.declared[node].type
    dims = tuple(size or 0 for size in kind.dims)
    about: dict[str, Any] = {"name": node.name, "stages": (stage,), "type": str(kind), "dims": dims}
    location = number_of(qualifiers, "location", facts)
    binding = number_of(qualifiers, "binding", facts)
    if not qualifiers.has("uniform"):
        return interface.AttributeInput(**about, location=location)
    # Counters are opaque as well, so they are sorted out before textures.
    if kind.name == "atomic_uint":
        return interface.CounterInput(**about, binding=binding)
    if kind.struct is None and kind.holds_opaque:
        return _opaque(
            about | {"binding": binding, "set": _set_of(qualifiers, facts)}, qualifiers, facts
        )
    default, members = _default(node.init, facts), struct_members(kind)
    return interface.UniformInput(**about, location=location, default=default, members=members)


def _set_of(qualifiers: n.Qualifiers, facts: Facts) -> int | UnsetType:
    number = number_of(qualifiers, "set", facts)
    return UNSET if number is None else number


def _specialised(decl: n.VarDecl, facts: Facts, stage: Stage) -> InputEntry:
    [node] = decl.declarators
    assert node.init is not None
    number = number_of(decl.qualifiers, "constant_id", facts)
    return interface.SpecialisedInput(
        name=node.name,
        stages=(stage,),
        type=str(facts.declared[node].type),
        constant_id=number or 0,
        default=print_node(node.init),
    )


def _opaque(about: dict[str, Any], qualifiers: n.Qualifiers, facts: Facts) -> InputEntry:
    """A texture, an image, a sampler, or what a subpass has left."""
    kind = about["type"].partition("[")[0]
    if "subpassInput" in kind:
        number = number_of(qualifiers, "input_attachment_index", facts)
        return interface.SubpassInput(**about, input_attachment_index=number)
    if kind in ("sampler", "samplerShadow"):
        return interface.SamplerStateInput(**about, compares=kind != "sampler")
    return _texture(about)


def _texture(about: dict[str, Any]) -> InputEntry:
    """A sampler or an image, with what the name of its type says of the texture."""
    kind = about["type"]
    # Not the whole of it: the sizes of an array may follow.
    words = _TEXTURE.match(kind)
    assert words is not None, kind
    about = about | {
        "dimension": "rectangle" if words[3] else _DIMENSIONS.get(words[2], words[2]),
        "component": _COMPONENTS[words[1]],
        "layers": bool(words[5]),
        "multisampled": bool(words[4]),
    }
    if "image" in kind:
        return interface.ImageInput(**about)
    if "texture" in kind:
        return interface.TextureInput(**about)
    return interface.SamplerInput(
        **about, compares="Shadow" in kind, external=kind.startswith("samplerExternalOES")
    )


def _block(
    decl: n.BlockDecl, module: n.Module, facts: Facts, stage: Stage, packing: Packing
) -> InputEntry:
    dims = facts.declared[decl].type.dims if decl.instance is not None else ()
    members, end = block_members(module, decl, facts, packing)
    uniform = decl.qualifiers.has("uniform")
    kind = interface.UniformBlockInput if uniform else interface.StorageBlockInput
    about: dict[str, Any] = {"packing": packing.packing, "matrices": packing.matrices}
    if has_word(decl.qualifiers, PUSH_CONSTANT):
        about["push_constant"] = True
    return kind(
        name=decl.name,
        stages=(stage,),
        instance=decl.instance,
        dims=tuple(size or 1 for size in dims),
        binding=number_of(decl.qualifiers, "binding", facts),
        set=_set_of(decl.qualifiers, facts),
        size=up(end, _BUFFER_UNIT) if packing.packing in LAID_OUT else UNSET,
        members=members,
        **about,
    )


def _default(init: n.Expr | None, facts: Facts) -> tuple[float, ...] | str | UnsetType:
    """The numbers of an initialiser, or its text where only the driver knows them."""
    if init is None:
        return UNSET
    value = _value(init, facts)
    numbers = () if value is None else tuple(map(float, flattened(value)))
    # JSON has no infinities.
    return numbers if numbers and all(map(isfinite, numbers)) else print_node(init)


def _value(expr: n.Expr, facts: Facts) -> Value | None:
    known: Value | None = facts.constants.get(expr)
    if known is not None or not isinstance(expr, n.Construct):
        return known
    parts = [_value(part, facts) for part in expr.args]
    values = [part for part in parts if part is not None]
    return fold_construct(facts.types[expr], values) if len(values) == len(parts) else None
