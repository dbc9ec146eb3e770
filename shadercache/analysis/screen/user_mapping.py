"""The functions by which the user says where a pixel's content was in the previous frame.

``vec4 scPreviousClip()`` and, if it is there, ``vec4 scCurrentClip()`` are called by the look-up,
before anything else of the shader has run and in fragments that may go different ways. So they see
no global variable that the shader changes, change none themselves, and take no derivative.
"""

from __future__ import annotations

from collections.abc import Iterator

from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import Does
from shadercache.analysis.mapping import CURRENT_CLIP, PREVIOUS_CLIP
from shadercache.analysis.reaching_definitions import written_anywhere
from shadercache.ast import nodes as n
from shadercache.diagnostics import Diagnostic, InputError
from shadercache.source import Source


def check_user_mapping(module: n.Module, source: Source, table: EffectTable) -> None:
    """Can the look-up call the functions? Works on a module with unique names.

    Raises :class:`InputError`: SC420 for a function that is missing or of another type, SC421 for
    one that does what it must not.
    """
    found = {d.name: d for d in module.decls if isinstance(d, n.FunctionDef)}
    problems: list[Diagnostic] = []
    if PREVIOUS_CLIP not in found:
        message = f"the mapping 'user' needs a function 'vec4 {PREVIOUS_CLIP}()' in the shader"
        hint = "it returns the clip-space position, in the last frame, of what the pixel shows now"
        problems.append(Diagnostic("SC420", message, source, hint=hint))
    written = written_anywhere(module, table)
    for name in (PREVIOUS_CLIP, CURRENT_CLIP):
        if name in found:
            problems += _problems(found[name], source, table, written)
    if problems:
        raise InputError(problems)


def _problems(
    function: n.FunctionDef, source: Source, table: EffectTable, written: frozenset[str]
) -> Iterator[Diagnostic]:
    proto = function.proto
    span, name = proto.span, proto.name
    if proto.params or proto.type.name != "vec4" or proto.type.dims:
        message = f"'{name}' has to be declared as 'vec4 {name}()', and only once"
        yield Diagnostic("SC420", message, source, span)
        return
    effects = table.summary(name)
    changed = sorted(effects.reads & written)
    if changed:
        message = f"'{name}' reads what the shader changes: {', '.join(changed)}"
        hint = "it is called before 'main' has run: let it compute what it needs"
        yield Diagnostic("SC421", message, source, span, hint)
    if effects.writes:
        message = f"'{name}' changes global variables: {', '.join(sorted(effects.writes))}"
        yield Diagnostic("SC421", message, source, span)
    if effects.does & (Does.DERIVATIVE | Does.IMPLICIT_LOD):
        message = f"'{name}' takes a derivative, or fetches a texture with implicit level of detail"
        hint = "'textureLod' and 'texelFetch' need none"
        yield Diagnostic("SC421", message, source, span, hint)
    if effects.does & Does.DISCARD:
        yield Diagnostic("SC421", f"'{name}' discards the fragment", source, span)
