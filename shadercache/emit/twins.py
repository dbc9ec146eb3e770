"""What of a vertex shader has a twin of its own for the position of the last frame.

What becomes of each input is in :mod:`shadercache.analysis.vertex_inputs`.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from shadercache.analysis.moving import is_texture, may_move
from shadercache.analysis.vertex_inputs import OUTPUTS
from shadercache.ast import nodes as n
from shadercache.emit.packing import with_layouts
from shadercache.front.preprocess import enabled_extensions
from shadercache.lang.builtins import MOST_ELEMENTS, variable
from shadercache.source import NOWHERE
from shadercache.transform.reachable import declared_names, names_in
from shadercache.transform.rename import rename
from shadercache.transform.versions.builtin_block import BUILTIN_BLOCK

POSITION = "gl_Position"

_PLACES = ("location", "component", "binding", "xfb_buffer", "xfb_offset", "xfb_stride")


class Twins:
    """The twins of the declarations of a slice that computes the position."""

    def __init__(
        self,
        sliced: n.Module,
        prefix: str,
        moving: frozenset[str] = frozenset(),
        bindings: Mapping[str, int] | None = None,
    ) -> None:
        """Args: ``moving``: what of :mod:`shadercache.analysis.moving` has a twin; ``bindings``:
        those of twins, by the name of what has one."""
        self._slice, self._prefix, self._moving = sliced, prefix, moving
        self._bindings = bindings or {}
        # Sorted: a set of texts has another order in each process, the emitted text has not.
        self._read_back = sorted((names_in(sliced) & OUTPUTS) - {POSITION})

    def inputs(self) -> dict[str, str]:
        """What an engine gives of the slice that has a twin for the previous frame, and that."""
        return {
            old: new
            for decl in self._slice.decls
            if _is_twinned_uniform(decl) or self._moves(decl)
            for old, new in self._names(decl).items()
        }

    def resting(self) -> Iterator[str]:
        """The attributes, textures and buffers of the slice that have none."""
        for decl in self._slice.decls:
            if may_move(decl) and not self._moves(decl):
                if isinstance(decl, n.BlockDecl):
                    yield decl.name
                else:
                    yield from declared_names(decl)

    def decls(self) -> Iterator[n.Decl]:
        """The slice with everything in it renamed that is its own in each frame."""
        laid_out = with_layouts(self._slice.decls)
        twinned = [
            self._placed(decl) for decl in laid_out if _is_twinned(decl) or self._moves(decl)
        ]
        names = {name: self._twin(name) for name in self._read_back}
        for decl in twinned:
            names |= self._names(decl)
        # The twin of the position is the varying that the look-up reads.
        names[POSITION] = self._prefix + "previous"
        yield from map(self._output, self._read_back)
        yield from (rename(decl, names) for decl in twinned)

    def _moves(self, decl: n.Decl) -> bool:
        own = (decl.name,) if isinstance(decl, n.BlockDecl) else declared_names(decl)
        return may_move(decl) and not self._moving.isdisjoint(own)

    def _placed(self, decl: n.Decl) -> n.Decl:
        """A declaration at the place of its twin, if it has a binding: a free one."""
        twin = _unplaced(decl)
        if not isinstance(decl, n.BlockDecl | n.VarDecl):
            return twin
        own = (decl.name,) if isinstance(decl, n.BlockDecl) else declared_names(decl)
        binding = next((self._bindings[name] for name in own if name in self._bindings), None)
        if binding is None:
            return twin
        assert isinstance(twin, n.BlockDecl | n.VarDecl)
        item = n.LayoutItem(NOWHERE, "binding", n.Literal(NOWHERE, str(binding)))
        layout = (item, *(twin.qualifiers.layout or ()))
        return replace(twin, qualifiers=replace(twin.qualifiers, layout=layout))

    def _twin(self, name: str) -> str:
        return twin_name(self._prefix, name)

    def _names(self, decl: n.Decl) -> dict[str, str]:
        names = {name: self._twin(name) for name in declared_names(decl)}
        if isinstance(decl, n.BlockDecl):
            names[decl.name] = self._twin(decl.name)
        if "main" in names:  # The pass has a `main` of its own, which calls both.
            names["main"] = self._prefix + "vertex_previous"
        return names

    def _output(self, name: str) -> n.VarDecl:
        """A plain global in place of a built-in output, which has one value: this frame's."""
        module = self._slice
        extensions = enabled_extensions(module)
        known = variable(name, "vertex", module.version, module.profile, extensions)
        assert known is not None, name
        dims: n.Dims = ()
        if known.type.is_array:
            dims = (self._size(name) or n.Literal(NOWHERE, str(MOST_ELEMENTS[name])),)
        twin = n.Declarator(NOWHERE, self._twin(name), dims)
        kind = n.TypeSpec(NOWHERE, known.type.name)
        return n.VarDecl(NOWHERE, n.NO_QUALIFIERS, kind, (twin,))

    def _size(self, name: str) -> n.Expr | None:
        """How long the shader says that a built-in array is."""
        sizes = (
            declarator.dims[0]
            for decl in self._slice.decls
            if isinstance(decl, n.VarDecl | n.BlockDecl) and is_builtin_output(decl)
            for field in (decl.fields if isinstance(decl, n.BlockDecl) else (decl,))
            for declarator in field.declarators
            if declarator.name == name and declarator.dims
        )
        return next(sizes, None)


def twin_name(prefix: str, name: str) -> str:
    """What the twin of a name is called."""
    return f"{prefix}previous_{name}"


def is_builtin_output(decl: n.Decl) -> bool:
    """Does it declare built-in outputs again?"""
    if isinstance(decl, n.BlockDecl):
        return decl.name == BUILTIN_BLOCK
    return isinstance(decl, n.VarDecl) and any(i.name.startswith("gl_") for i in decl.declarators)


def _is_twinned_uniform(decl: n.Decl) -> bool:
    declares = isinstance(decl, n.BlockDecl | n.VarDecl) and decl.qualifiers.has("uniform")
    return declares and not is_texture(decl)


def _is_twinned(decl: n.Decl) -> bool:
    """Functions, uniforms and changing globals; constants, attributes, buffers and types are
    shared."""
    match decl:
        case n.FunctionDef() | n.FunctionProto():
            return True
        case _ if is_builtin_output(decl):
            return False  # `_output` makes the twin of what is read back of it.
        case n.VarDecl():
            # No pass wants the twin of an output: `remove_dead` makes a global of one that is read.
            shared = decl.qualifiers.has("in", "const") or is_texture(decl)
            return bool(decl.declarators) and not shared
        case n.BlockDecl():
            return decl.qualifiers.has("uniform", "out")
        case _:
            return False


def _unplaced(decl: n.Decl) -> n.Decl:
    """A variable or block without its place in the interface, which its twin cannot share."""
    if isinstance(decl, n.BlockDecl):
        fields = decl.fields
        # Members of an output block may have locations. Those of a uniform block have offsets,
        # which stay: the engine fills both buffers alike.
        if decl.qualifiers.has("out"):
            fields = tuple(replace(f, qualifiers=_nowhere(f.qualifiers)) for f in fields)
        decl = replace(decl, fields=fields)
    if isinstance(decl, n.BlockDecl | n.VarDecl):
        return replace(decl, qualifiers=_nowhere(decl.qualifiers))
    return decl


def _nowhere(qualifiers: n.Qualifiers) -> n.Qualifiers:
    if qualifiers.layout is None:
        return qualifiers
    layout = tuple(entry for entry in qualifiers.layout if entry.name not in _PLACES)
    return replace(qualifiers, layout=layout or None)
