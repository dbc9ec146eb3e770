"""The vertex shaders of the passes: only the varyings a pass needs, and the clip positions.

The slice of the user's shader that computes ``gl_Position`` is duplicated with a ``previous`` twin
of every uniform in it (DESIGN section 3)::

    uniform mat4 u_mvp;                         uniform mat4 u_mvp;
    in vec3 a_position;                         uniform mat4 sc_previous_u_mvp;
    void main() {                         =>    void sc_vertex() { gl_Position = u_mvp * ...; }
        gl_Position = u_mvp * ...;              void sc_previous_main() {
    }                                               sc_previous = sc_previous_u_mvp * ...;
                                                }

Attributes and textures read for the position are taken as unchanging; the manifest says so.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.walk import walk
from shadercache.emit.assemble import Shader, interface, merge
from shadercache.emit.layout import Layout
from shadercache.emit.packing import with_layouts
from shadercache.emit.runtime import load_part
from shadercache.lang.types import FLOAT, builtin_type
from shadercache.options import MappingKind
from shadercache.source import NOWHERE
from shadercache.transform.reachable import declared_names
from shadercache.transform.remove_dead import remove_dead
from shadercache.transform.rename import rename

POSITION = "gl_Position"


@dataclass(frozen=True, slots=True, eq=False)
class VertexEmitter:
    """Makes vertex shaders from the user's (checked, with unique names; ``parsed``: as written)."""

    parsed: n.Module
    module: n.Module
    prefix: str
    memo: Memo
    mapping: MappingKind = "surface"

    def for_fragment(self, fragment: Shader) -> Shader:
        """The vertex shader for a fragment shader: exactly the varyings which that one reads."""
        kept: dict[frozenset[str], Shader] = self.memo.table("vertex shaders")
        inputs = frozenset(fragment.inputs)
        found = kept.get(inputs)
        if found is None:
            found = kept[inputs] = self._for_inputs(fragment)
        return found

    def _for_inputs(self, fragment: Shader) -> Shader:
        own = {self.prefix + "current", self.prefix + "previous"}
        module = self._extended() if own.intersection(fragment.inputs) else self.module
        wanted = self._with_members(fragment.inputs)
        wanted |= {POSITION} | {name for name in _written(self.module) if name.startswith("gl_")}
        return interface(_invariant(remove_dead(module, wanted, self.memo)))

    def previous_twins(self) -> dict[str, str]:
        """The uniforms that the position depends on, and their twins for the previous frame.

        None where the previous position is not that of a vertex.
        """
        if self.mapping != "surface":
            return {}
        return {
            old: new
            for decl in self._slice().decls
            if _is_twinned_uniform(decl)
            for old, new in self._twin_names(decl).items()
        }

    def unchanging(self) -> tuple[str, ...]:
        """Attributes and textures that the previous position depends on: they must not change."""
        if self.mapping != "surface":
            return ()
        found: list[str] = []
        for decl in self._slice().decls:
            if isinstance(decl, n.VarDecl) and (
                decl.qualifiers.has("in") or _is_opaque_uniform(decl)
            ):
                found += [item.name for item in decl.declarators]
        return tuple(found)

    def inputs(self, varyings: Iterable[str]) -> frozenset[str]:
        """Uniforms, textures and attributes that the position and these varyings depend on.

        ``varyings`` are names, of blocks too.
        """
        return _inputs(self._slice((POSITION, *varyings)))

    def sources(self, varyings: Iterable[str]) -> frozenset[str]:
        """The same of the varyings alone, and the built-in inputs among them."""
        sliced = self._slice(varyings)
        builtin = {
            node.name
            for node in walk(sliced)
            if isinstance(node, n.Name) and _is_builtin_input(node.name)
        }
        return _inputs(sliced) | builtin

    def _with_members(self, names: Iterable[str]) -> set[str]:
        """Blocks meet by their block name; statements know the instance or the members."""
        wanted = set(names)
        for decl in self.module.decls:
            if isinstance(decl, n.BlockDecl) and decl.name in wanted:
                wanted.update(declared_names(decl))
        return wanted

    def _slice(self, names: Iterable[str] = (POSITION,)) -> n.Module:
        return remove_dead(self.module, self._with_members(names), self.memo)

    def _extended(self) -> n.Module:
        main = rename_function(self.module, "main", self.prefix + "vertex")
        part = load_part("vertex", Layout((FLOAT,)), self.prefix)
        variables = [d for d in part if isinstance(d, n.VarDecl)]
        functions = [d for d in part if isinstance(d, n.FunctionDef)]
        return merge(self.module, (*main.decls, *self._twins()), variables, functions)

    def _twins(self) -> list[n.Decl]:
        """The position's slice with everything in it renamed that is its own in each frame."""
        laid_out = with_layouts(self._slice().decls)
        twinned = [_unplaced(decl) for decl in laid_out if _is_twinned(decl)]
        names = {POSITION: self.prefix + "previous"}
        for decl in twinned:
            names |= self._twin_names(decl)
        return [rename(decl, names) for decl in twinned]

    def _twin_names(self, decl: n.Decl) -> dict[str, str]:
        names = {name: f"{self.prefix}previous_{name}" for name in declared_names(decl)}
        if isinstance(decl, n.BlockDecl):
            names[decl.name] = f"{self.prefix}previous_{decl.name}"
        if "main" in names:
            names["main"] = self.prefix + "vertex_previous"
        return names


_OUTPUTS = ("gl_Position", "gl_PointSize", "gl_ClipDistance", "gl_CullDistance")
_CONSTANTS = ("gl_Max", "gl_Min")


def _is_builtin_input(name: str) -> bool:
    return name.startswith("gl_") and name not in _OUTPUTS and not name.startswith(_CONSTANTS)


def _inputs(module: n.Module) -> frozenset[str]:
    """The names of what an engine gives a slice of a vertex shader."""
    return frozenset(
        name
        for decl in module.decls
        if isinstance(decl, n.VarDecl | n.BlockDecl)
        and decl.qualifiers.has("in", "uniform", "buffer")
        for name in declared_names(decl)
    )


def _is_opaque_uniform(decl: n.Decl) -> bool:
    if not isinstance(decl, n.VarDecl) or not decl.qualifiers.has("uniform"):
        return False
    kind = builtin_type(decl.type.name)
    return kind is not None and kind.is_opaque


def _is_twinned_uniform(decl: n.Decl) -> bool:
    if isinstance(decl, n.BlockDecl):
        return decl.qualifiers.has("uniform")
    return (
        isinstance(decl, n.VarDecl)
        and decl.qualifiers.has("uniform")
        and not _is_opaque_uniform(decl)
    )


def _is_twinned(decl: n.Decl) -> bool:
    """Functions, uniforms and changing globals; constants, attributes and types are shared."""
    match decl:
        case n.FunctionDef() | n.FunctionProto():
            return True
        case n.VarDecl():
            shared = decl.qualifiers.has("in", "const") or _is_opaque_uniform(decl)
            return bool(decl.declarators) and not shared
        case n.BlockDecl():
            return decl.qualifiers.has("uniform", "out")
        case _:
            return False


def _unplaced(decl: n.Decl) -> n.Decl:
    """A variable or block without its place in the interface, which its twin cannot share."""
    if not isinstance(decl, n.VarDecl | n.BlockDecl) or decl.qualifiers.layout is None:
        return decl
    layout = tuple(i for i in decl.qualifiers.layout if i.name not in ("location", "binding"))
    return replace(decl, qualifiers=replace(decl.qualifiers, layout=layout or None))


def _written(module: n.Module) -> set[str]:
    """Names at the root of any assignment: cheap and generous."""
    return {
        item.name
        for assign in walk(module)
        if isinstance(assign, n.Assign)
        for item in walk(assign.target)
        if isinstance(item, n.Name)
    }


def rename_function(module: n.Module, old: str, new: str) -> n.Module:
    """The module with one function renamed, at its definition and prototypes."""
    decls = tuple(
        rename(decl, {old: new}) if old in declared_names(decl) else decl for decl in module.decls
    )
    return replace(module, decls=decls)


def _invariant(module: n.Module) -> n.Module:
    """All passes must compute the very same position, whatever else they compute."""
    for decl in module.decls:
        if isinstance(decl, n.QualifierDecl) and POSITION in decl.names:
            return module
    mark = n.QualifierDecl(NOWHERE, n.Qualifiers(NOWHERE, ("invariant",)), (POSITION,))
    return replace(module, decls=(mark, *module.decls))
