"""A vertex shader for a fragment shader that comes alone."""

from __future__ import annotations

import re
from collections.abc import Iterator, Set
from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.diagnostics import Diagnostic, UsageError
from shadercache.emit.printer import print_node
from shadercache.front.preprocess import enabled_extensions
from shadercache.front.read_options import ReadOptions
from shadercache.front.webgl import names_version
from shadercache.lang.types import Type
from shadercache.linking.first_scene.meanings import EYES, plain
from shadercache.linking.made_parts.varying_meanings import VaryingMeaning, habits_of, meaning_of
from shadercache.sema.facts import Facts
from shadercache.source import Source, Span
from shadercache.valid.read import read

TEMPLATE = Path(__file__).with_name("made.vert")
_DECLARED = "// What the fragment shader reads is declared here.\n"
_ASSIGNED = "    // And has its value here.\n"
_OWN = re.compile(r"\b(?:a|u|made)_\w+")
# A letter in front of them is read as a prefix, which says nothing of what a name means.
_PREFIXES = ("", *(f"{letter}_" for letter in "mnkxyz"))
_FIXED = frozenset(("gl_Color", "gl_SecondaryColor", "gl_TexCoord", "gl_FogFragCoord"))
"""What vertex shaders of the fixed-function pipeline hand on."""
_PLACING = ("GL_ARB_separate_shader_objects", "GL_ARB_enhanced_layouts")


class MadeVertex(NamedTuple):
    """The text of a vertex shader, and what was guessed of varyings."""

    text: str
    notes: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class _Varying:
    """A varying that is read. ``target``: how it is assigned to."""

    target: str
    type: Type
    span: Span

    @property
    def name(self) -> str:
        return self.target.rpartition(".")[2]


def made_vertex(fragment: Source, reading: ReadOptions) -> MadeVertex:
    """A vertex shader in the version of a fragment shader, which gives it all that it reads.

    Raises:
        UsageError: SC005 for each varying of which name and type do not say what it is.
        InputError: as the compiler's front end.
    """
    module, facts = read(fragment, "fragment", reading)
    varyings = list(_varyings(module, facts))
    sees = any(_is_eye(decl, facts) for decl in module.decls)
    habits = habits_of((varying.name for varying in varyings), sees)
    known = [
        (one, None if one.name.startswith("gl_") else meaning_of(one.name, one.type, habits))
        for one in varyings
    ]
    unknown = [one for one, meaning in known if meaning is None]
    if unknown:
        raise UsageError([_problem(one, fragment) for one in unknown])
    told = [(one, meaning) for one, meaning in known if meaning is not None]
    names = frozenset(re.findall(r"\w+", fragment.text))
    template = TEMPLATE.read_text(encoding="utf-8")
    prefix = next(
        prefix
        for prefix in _PREFIXES
        if names.isdisjoint(prefix + word for word in _OWN.findall(template))
    )
    text = _OWN.sub(lambda word: prefix + word[0], template)
    if _is_modern(module):
        text = text.replace("attribute ", "in ")
    used = {varying.span for varying in varyings}
    declared = [f"{print_node(_handed_on(decl))}\n" for decl in _interface(module, used)]
    values = [f"    {one.target} = {_value(one, meaning, prefix)};\n" for one, meaning in told]
    text = text.replace(_DECLARED, "".join(declared)).replace(_ASSIGNED, "".join(values))
    return MadeVertex(
        "".join(_head(fragment, module)) + text,
        tuple(f"{one.target} is taken for {meaning.words}" for one, meaning in told),
    )


def _head(fragment: Source, module: n.Module) -> Iterator[str]:
    if names_version(fragment.text):
        yield f"#version {module.version} {module.profile or ''}".rstrip() + "\n"
    for name in _PLACING:
        if name in enabled_extensions(module):
            yield f"#extension {name} : enable\n"


def _is_modern(module: n.Module) -> bool:
    """Has its language ``in`` and ``out`` for what was ``attribute`` and ``varying``?"""
    return module.version >= (300 if module.profile == "es" else 130)


def _varyings(module: n.Module, facts: Facts) -> Iterator[_Varying]:
    """Those that are read, members of blocks one by one."""
    names = {node.name: node for node in walk(module) if isinstance(node, n.Name)}
    for name in _FIXED & names.keys():
        yield _Varying(name, facts.symbols[names[name]].type, names[name].span)
    members = {
        (node.object.name, node.name)
        for node in walk(module)
        if isinstance(node, n.Member) and isinstance(node.object, n.Name)
    }
    for decl in module.decls:
        if isinstance(decl, n.VarDecl) and decl.qualifiers.has("in", "varying"):
            for node in decl.declarators:
                if node.name in names and not node.name.startswith("gl_"):
                    yield _Varying(node.name, facts.declared[node].type, node.span)
        elif isinstance(decl, n.BlockDecl) and decl.qualifiers.has("in"):
            for node in (node for part in decl.fields for node in part.declarators):
                own = decl.instance
                if (node.name in names) if own is None else ((own, node.name) in members):
                    target = f"{own}.{node.name}" if own else node.name
                    yield _Varying(target, _field(decl, node, facts), node.span)


def _field(decl: n.BlockDecl, node: n.Declarator, facts: Facts) -> Type:
    if decl.instance is None:
        return facts.declared[node].type
    struct = facts.declared[decl].type.struct
    assert struct is not None
    return struct.fields[node.name]


def _interface(module: n.Module, used: Set[Span]) -> Iterator[n.VarDecl | n.BlockDecl]:
    """The declarations of varyings that are read, by their places."""
    for decl in module.decls:
        if isinstance(decl, n.VarDecl | n.BlockDecl):
            fields = decl.fields if isinstance(decl, n.BlockDecl) else (decl,)
            nodes = [node for part in fields for node in part.declarators]
            if any(node.span in used for node in nodes):
                yield decl


def _handed_on(decl: n.VarDecl | n.BlockDecl) -> n.VarDecl | n.BlockDecl:
    """The same as an output of the stage before."""
    words = tuple("out" if word == "in" else word for word in decl.qualifiers.words)
    return replace(decl, qualifiers=replace(decl.qualifiers, words=words))


def _is_eye(decl: n.Node, facts: Facts) -> bool:
    if isinstance(decl, n.VarDecl) and decl.qualifiers.has("uniform"):
        nodes = list(decl.declarators)
        return any(EYES.match(plain(node.name)) and _is_vec3(node, facts) for node in nodes)
    if isinstance(decl, n.BlockDecl) and decl.qualifiers.has("uniform"):
        fields = (node.name for part in decl.fields for node in part.declarators)
        return any(EYES.match(plain(name)) for name in fields)
    return False


def _is_vec3(node: n.Declarator, facts: Facts) -> bool:
    return facts.declared[node].type.rows == 3


def _value(varying: _Varying, meaning: VaryingMeaning, prefix: str) -> str:
    """A call of the function that gives it, as wide as it is."""
    call, rows = f"{prefix}made_{meaning.function}()", varying.type.rows
    if meaning.what == "color":
        return f"{call}.rgb" if rows == 3 else call
    if rows == 4 and meaning.what != "clip":
        return f"vec4({call}, {'1.0' if meaning.what == 'position' else '0.0'})"
    return call


def _problem(varying: _Varying, fragment: Source) -> Diagnostic:
    what = f"{varying.target} ({varying.type})"
    message = f"there is no vertex shader, and neither name nor type say what {what} is"
    hint = "name the vertex shader with --vert, or put it beside with the ending .vert"
    return Diagnostic("SC005", message, fragment, varying.span, hint)
