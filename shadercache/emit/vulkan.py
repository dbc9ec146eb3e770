"""The last step before Vulkan GLSL is printed: what was added gets the places that it needs there.

Passes are put together as for OpenGL. In Vulkan no uniform stands outside of a block, textures and
blocks have sets and bindings, varyings and attributes have locations (GL_KHR_vulkan_glsl).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, TypeVar

from shadercache.analysis.moving import is_texture
from shadercache.ast import nodes as n
from shadercache.caching.algorithms import PARKED
from shadercache.caching.read_template import read_template
from shadercache.emit.packing import PACKINGS, has_word
from shadercache.emit.runtime import FOLDER
from shadercache.source import NOWHERE
from shadercache.transform.rename import rename
from shadercache.transform.trees import replace_nodes

D = TypeVar("D", n.VarDecl, n.BlockDecl)

BLOCK, BLOCK_BINDING = "uniforms", 0
"""The block of the uniforms that are added, and its binding."""

FIRST_TWIN = 16
"""The binding of the first twin; what is added for the cache has those below."""

PUSH_CONSTANT = "push_constant"

_TEXTURES = ("cache", "cache_2", "payloads", "payloads_2")
_VARYINGS = ("current", "previous", "object")
_BUILTINS = {"gl_VertexID": "gl_VertexIndex", "gl_InstanceID": "gl_InstanceIndex"}
_FARTHEST = ("gl_DepthRange", "far")
"""What Vulkan has not; its viewports reach from 0 to 1 here, as the manifest says."""


@dataclass(frozen=True, slots=True)
class VulkanPlaces:
    """What the user's shaders leave free: a descriptor ``set``, locations of varyings from
    ``varying`` on; and ``locations`` of the attributes that are twins, by their names.
    ``instanced``: are several instances drawn at once?"""

    set: int
    varying: int
    instanced: bool = False
    locations: Mapping[str, int] = field(default_factory=dict)


def binding_of(name: str) -> int:
    """The binding of a texture that is added, by its name without the prefix."""
    stem, _, number = name.rpartition("_")
    if stem == PARKED:
        return len(_TEXTURES) + int(number)
    return 1 + _TEXTURES.index(name)


def uniform_block(prefix: str, instanced: bool) -> n.BlockDecl:
    """The block of what is added. Of instances it holds the number of the first, since that of
    each is a varying."""
    [block] = read_template(FOLDER / "vulkan_block.glsl", prefix).decls
    assert isinstance(block, n.BlockDecl)
    if instanced:
        block = rename(block, {f"{prefix}object": f"{prefix}first_object"})
    return block


def vulkan_form(module: n.Module, prefix: str, places: VulkanPlaces) -> n.Module:
    """A pass, or the vertex shader of one, as Vulkan has it."""
    added = uniform_block(prefix, places.instanced)
    block = _placed(added, set=places.set, binding=BLOCK_BINDING)
    decls: list[n.Decl] = []
    for decl in module.decls:
        if _is_plain_uniform(decl):
            if block not in decls:
                decls.append(block)
        else:
            decls += _form(decl, prefix, places)
    return replace(module, decls=tuple(rename(_without_range(one), _BUILTINS) for one in decls))


def _is_plain_uniform(decl: n.Decl) -> bool:
    """Is it a uniform outside of a block that is no texture? The user's shader has none."""
    plain = isinstance(decl, n.VarDecl) and decl.qualifiers.has("uniform")
    return plain and not is_texture(decl)


def _form(decl: n.Decl, prefix: str, places: VulkanPlaces) -> Iterator[n.Decl]:
    if isinstance(decl, n.BlockDecl) and decl.name.startswith(prefix):
        if decl.qualifiers.has("out"):
            yield from _as_variables(decl)
        else:
            yield _placed(_as_buffer(decl), set=places.set)
    elif isinstance(decl, n.VarDecl) and decl.declarators:
        yield _variable(decl, prefix, places)
    else:
        yield decl


def _variable(decl: n.VarDecl, prefix: str, places: VulkanPlaces) -> n.VarDecl:
    name = decl.declarators[0].name
    own = name.removeprefix(prefix)
    if own == name:
        return decl
    if decl.qualifiers.has("uniform"):
        twin = has_word(decl.qualifiers, "binding")
        return _placed(decl, set=places.set, **{} if twin else {"binding": binding_of(own)})
    if name in places.locations:
        return _placed(decl, location=places.locations[name])
    if decl.qualifiers.has("in", "out") and own in _VARYINGS:
        return _placed(decl, location=places.varying + _VARYINGS.index(own))
    return decl


def _as_variables(decl: n.BlockDecl) -> Iterator[n.VarDecl]:
    """The twin of a block of varyings as what it is, variables that no other stage reads: a block
    would need locations."""
    plain = [replace(one, qualifiers=n.NO_QUALIFIERS) for one in decl.fields]
    if decl.instance is None:
        yield from plain
    else:
        struct = n.StructDef(NOWHERE, decl.name, tuple(plain))
        kind = n.TypeSpec(NOWHERE, decl.name, struct)
        variable = n.Declarator(NOWHERE, decl.instance, decl.dims)
        yield n.VarDecl(NOWHERE, n.NO_QUALIFIERS, kind, (variable,))


def _as_buffer(decl: n.BlockDecl) -> n.BlockDecl:
    """The twin of push constants as a buffer with the same offsets: a program has one block of
    these, and uniform blocks are laid out otherwise."""
    if not has_word(decl.qualifiers, PUSH_CONSTANT):
        return decl
    layout = decl.qualifiers.layout or ()
    kept = tuple(entry for entry in layout if entry.name != PUSH_CONSTANT)
    packed = any(entry.name.lower() in (*PACKINGS, "scalar") for entry in kept)
    if not packed:
        kept = (n.LayoutItem(NOWHERE, "std430", None), *kept)
    words = tuple("buffer" if word == "uniform" else word for word in decl.qualifiers.words)
    qualifiers = replace(decl.qualifiers, words=("readonly", *words), layout=kept)
    return replace(decl, qualifiers=qualifiers)


def _placed(decl: D, **places: int) -> D:
    """A declaration at these places, and at no others of their kinds."""
    known: tuple[n.LayoutItem, ...] = decl.qualifiers.layout or ()
    layout = (*_items(places), *(item for item in known if item.name not in places))
    return replace(decl, qualifiers=replace(decl.qualifiers, layout=layout))


def _items(places: Mapping[str, int]) -> Iterator[n.LayoutItem]:
    for word, number in places.items():
        yield n.LayoutItem(NOWHERE, word, n.Literal(NOWHERE, str(number)))


def _without_range(decl: n.Decl) -> n.Decl:
    def chosen(_: n.Node, node: Any) -> Any:
        known = isinstance(node, n.Member) and isinstance(node.object, n.Name)
        if known and (node.object.name, node.name) == _FARTHEST:
            return n.Literal(NOWHERE, "1.0")
        return node

    return replace_nodes(decl, chosen)
