"""Every input of a vertex shader, and how it stands to the position of the last frame.

A vertex program computes two clip positions: of this frame and of the last. What the second one is
computed from is one of three (:class:`Fate`): it has a *twin* for the last frame, or the manifest
*names* it as what must not change between frames, or the shader is *refused*. Here is the whole
list; a test holds it against the tables of the language.

========================================  =========================================================
uniforms and members of uniform blocks    twinned
globals, and outputs that are read back   twinned: computed anew from what is twinned
attributes                                twinned where they move, or named
samplers, textures, images that are read  twinned where they move, or named
storage buffers that are read             twinned where they move, or named, by the block's name
numbers of vertices, instances, draws     named (:data:`NAMED`)
atomic counters that are read             refused where they decide the position
clocks, other invocations, devices        refused where they decide the position (:data:`UNSTEADY`)
layers, viewports, views                  refused, whatever they decide (:data:`PLACES`)
memory that is written                    refused, whatever it decides
========================================  =========================================================

The fixed-function state and attributes of old are declared as uniforms and attributes
(:mod:`shadercache.transform.versions.fixed_function`): they are what these are.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from enum import Enum

from shadercache.analysis.dataflow import reached
from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import global_names
from shadercache.analysis.restrictions import READS, busy_initialisers
from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.diagnostics import Diagnostic, InputError
from shadercache.lang.builtins import Signature, overloads
from shadercache.source import Source

POSITION = "gl_Position"


class Fate(Enum):
    """What becomes of an input that decides the position."""

    TWINNED = "twinned"
    NAMED = "named"
    REFUSED = "refused"


NAMED = {
    **dict.fromkeys(("gl_VertexID", "gl_VertexIndex"), "a vertex keeps its number"),
    **dict.fromkeys(
        ("gl_InstanceID", "gl_InstanceIDARB", "gl_InstanceIndex"), "an instance keeps its number"
    ),
    **dict.fromkeys(("gl_DrawID", "gl_DrawIDARB"), "a draw keeps its number"),
    **dict.fromkeys(("gl_BaseVertex", "gl_BaseVertexARB"), "a draw keeps its first vertex"),
    **dict.fromkeys(("gl_BaseInstance", "gl_BaseInstanceARB"), "a draw keeps its first instance"),
    "gl_DepthRange": "the range of depths stays the same",
}
"""Built-in inputs that are named -> what has to hold from frame to frame."""

ATTRIBUTES = frozenset(
    (
        *("gl_Vertex", "gl_Normal", "gl_Color", "gl_SecondaryColor", "gl_FogCoord"),
        *(f"gl_MultiTexCoord{number}" for number in range(8)),
    )
)
"""Attributes of the fixed-function pipeline."""

_MATRICES = ("ModelView", "Projection", "ModelViewProjection", "Texture")
STATE = frozenset(
    (
        *(f"gl_{name}Matrix" for name in _MATRICES),
        *(f"gl_{name}MatrixInverse" for name in _MATRICES),
        *(f"gl_{name}MatrixTranspose" for name in _MATRICES),
        *(f"gl_{name}MatrixInverseTranspose" for name in _MATRICES),
        *("gl_NormalMatrix", "gl_NormalScale", "gl_ClipPlane", "gl_Point", "gl_Fog"),
        *("gl_FrontMaterial", "gl_BackMaterial", "gl_LightSource", "gl_LightModel"),
        *("gl_FrontLightModelProduct", "gl_BackLightModelProduct"),
        *("gl_FrontLightProduct", "gl_BackLightProduct", "gl_TextureEnvColor"),
        *(f"gl_{space}Plane{axis}" for space in ("Eye", "Object") for axis in "STRQ"),
    )
)
"""Uniforms of the fixed-function pipeline."""

OUTPUTS = frozenset(
    (
        *("gl_Position", "gl_PointSize", "gl_ClipDistance", "gl_CullDistance", "gl_ClipVertex"),
        *("gl_FrontColor", "gl_BackColor", "gl_FrontSecondaryColor", "gl_BackSecondaryColor"),
        *("gl_TexCoord", "gl_FogFragCoord", "gl_PrimitiveShadingRateEXT"),
    )
)
"""Built-in outputs: one that is read back has a twin."""

PLACES = {
    "gl_Layer": "a layer",
    "gl_ViewportIndex": "a viewport",
    "gl_ViewportMask": "viewports",
    "gl_ViewID_OVR": "a view",
    "gl_ViewIndex": "a view",
}
"""What chooses the part of the target that is drawn to: the caches have one part."""

PLACING_LAYOUTS = {
    "num_views": "views",
    "viewport_relative": "a layer",
    "secondary_view_offset": "a second view",
}
"""Words of layouts that do the same."""

UNSTEADY = frozenset(
    (
        *("gl_SubgroupSize", "gl_SubgroupInvocationID", "gl_DeviceIndex"),
        *(f"gl_Subgroup{word}Mask" for word in ("Eq", "Ge", "Gt", "Le", "Lt")),
    )
)
"""Built-in inputs that may be others in the next frame, or in the next pass."""

_WRITERS = ("atomic", "imageStore", "imageAtomic")


def variable_fate(name: str) -> Fate | None:
    """What becomes of a built-in variable; ``None`` for one that is not in the list."""
    if name in OUTPUTS or name in STATE:
        return Fate.TWINNED
    if name in NAMED or name in ATTRIBUTES:
        return Fate.NAMED
    return Fate.REFUSED if name in PLACES or name in UNSTEADY else None


def function_fate(signature: Signature) -> Fate | None:
    """What becomes of the value of a built-in function; ``None`` where that is what becomes of its
    arguments."""
    if not signature.memory:
        return None
    return Fate.NAMED if signature.name in READS else Fate.REFUSED


def writes_memory(name: str) -> bool:
    """Does the built-in function of that name change a counter, a buffer or an image?"""
    # Of these atomicCounter alone only reads (GLSL 4.60 section 8.10).
    return name.startswith(_WRITERS) and name != "atomicCounter"


def is_unsteady(name: str) -> bool:
    """May the built-in function of that name have another value in the next frame, or pass?"""
    return any(function_fate(signature) is Fate.REFUSED for signature in overloads(name))


def kept_numbers(names: Iterable[str]) -> Iterator[str]:
    """Sentences for a manifest: what has to hold of the named built-in inputs among ``names``."""
    kept: dict[str, list[str]] = {}
    for name in sorted(set(names) & NAMED.keys()):
        kept.setdefault(NAMED[name], []).append(name)
    for what, culprits in kept.items():
        yield f"{what} from frame to frame ({', '.join(culprits)} decides the position)"


def check_vertex(module: n.Module, source: Source) -> None:
    """Can the shader be drawn in several passes, into caches of one layer?

    Works on a module with unique names. Raises :class:`InputError`: SC460 where it never writes the
    position, SC461 where it chooses a layer, a viewport or a view, SC462 where it writes memory,
    SC424 where the initialiser of a global does something.
    """
    table = EffectTable(module)
    effects = table.summary("main")
    problems = [*_places(module, table, source), *_writers(module, table, source)]
    problems += busy_initialisers(module, source)
    if POSITION not in effects.writes:
        hint = "what is drawn without one is undefined"
        message = f"{source.name} never writes {POSITION}"
        problems.append(Diagnostic("SC460", message, source, table.functions["main"].span, hint))
    if problems:
        raise InputError(problems)


def check_position(sliced: n.Module, source: Source) -> None:
    """Is the position of the last frame what it was? ``sliced`` is what computes the position.

    Raises :class:`InputError` SC463 for an input that may be another in every frame or pass.
    """
    own = {decl.name for decl in sliced.decls if isinstance(decl, n.FunctionDef)}
    for node in walk(sliced):
        called = isinstance(node, n.Call) and node.name not in own and is_unsteady(node.name)
        if called or (isinstance(node, n.Name) and node.name in UNSTEADY):
            assert isinstance(node, n.Call | n.Name)
            message = f"{node.name} decides the position, and may be another in every frame"
            hint = "then nobody knows where a point was in the last frame"
            raise InputError(Diagnostic("SC463", message, source, node.span, hint))


def _places(module: n.Module, table: EffectTable, source: Source) -> Iterator[Diagnostic]:
    """What chooses a part of the target."""
    effects = table.summary("main")
    used = {node.name: node.span for node in _reached(table) if isinstance(node, n.Name)}
    chosen = [
        (name, PLACES[name], used[name])
        for name in sorted((effects.reads | effects.writes) & PLACES.keys())
    ]
    chosen += [
        (node.name, PLACING_LAYOUTS[node.name], node.span)
        for node in walk(module)
        if isinstance(node, n.LayoutItem) and node.name in PLACING_LAYOUTS
    ]
    for name, what, span in chosen:
        hint = "the caches have one layer, and one viewport"
        message = f"a vertex shader that chooses {what} ({name}) cannot be drawn with a cache"
        yield Diagnostic("SC461", message, source, span, hint)


def _writers(module: n.Module, table: EffectTable, source: Source) -> Iterator[Diagnostic]:
    """Buffers, images and counters that are written: passes would do it several times a frame."""
    buffers = {
        name: decl
        for decl in module.decls
        if isinstance(decl, n.BlockDecl) and decl.qualifiers.has("buffer")
        for name in global_names(decl)
    }
    written = {buffers[name] for name in table.summary("main").writes & buffers.keys()}
    culprits = [(decl.span, decl.name) for decl in written]
    culprits += [
        (node.span, node.name)
        for node in _reached(table)
        if isinstance(node, n.Call)
        and node.name not in table.functions
        and writes_memory(node.name)
        # atomicAdd on a member of a buffer is told by the name of the buffer.
        and not buffers.keys() & table.of(node).writes
    ]
    for span, name in sorted(culprits):
        message = f"a vertex shader that changes memory ({name}) cannot be drawn in several passes"
        yield Diagnostic("SC462", message, source, span)


def _reached(table: EffectTable) -> Iterator[n.Node]:
    """Every node of the functions that ``main`` leads to."""
    return (
        node for name in reached(["main"], table.callees) for node in walk(table.functions[name])
    )
