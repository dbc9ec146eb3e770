"""The vertex shaders of the passes: only the varyings a pass needs, and the clip positions.

The slice of the user's shader that computes ``gl_Position`` is duplicated with a ``previous`` twin
of every uniform in it::

    uniform mat4 u_mvp;                         uniform mat4 u_mvp;
    in vec3 a_position;                         uniform mat4 sc_previous_u_mvp;
    void main() {                         =>    void sc_vertex() { gl_Position = u_mvp * ...; }
        gl_Position = u_mvp * ...;              void sc_previous_main() {
    }                                               sc_previous = sc_previous_u_mvp * ...;
                                                }

So has an attribute, a texture or a storage buffer that moves (:mod:`shadercache.analysis.moving`).
Others, and the numbers of instances, must not change where they decide the position; the manifest
says so (:mod:`shadercache.analysis.vertex_inputs`).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace

from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.mapping import MappingKind
from shadercache.analysis.stages import Links
from shadercache.analysis.vertex_inputs import OUTPUTS, kept_numbers, variable_fate
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.emit.assemble import Shader, interface, merge
from shadercache.emit.runtime import vertex_part
from shadercache.emit.twins import POSITION, Twins, is_builtin_output
from shadercache.emit.vulkan import VulkanPlaces
from shadercache.source import NOWHERE
from shadercache.transform.reachable import declared_names, names_in
from shadercache.transform.remove_dead import remove_dead
from shadercache.transform.rename import rename


@dataclass(frozen=True, slots=True)
class LastFrame:
    """What the position of the last frame is computed from.

    ``twins``: what moves, and what holds the last frame's; ``bindings`` of these, by the name of
    what moves. ``moving``: those that are no uniforms. ``unchanging``: attributes, textures, images
    and storage buffers that must not change. ``numbers``: what has to hold of built-in inputs.
    """

    twins: Mapping[str, str] = field(default_factory=dict)
    bindings: Mapping[str, int] = field(default_factory=dict)
    moving: frozenset[str] = frozenset()
    unchanging: tuple[str, ...] = ()
    numbers: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class VertexEmitter:
    """Makes vertex shaders from the user's (checked, with unique names; ``parsed``: as written).

    ``links`` leads from names of the fragment shader to the outputs that they get their values
    from, where these are called otherwise. ``moving`` are attributes, textures and buffers that
    have twins, ``bindings`` those of twins. ``vulkan``: the places in Vulkan GLSL.
    """

    parsed: n.Module
    module: n.Module
    prefix: str
    memo: Memo
    mapping: MappingKind = "surface"
    links: Links = field(default_factory=dict)
    moving: frozenset[str] = frozenset()
    bindings: Mapping[str, int] = field(default_factory=dict)
    vulkan: VulkanPlaces | None = None

    def for_fragment(self, fragment: Shader) -> Shader:
        """The vertex shader for a fragment shader: exactly the varyings which that one reads."""
        kept: dict[frozenset[str], Shader] = self.memo.table("vertex shaders")
        inputs = frozenset(fragment.inputs)
        if inputs not in kept:
            kept[inputs] = self._for_inputs(inputs)
        return kept[inputs]

    def _for_inputs(self, inputs: frozenset[str]) -> Shader:
        # Only a pass that looks up needs the position of the last frame; only one that looks up or
        # stores payloads of an instance needs its number.
        own = {self.prefix + word for word in ("current", "previous", "object")} & inputs
        module = self._extended() if own else self.module
        written = EffectTable(self.module, self.memo).summary("main").writes
        # What is drawn depends on other built-in outputs too: point sizes, clip distances.
        wanted = self._outputs(inputs)
        wanted |= {POSITION} | {name for name in written if name.startswith("gl_")}
        needed = remove_dead(module, wanted, self.memo)
        # Undefined, the position of the last frame would be a cache without hits.
        computed = EffectTable(needed, self.memo).summary("main").writes
        assert own <= computed, "a vertex program without the position of the last frame"
        return interface(_invariant(needed))

    def last_frame(self) -> LastFrame:
        """What the position of the last frame is computed from; nothing where that is not a
        vertex's."""
        if self.mapping != "surface":
            return LastFrame()
        sliced, twins = self._slice(), self._twins()
        numbers = tuple(kept_numbers(names_in(sliced)))
        resting = tuple(twins.resting())
        return LastFrame(twins.inputs(), self.bindings, self.moving, resting, numbers)

    def inputs(self, varyings: Iterable[str]) -> frozenset[str]:
        """Uniforms, textures, buffers and attributes that the position and these varyings need.

        ``varyings`` are names, of blocks too.
        """
        return _inputs(self._slice((POSITION, *varyings)))

    def sources(self, varyings: Iterable[str]) -> frozenset[str]:
        """The same of the varyings alone, and the built-in inputs among them."""
        sliced = self._slice(varyings)
        builtins = (name for name in names_in(sliced) if variable_fate(name) is not None)
        return _inputs(sliced).union(name for name in builtins if name not in OUTPUTS)

    def _outputs(self, inputs: Iterable[str]) -> set[str]:
        """What the vertex shader calls what the fragment shader reads."""
        wanted = {out for name in inputs for out in self.links.get(name, (name,))}
        for decl in self.module.decls:
            if isinstance(decl, n.BlockDecl) and decl.name in wanted:
                # Blocks meet by their block name; statements know the instance or the members.
                wanted.update(declared_names(decl))
        return wanted

    def _slice(self, names: Iterable[str] = (POSITION,)) -> n.Module:
        return remove_dead(self.module, self._outputs(names), self.memo)

    def _extended(self) -> n.Module:
        """The shader with its ``main`` as a function of the runtime's, and its twins."""
        names = {"main": self.prefix + "vertex"}
        user = (
            rename(decl, names) if "main" in declared_names(decl) else decl
            for decl in self.module.decls
        )
        twins = self._twins().decls()
        return merge(self.module, (*user, *twins), vertex_part(self.prefix))

    def _twins(self) -> Twins:
        return Twins(self._slice(), self.prefix, self.moving, self.bindings)


def _inputs(module: n.Module) -> frozenset[str]:
    """The names of what an engine gives a slice of a vertex shader."""
    return frozenset(
        name
        for decl in module.decls
        if isinstance(decl, n.VarDecl | n.BlockDecl)
        and decl.qualifiers.has("in", "uniform", "buffer")
        for name in declared_names(decl)
    )


def _invariant(module: n.Module) -> n.Module:
    """The module with its position declared invariant: passes compare depths bit by bit."""
    # GLSL 4.60 section 4.8.1: before any use, so first, but behind what declares the position anew.
    at = 0
    for place, decl in enumerate(module.decls, 1):
        if isinstance(decl, n.QualifierDecl) and POSITION in decl.names:
            if decl.qualifiers.has("invariant"):
                return module
        elif is_builtin_output(decl) and POSITION in declared_names(decl):
            at = place
    mark = n.QualifierDecl(NOWHERE, n.Qualifiers(NOWHERE, ("invariant",)), (POSITION,))
    return replace(module, decls=(*module.decls[:at], mark, *module.decls[at:]))
