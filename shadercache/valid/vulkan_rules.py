"""What Vulkan GLSL wants and forbids (GL_KHR_vulkan_glsl, and what SPIR-V makes glslang demand)."""

from __future__ import annotations

from collections.abc import Iterator

from shadercache.ast import nodes as n
from shadercache.lang.builtins import Signature
from shadercache.lang.types import Type
from shadercache.sema.declarations import BUILTIN_BLOCK
from shadercache.sema.facts import Kind
from shadercache.sema.problems import ERROR
from shadercache.valid.suspect import Finding, Suspect

_SUBPASS = "input_attachment_index"
_PUSH, _CONSTANT = "push_constant", "constant_id"
_UNPACKED = ("shared", "packed")


def vulkan(module: n.Module, suspect: Suspect) -> Iterator[Finding]:
    """The declarations of a module, if it is Vulkan's."""
    if not suspect.language.vulkan:
        return
    for decl in module.decls:
        if isinstance(decl, n.VarDecl):
            storage = suspect.storage(decl.qualifiers)
            for variable in decl.declarators:
                kind = suspect.tables.declared[variable].type
                if kind is not ERROR and not variable.name.startswith("gl_"):
                    yield from _variable(variable, decl.qualifiers, storage, kind)
        elif isinstance(decl, n.BlockDecl) and decl.name != BUILTIN_BLOCK:
            yield from _block(decl, suspect.storage(decl.qualifiers), suspect)
    yield from _twice_specialised(module, suspect)


def _words(qualifiers: n.Qualifiers) -> frozenset[str]:
    return frozenset(item.name.lower() for item in qualifiers.layout or ())


def _variable(
    node: n.Declarator, qualifiers: n.Qualifiers, storage: Kind, kind: Type
) -> Iterator[Finding]:
    words, name = _words(qualifiers), node.name
    if _CONSTANT in words and (storage != "const" or not kind.is_scalar):
        message = f"'constant_id' is for scalar constants, not for '{name}' of type {kind}"
        yield Finding("SC223", message, node)
    if storage in ("in", "out") and "location" not in words:
        message = f"'{name}' has no location: Vulkan links by locations, not by names"
        yield Finding("SC223", message, node, "write layout(location = 0) before it")
    elif storage == "uniform" and not kind.holds_opaque:
        message = f"'{name}' is a uniform outside of a block, which Vulkan lacks"
        hint = "put it into a block: layout(set = 0, binding = 0) uniform Name { ... };"
        yield Finding("SC221", message, node, hint)
    elif storage == "uniform":
        yield from _resource(node, words, kind)


def _resource(node: n.Declarator, words: frozenset[str], kind: Type) -> Iterator[Finding]:
    """A sampler, texture, image or input of a subpass."""
    subpass = "subpassInput" in kind.name
    if kind.name == "atomic_uint":
        yield Finding("SC221", "Vulkan has no atomic counters", node)
    elif "Rect" in kind.name:
        yield Finding("SC221", "Vulkan has no rectangle textures: take one of two dimensions", node)
    elif "binding" not in words and kind.struct is None:
        yield Finding("SC223", _without_binding(node.name), node)
    if subpass != (_SUBPASS in words):
        without = f"the subpass input '{node.name}' has no layout(input_attachment_index = 0)"
        message = without if subpass else f"'{_SUBPASS}' is for subpass inputs, not for {kind}"
        yield Finding("SC223", message, node)


def _block(node: n.BlockDecl, storage: Kind, suspect: Suspect) -> Iterator[Finding]:
    words = _words(node.qualifiers)
    if storage in ("in", "out"):
        located = "location" in words or all(
            "location" in _words(field.qualifiers) for field in node.fields
        )
        if not located:
            message = f"the block '{node.name}' has no location: Vulkan links by locations"
            yield Finding("SC223", message, node, "write layout(location = 0) before it")
        return
    for word in _UNPACKED:
        if word in words:
            yield Finding("SC223", f"Vulkan has no layout '{word}'", node, "write std140")
    if _PUSH in words and words & {"set", "binding"}:
        message = f"the push constants '{node.name}' have neither a set nor a binding"
        yield Finding("SC223", message, node)
    elif words.isdisjoint((_PUSH, "binding", "buffer_reference")):
        yield Finding("SC223", _without_binding(node.name), node)
    scalar = "GL_EXT_scalar_block_layout" in suspect.language.extensions
    if "std430" in words and storage == "uniform" and _PUSH not in words and not scalar:
        yield Finding("SC223", "'std430' is for buffers and push constants", node)


def _without_binding(name: str) -> str:
    return f"'{name}' has no layout(set = ..., binding = ...), by which Vulkan finds it"


def _twice_specialised(module: n.Module, suspect: Suspect) -> Iterator[Finding]:
    """Each specialisation constant has a number of its own."""
    taken: dict[object, str] = {}
    for decl in module.decls:
        if not isinstance(decl, n.VarDecl):
            continue
        for item in decl.qualifiers.layout or ():
            if item.name.lower() != _CONSTANT or item.value is None:
                continue
            number = suspect.value(item.value)
            for variable in decl.declarators:
                other = taken.setdefault(number, variable.name)
                if other != variable.name:
                    message = f"'{variable.name}' and '{other}' share the constant_id {number}"
                    yield Finding("SC223", message, variable)


def combined(call: n.Call, suspect: Suspect) -> Iterator[Finding]:
    """``sampler2D(t, s)`` stands where a texture is read."""
    if call not in suspect.tables.calls or not suspect.language.vulkan:
        return
    if isinstance(suspect.tables.calls[call], Signature):
        return
    for arg in call.args:
        if isinstance(arg, n.Construct) and suspect.type_of(arg).is_opaque:
            message = f"{suspect.type_of(arg)}(...) stands only where a built-in function reads it"
            yield Finding("SC219", message, arg, "give the function the texture and the sampler")
