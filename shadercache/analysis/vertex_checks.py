"""What a vertex shader must be like for the values on its surfaces to be cached.

Which of its inputs are refused is written in :mod:`shadercache.analysis.vertex_inputs`.
"""

from __future__ import annotations

from collections.abc import Iterator

from shadercache.analysis.dataflow import reached
from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.restrictions import busy_initialisers
from shadercache.analysis.vertex_inputs import (
    PLACES,
    PLACING_LAYOUTS,
    UNSTEADY,
    is_unsteady,
    writes_memory,
)
from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.diagnostics import Diagnostic, InputError
from shadercache.source import Source

POSITION = "gl_Position"


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
    used = (effects.reads | effects.writes) & PLACES.keys()
    found = {node.name: node for node in _reached(table) if isinstance(node, n.Name)}
    chosen = [(name, PLACES[name], found[name].span) for name in sorted(used)]
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
        for name in _names(decl)
    }
    written = {buffers[name] for name in table.summary("main").writes & buffers.keys()}
    culprits = [(decl.name, decl.span) for decl in written]
    culprits += [
        (node.name, node.span)
        for node in _reached(table)
        if isinstance(node, n.Call)
        and node.name not in table.functions
        and writes_memory(node.name)
        and not buffers.keys() & table.of(node).writes
    ]
    for name, span in sorted(culprits, key=lambda culprit: culprit[1]):
        message = f"a vertex shader that changes memory ({name}) cannot be drawn in several passes"
        yield Diagnostic("SC462", message, source, span)


def _reached(table: EffectTable) -> Iterator[n.Node]:
    """Every node of the functions that ``main`` leads to."""
    return (
        node for name in reached(["main"], table.callees) for node in walk(table.functions[name])
    )


def _names(block: n.BlockDecl) -> list[str]:
    if block.instance is not None:
        return [block.instance]
    return [item.name for field in block.fields for item in field.declarators]
