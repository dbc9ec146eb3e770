"""What a whole shader must be like for any of its values to be cached."""

from __future__ import annotations

from collections.abc import Iterator

from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.effects import NO_EFFECTS, Does, global_names
from shadercache.analysis.mapping import CURRENT_CLIP, PREVIOUS_CLIP
from shadercache.analysis.moving import is_texture
from shadercache.analysis.outputs import Output, outputs_of
from shadercache.analysis.reaching_definitions import written_anywhere
from shadercache.ast import nodes as n
from shadercache.ast.walk import EXPRESSIONS, walk
from shadercache.diagnostics import Diagnostic, InputError
from shadercache.lang.builtins import overloads
from shadercache.sema.facts import Facts
from shadercache.source import Source

MAX_EXPRESSIONS = 100_000
"""Expressions of a shader that is analysed. (The largest of 14,000 public ones has 63,000.)"""

MAX_PAIRS = 50_000_000
"""Expressions times names: so much may have to be noted of what depends on what."""

MAX_DEPTH = 500
"""Functions that may call one another in a row."""

_LAYOUTS = {
    "early_fragment_tests": ("SC405", "its first pass discards"),
    **dict.fromkeys(
        ("origin_upper_left", "pixel_center_integer"),
        ("SC422", "variants find texels by gl_FragCoord as it is without"),
    ),
}
# gl_FragColor and gl_FragData may not be written beside declared outputs, and the cache is one
# (GLSL 3.30 section 7.2). The passes agree on depth to the bit only where the rasteriser makes it.
_BUILTIN_OUTPUTS = ("gl_FragColor", "gl_FragData", "gl_FragDepth", "gl_SampleMask")


READS = frozenset(("imageLoad", "sparseImageLoadARB"))
"""Functions that read memory and leave it as it is."""


def check_size(module: n.Module, source: Source) -> None:
    """Refuse a shader that would take minutes or all memory: :class:`InputError` SC401."""
    count = 0
    names: set[str] = set()
    for node in walk(module):
        count += isinstance(node, EXPRESSIONS)
        if isinstance(node, n.Name):
            names.add(node.name)
    if count > MAX_EXPRESSIONS or count * len(names) > MAX_PAIRS:
        message = f"{source.name} is too long to analyse: {count} expressions, {len(names)} names"
        hint = f"at most {MAX_EXPRESSIONS} expressions, fewer with more than 500 names"
        raise InputError(Diagnostic("SC401", message, hint=hint))


def check_depth(facts: Facts, source: Source) -> None:
    """Refuse calls that are nested deeper than this compiler's: :class:`InputError` SC401."""
    # Level by level, each call once in a level: the paths through them may be exponentially many.
    level = {call for calls in facts.called.values() for call in calls}
    for _ in range(MAX_DEPTH):
        called = {facts.calls[call] for call in level}
        level = {
            call
            for function in called
            if isinstance(function, n.FunctionDef)
            for call in facts.called[function]
        }
        if not level:
            return
    message = f"more than {MAX_DEPTH} functions call one another in a row"
    span = min(call.span for call in level)
    raise InputError(Diagnostic("SC401", message, source, span))


def checked_outputs(module: n.Module, facts: Facts, source: Source) -> tuple[Output, ...]:
    """The outputs of a fragment shader that has nothing which no variant could keep.

    Raises :class:`InputError` where the shader writes a built-in output (SC404), asks for early
    fragment tests (SC405: the first pass must not write depth for a fragment that it discards),
    writes memory or uses what others write (SC413), counts pixels in another way (SC422), or does
    something in the initialiser of a global (SC424); and as :func:`outputs_of`.
    """
    problems = [*_unsupported(module, source), *busy_initialisers(module, source)]
    if problems:
        raise InputError(problems)
    return outputs_of(module, facts, source)


def _unsupported(module: n.Module, source: Source) -> Iterator[Diagnostic]:
    own = {decl.name for decl in module.decls if isinstance(decl, n.FunctionDef)}
    written = EffectTable(module).summary("main").writes
    for node in walk(module):
        shared = _shares_memory(node, own, written)
        if shared:
            message = f"a shader that {shared} cannot be cached"
            yield Diagnostic("SC413", message, source, node.span)
        if isinstance(node, n.Name) and node.name in _BUILTIN_OUTPUTS:
            message = f"a shader that writes {node.name} cannot be cached"
            yield Diagnostic("SC404", message, source, node.span)
        elif isinstance(node, n.LayoutItem) and node.name in _LAYOUTS:
            code, why = _LAYOUTS[node.name]
            message = f"a shader with {node.name} cannot be cached: {why}"
            yield Diagnostic(code, message, source, node.span)


def busy_initialisers(module: n.Module, source: Source) -> Iterator[Diagnostic]:
    """SC424: initialisers that do more than give a value; a pass without the global would not."""
    table = EffectTable(module)
    for decl in module.decls:
        if not isinstance(decl, n.VarDecl):
            continue
        for variable in decl.declarators:
            effects = table.of(variable.init) if variable.init is not None else NO_EFFECTS
            if effects.writes or effects.does & Does.DISCARD:
                does = f"the initialiser of '{variable.name}' changes a global or discards"
                message = f"{does}, so that the shader cannot be cached"
                yield Diagnostic("SC424", message, source, variable.span, "main may begin with it")


def _shares_memory(node: n.Node, own: set[str], written: frozenset[str]) -> str:
    """What it does with memory that other fragments, or a second evaluation, may change or miss;
    nothing of what only reads. ``written``: the globals that the shader changes."""
    match node:
        case n.BlockDecl() if node.qualifiers.has("buffer"):
            if not written.isdisjoint(global_names(node)):
                return f"writes the buffer {node.name}"
            return _unsteady(node.qualifiers, node.name)
        case n.VarDecl() if is_texture(node):
            return _unsteady(node.qualifiers, node.declarators[0].name)
        case n.Name(name=name) if name.startswith("gl_Subgroup"):
            return "asks other invocations"
        case n.Call(name=name) if name not in own and name not in READS:
            if any(signature.memory for signature in overloads(name)):
                return f"changes memory or asks other invocations ({name})"
    return ""


def _unsteady(qualifiers: n.Qualifiers, name: str) -> str:
    shared = qualifiers.has("coherent", "volatile")
    return f"shares the memory of {name} while it runs" if shared else ""


def check_user_mapping(module: n.Module, source: Source, table: EffectTable) -> None:
    """Can the look-up call the functions by which the user says where a pixel's content was?

    It calls ``vec4 scPreviousClip()`` and, if it is there, ``vec4 scCurrentClip()`` before anything
    else of the shader has run, and in fragments that may go different ways. So they see no global
    variable that the shader changes, change none themselves, and take no derivative.

    Works on a module with unique names. Raises :class:`InputError`: SC420 for a function that is
    missing or of another type, SC421 for one that does what it must not.
    """
    functions = {d.name: d for d in module.decls if isinstance(d, n.FunctionDef)}
    problems: list[Diagnostic] = []
    if PREVIOUS_CLIP not in functions:
        message = f"the mapping 'user' needs a function 'vec4 {PREVIOUS_CLIP}()' in the shader"
        hint = "it returns the clip-space position, in the last frame, of what the pixel shows now"
        problems.append(Diagnostic("SC420", message, source, hint=hint))
    written = written_anywhere(module, table)
    for name in (PREVIOUS_CLIP, CURRENT_CLIP):
        if name in functions:
            problems += _mapping_problems(functions[name], source, table, written)
    if problems:
        raise InputError(problems)


def _mapping_problems(
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
