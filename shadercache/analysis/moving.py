"""Which attributes, textures and buffers move: those have a twin, for the last frame's position.

Uniforms may all change, and all have one. Of other inputs most rest (positions, normals); a twin
costs memory. What moves is told by name, or guessed from names and types, as no text says it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from difflib import get_close_matches
from typing import TypeGuard

from shadercache.analysis.effects import global_names
from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.diagnostics import Diagnostic, InputError
from shadercache.front.read_options import ReadOptions
from shadercache.lang.types import builtin_type
from shadercache.source import Source

_INSTANCES = frozenset(("instance", "instances", "instanced", "inst"))
_FIGURES = frozenset(
    (
        *("bone", "bones", "joint", "joints", "skin", "skinning", "pose", "poses", "palette"),
        *("morph", "morphs", "transform", "transforms", "anim", "animation", "vat"),
    )
)
_PARTS = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")
"""The words of a name: ``u_boneMatrices`` is made of u, bone and Matrices."""

_NUMBERS = ("gl_InstanceID", "gl_InstanceIDARB", "gl_InstanceIndex")

NO_GUESS = "none"
"""The word by which nothing is guessed."""


def is_texture(decl: n.Decl) -> TypeGuard[n.VarDecl]:
    """Is it a sampler, an image or an array of them?"""
    if not isinstance(decl, n.VarDecl) or not decl.qualifiers.has("uniform"):
        return False
    kind = builtin_type(decl.type.name)
    return kind is not None and kind.is_opaque


def may_move(decl: n.Decl) -> TypeGuard[n.VarDecl | n.BlockDecl]:
    """Is it an attribute, a texture or a storage buffer?"""
    if isinstance(decl, n.BlockDecl):
        return decl.qualifiers.has("buffer")
    return isinstance(decl, n.VarDecl) and (decl.qualifiers.has("in") or is_texture(decl))


def guessed(sliced: n.Module) -> frozenset[str]:
    """What is taken to move among the inputs of a slice that computes the position, by its name or
    its type; blocks by their own name."""
    return frozenset(filter(None, map(_guessed, sliced.decls)))


def is_instanced(module: n.Module, reading: ReadOptions) -> bool:
    """Are several instances drawn at once? So it was said, or the vertex shader asks for the number
    of one, or has an attribute that each has of its own, or that is said to move."""
    asked = reading.instanced or any(
        isinstance(node, n.Name) and node.name in _NUMBERS for node in walk(module)
    )
    attributes = (decl for decl in module.decls if _is_attribute(decl))
    moving = set(reading.moving)
    guesses = NO_GUESS not in moving
    return asked or any(
        (guesses and _guessed(it)) or moving.intersection(_known_as(it)) for it in attributes
    )


def moving_inputs(
    sliced: n.Module, asked: Sequence[str], module: n.Module, source: Source
) -> frozenset[str]:
    """The names of what moves: what is guessed, unless :data:`NO_GUESS` is asked for, and what is
    asked for and decides the position.

    ``asked``: names of attributes, textures, and of buffers, their instances or members. Raises
    :class:`InputError` SC464 for a name that the vertex shader (``module``) does not have.
    """
    names, known = _names(sliced), _names(module)
    for name in asked:
        if name not in known and name != NO_GUESS:
            near = get_close_matches(name, known, 1)
            meant = f"did you mean '{near[0]}'? " if near else ""
            hint = f"{meant}these decide the position: {', '.join(names) or 'none'}"
            message = f"the vertex shader has no attribute, texture or buffer '{name}'"
            raise InputError(Diagnostic("SC464", message, source, hint=hint))
    taken = frozenset[str]() if NO_GUESS in asked else guessed(sliced)
    return taken | {names[name] for name in asked if name in names}


def _names(module: n.Module) -> Mapping[str, str]:
    """Every name by which an input that may move is known -> the one it goes by."""
    return {
        name: decl.name if isinstance(decl, n.BlockDecl) else name
        for decl in module.decls
        if may_move(decl)
        for name in _known_as(decl)
    }


def _known_as(decl: n.VarDecl | n.BlockDecl) -> Iterator[str]:
    if isinstance(decl, n.BlockDecl):
        yield decl.name
    yield from global_names(decl)


def _is_attribute(decl: n.Decl) -> TypeGuard[n.VarDecl]:
    return isinstance(decl, n.VarDecl) and decl.qualifiers.has("in")


def _guessed(decl: n.Decl) -> str:
    """The name of an input that is taken to move, or an empty one."""
    if not may_move(decl):
        return ""
    name = decl.name if isinstance(decl, n.BlockDecl) else next(iter(global_names(decl)))
    words = {part.lower() for known in _known_as(decl) for part in _PARTS.findall(known)}
    if _is_attribute(decl):
        # Nobody has a matrix for each vertex; weights and numbers of bones are of the mesh.
        kind = builtin_type(decl.type.name)
        is_matrix = kind is not None and kind.is_matrix
        return name if is_matrix or words & _INSTANCES else ""
    return name if words & (_INSTANCES | _FIGURES) else ""
