"""The compiler: from two shader sources and a node to the programs of its variants.

The passes, in order (each in its own file):

1.  :mod:`front.parse`: text to tree
2.  :mod:`sema.infer`: names and types; and :mod:`valid.validate`: the other rules. Every error of
    the user is found here
3.  :mod:`transform.versions`: older versions, in words of the first that has what it takes, and
    names for parameters without
4.  :mod:`transform.unique_names`: every identifier means one thing, so the rest works by name
5.  :mod:`transform.split`: one declarator to a declaration
6.  :mod:`transform.spell_lists`: ``{a, b}`` is ``vec2(a, b)``, which may stand anywhere
7.  :mod:`transform.unroll`: loops of few trips are taken apart, on request; then 4 to 6
8.  :mod:`transform.expand_compound_assignments`: ``c += x`` is ``c = c + x``, a value as well
9.  :mod:`transform.lower_ternaries`: costly choices inside expressions become conditionals
10. :mod:`sema.infer`: types of the tree that the rest works on
11. :mod:`analysis.candidates`: every node, offered or refused

and for one node or a set of them, for each pass of each algorithm:

12. :mod:`transform.specialise`: cut the nodes out of clones of the functions on their call paths
13. :mod:`emit.assemble`: add the look-up, the store and a new ``main``
14. :mod:`transform.remove_dead`: keep what the pass's outputs need, in turns with
15. :mod:`transform.drop_results`,
16. :mod:`transform.drop_parameters` and :mod:`transform.move_arguments`
17. :mod:`transform.expand_compound_assignments`: ``c += x`` again where nothing was cut out
18. :mod:`transform.proof`: what keeps a driver from rearranging, in proof mode only
19. :mod:`emit.printer`: tree to text
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Generic, TypeVar

from shadercache.analysed import Analysis, VertexStage, depends_on, unchanged_for
from shadercache.analysis.candidates import (
    Candidate,
    Origin,
    ReuseMode,
    find_candidates,
    reused_builtins,
    varyings,
)
from shadercache.analysis.costs.payload_sets import notes_on
from shadercache.analysis.effect_table import EffectTable
from shadercache.analysis.mapping import MappingKind
from shadercache.analysis.moving import is_instanced
from shadercache.analysis.restrictions import (
    check_depth,
    check_size,
    check_user_mapping,
    checked_outputs,
)
from shadercache.analysis.screen.screen_inputs import Marks, screen_marks
from shadercache.analysis.screen.screen_varyings import screen_varyings
from shadercache.analysis.stages import StageSide, aligned, match_stages
from shadercache.analysis.vertex_inputs import POSITION, check_position, check_vertex
from shadercache.ast import nodes as n
from shadercache.ast.large import allow_deep_trees
from shadercache.ast.walk import walk
from shadercache.caching.algorithms import LeftOut
from shadercache.caching.configuration import Configuration, Mode
from shadercache.caching.layout import layout_of
from shadercache.diagnostics import Diagnostic, InputError, input_error, shortened
from shadercache.emit import program_set
from shadercache.emit.builder import FragmentProgram
from shadercache.emit.depth_range import depth_warnings
from shadercache.emit.printer import print_node
from shadercache.front.read_options import ReadOptions
from shadercache.front.webgl import is_webgl
from shadercache.manifest.build import build_manifest, needed_manifest, original_manifest
from shadercache.manifest.model import Manifest, NeededManifest, OriginalManifest
from shadercache.manifest.sentences import Setting
from shadercache.sema.facts import Facts, Stage
from shadercache.sema.infer import infer
from shadercache.source import Source
from shadercache.transform.expand_compound_assignments import expand_compound_assignments
from shadercache.transform.lower_ternaries import lower_ternaries
from shadercache.transform.names import fresh_prefix
from shadercache.transform.proof.make_precise import precise_version
from shadercache.transform.remove_dead import remove_dead
from shadercache.transform.spell_lists import spell_lists
from shadercache.transform.split import split_declarations
from shadercache.transform.unique_names import later_keywords, make_names_unique
from shadercache.transform.unroll import unroll_loops
from shadercache.transform.versions.builtin_block import plain_builtin_block
from shadercache.transform.versions.name_parameters import name_parameters
from shadercache.transform.versions.raise_version import Raised, StageTree, raise_versions
from shadercache.valid.read import read

_ES_WITH_PRIMITIVES = 320
"""The version of GLSL ES whose fragments know the number of their triangle."""

_MOST_TOLD = 60
"""Characters of a value in a sentence of the manifest."""

USUAL_RANGE = (0.1, 100.0)
"""Near and far plane where no scene is known."""

__all__ = ["Analysis", "Emission", "analyse", "emit_needed", "emit_original", "rewrite"]

AManifest = TypeVar("AManifest", Manifest, OriginalManifest, NeededManifest)


@dataclass(frozen=True, slots=True)
class Emission(Generic[AManifest]):
    """What a rewrite yields: the texts by file name, the manifest, and what is to be known."""

    files: dict[str, str]
    manifest: AManifest
    notes: tuple[Diagnostic, ...] = ()


def analyse(
    fragment: Source,
    vertex: Source | None = None,
    reading: ReadOptions | None = None,
    mapping: MappingKind | None = None,
) -> Analysis:
    """Parse, check and judge every expression of a fragment shader.

    ``reading`` holds for both shaders, but the dialect is the fragment shader's. Without a
    ``mapping`` it is ``surface``, or ``screen`` for a shader without varyings that comes without a
    vertex shader or is a Shadertoy.

    Raises :class:`InputError` with every diagnostic of the first stage that finds any.
    """
    allow_deep_trees()
    reading = _read_alike(fragment, vertex, reading or ReadOptions())
    # From the raw texts, before the preprocessor, so that no name inside a macro is missed.
    prefix = fresh_prefix(fragment.text, vertex.text if vertex else "")
    trees, raised = _raised(fragment, vertex, reading, prefix)
    named = _named(raised[0].module, raised[0].facts, fragment, "fragment")
    module, facts = _lowered(*named, fragment)
    # What variants are compared with keeps its loops.
    original, kept_loops = module, tuple[Diagnostic, ...]()
    if reading.unroll:
        unrolled = unroll_loops(*named, fragment)
        kept_loops = unrolled.notes
        if unrolled.module is not named[0]:
            # Copies of a loop's body declare the same names again, and later passes work by name.
            flat = infer(unrolled.module, fragment)
            module, facts = _lowered(*_named(unrolled.module, flat, fragment, "fragment"), fragment)
    outputs = checked_outputs(module, facts, fragment)
    # Ids of nodes hash the text as it was parsed, so that no later pass can change them.
    printed = _printed(trees[0].module, module)
    if mapping is None:
        solid = vertex is not None and reading.dialect != "shadertoy"
        mapping = "surface" if solid or varyings(module) else "screen"
    side = StageSide(module, facts, fragment)
    stage = None if vertex is None else _vertex_stage(raised[1], vertex, side, mapping)
    table = EffectTable(module, marks=_marks(side, mapping, stage))
    if mapping == "user":
        check_user_mapping(module, fragment, table)
    how = ReuseMode(mapping, reading.approximate)
    candidates = find_candidates(module, facts, table, Origin(fragment, printed), how)
    instanced = stage is not None and is_instanced(stage.module, reading)
    program = FragmentProgram(
        raised[0].module, module, facts, candidates, outputs, prefix, original, mapping, instanced
    )
    return Analysis(fragment, vertex, candidates, program, raised, stage, reading, kept_loops)


def _read_alike(fragment: Source, vertex: Source | None, reading: ReadOptions) -> ReadOptions:
    """Where one stage is WebGL's, both are: a program has one version of GLSL ES."""
    if vertex is None:
        return reading
    # A host such as Shadertoy's declares things around fragment shaders only.
    stages = (fragment, reading), (vertex, reading.of_vertex)
    return replace(reading, webgl=is_webgl(stages))


def _raised(
    fragment: Source, vertex: Source | None, reading: ReadOptions, prefix: str
) -> tuple[list[StageTree], tuple[Raised, ...]]:
    """Passes 1 to 3: both stages as they were checked, and in versions to write variants in."""
    trees = [_checked(fragment, "fragment", reading)]
    check_size(trees[0].module, fragment)
    if vertex is not None:
        trees.append(_checked(vertex, "vertex", reading.of_vertex))
    stem = fresh_prefix(*(tree.source.text for tree in trees), stem="legacy")
    stages: list[Raised] = []
    for raised, tree in zip(raise_versions(trees, stem), trees, strict=True):
        # GLSL lets parameters go without names, and Mesa does not.
        module = name_parameters(raised.module, prefix)
        if module is not raised.module:
            facts = infer(module, tree.source, tree.stage)
            raised = replace(raised, module=module, facts=facts)
        stages.append(raised)
    return trees, tuple(stages)


def _vertex_stage(
    raised: Raised, source: Source, fragment: StageSide, mapping: MappingKind
) -> VertexStage:
    side = StageSide(*_named(raised.module, raised.facts, source, "vertex"), source)
    check_vertex(side.module, source)
    pairs = match_stages(fragment, side)
    # Whatever else it computes, only what decides the position is evaluated twice.
    if mapping == "surface":
        check_position(remove_dead(side.module, (POSITION,)), source)
    screen = screen_varyings(side.module, side.facts)
    return VertexStage(aligned(side, fragment), side.facts, pairs, screen)


def _marks(fragment: StageSide, mapping: MappingKind, vertex: VertexStage | None) -> Marks:
    """What binds values to the screen; nothing where the place on the screen is no obstacle."""
    if "gl_FragCoord" in reused_builtins(fragment.module, mapping):
        return {}
    if vertex is None:
        return screen_marks(fragment.module, fragment.facts)
    return screen_marks(fragment.module, fragment.facts, vertex.pairs, vertex.screen)


def rewrite(
    analysis: Analysis,
    configurations: Configuration | Sequence[Configuration],
    *,
    unprofitable: bool = False,
    left_out: LeftOut | None = None,
) -> Emission[Manifest]:
    """The programs of configurations that differ in their algorithm alone, with their manifest.

    Several nodes share the cache's texels, the look-up and the refresh. ``unprofitable``: may nodes
    be cached that are refused only as cheaper than a fetch? ``left_out``: what two passes do
    without, for a profile.

    Raises:
        UsageError: SC010 to SC012 for an id that is not that of one node.
        InputError: the refusal's code for a node, SC415 to SC417 for a set; SC402 without a vertex
            shader; SC407 where no algorithm fits; SC408 for names that become keywords; SC419,
            SC430, SC432, SC440, SC443 for choices that do not go with the shader.
    """
    wanted = (
        (configurations,) if isinstance(configurations, Configuration) else tuple(configurations)
    )
    chosen = wanted[0]
    nodes = analysis.nodes_of("+".join(chosen.nodes))
    analysis.require_all(nodes, unprofitable)
    _check_names(analysis, chosen.mode, chosen.fetches == "level")
    _check_schedule(analysis, chosen)
    _check_filter(analysis, chosen)
    _check_room(analysis, nodes, chosen)
    program, vertex = analysis.program, analysis.vertex_emitter
    programs = program_set.emit_programs(program, vertex, nodes, wanted, left_out)
    if not programs.variants:
        # What is wrong with the value tells more than what an algorithm never does.
        name, reason = min(programs.refused.items(), key=lambda one: one[1] == program_set.NO_RATE)
        texts = " and ".join(f"'{node.text}'" for node in nodes)
        message = f"{texts} cannot be cached by {name}: {reason}"
        raise InputError(Diagnostic("SC407", message, analysis.fragment, nodes[0].expr.span))
    setting = Setting(
        analysis.fragment,
        analysis.vertex_source,
        analysis.mapping,
        analysis.full_screen,
        analysis.inputs,
        depends_on(analysis, nodes),
        unchanged_for(analysis, nodes),
        analysis.renamed,
        tuple(shortened(node.text, _MOST_TOLD) for node in nodes if node.approximate),
    )
    manifest = build_manifest(nodes, chosen, programs, setting)
    notes = notes_on(nodes, analysis.fragment)
    if chosen.storage.depth == "ndc":  # of other depths it depends on the scene
        notes += depth_warnings(chosen, *USUAL_RANGE)
    return Emission(programs.files, manifest, notes)


def emit_original(analysis: Analysis, mode: Mode = "plain") -> Emission[OriginalManifest]:
    """The user's own shaders, printed from the tree: what variants are compared with.

    In plain mode nothing is changed but the layout; proof mode also makes every value precise.
    """
    _check_names(analysis, mode)
    programs = program_set.emit_original(analysis.program, analysis.vertex_emitter, mode)
    return Emission(programs.files, original_manifest(programs, mode, analysis.inputs))


def emit_needed(analysis: Analysis, configuration: Configuration) -> Emission[NeededManifest]:
    """The program that tells which pixels have payloads of the nodes, and which of them are fit.

    It is part of no variant: who counts hits needs it to know how many there must be.
    """
    nodes = analysis.nodes_of("+".join(configuration.nodes))
    program, vertex = analysis.program, analysis.vertex_emitter
    programs = program_set.emit_needed(program, vertex, nodes, configuration)
    manifest = needed_manifest(programs, configuration.mode, analysis.inputs)
    return Emission(programs.files, manifest)


def _check_names(analysis: Analysis, mode: Mode, queries: bool = False) -> None:
    """Proof mode raises the version, and so do queries of levels of detail (``queries``): do the
    names that an engine or a struct knows stay legal?"""
    fragment = analysis.program.module
    if queries and fragment.profile == "es":
        message = "--fetches level needs textureQueryLod, which GLSL ES has not"
        raise input_error("SC419", message, "take --fetches whole")
    stages: list[tuple[n.Module, Source]] = []
    if mode == "proof" or queries:
        stages.append((fragment, analysis.fragment))
    # Queries stand in fragment shaders alone, and the stages of desktop GLSL may differ in version.
    if mode == "proof" and analysis.stage is not None and analysis.vertex is not None:
        stages.append((analysis.stage.module, analysis.vertex))
    problems: list[Diagnostic] = []
    for module, source in stages:
        later = later_keywords(module)
        # An engine knows variables and blocks by their names, so these cannot be renamed.
        for node in walk(module) if later else ():
            name = getattr(node, "name", "")
            if name in later and isinstance(node, n.Declarator | n.BlockDecl | n.StructDef):
                what = "proof mode needs" if mode == "proof" else "--fetches level needs"
                message = f"{what} #version {precise_version(module)}, where '{name}' is a keyword"
                problems.append(Diagnostic("SC408", message, source, node.span))
    if problems:
        raise InputError(problems)


def _check_schedule(analysis: Analysis, configuration: Configuration) -> None:
    """SC440: is there a surface, with triangles that have numbers, to refresh by?"""
    if configuration.refresh.schedule != "surface":
        return
    fragment = analysis.program.module
    if analysis.mapping != "surface":
        message = "refresh=surface goes by triangles, and there is none but the whole picture"
    elif fragment.profile == "es" and fragment.version < _ES_WITH_PRIMITIVES:
        message = "refresh=surface needs gl_PrimitiveID, which GLSL ES has from 3.20 on"
    else:
        return
    raise input_error("SC440", message, "take --cache refresh=stratified")


def _check_filter(analysis: Analysis, configuration: Configuration) -> None:
    """SC443: does anything move that samples could be carried along?"""
    if configuration.filter.carries and analysis.mapping == "screen":
        message = "filter=carried keeps where samples lie, and with mapping=screen nothing moves"
        raise input_error("SC443", message, "leave the filter out")


def _check_room(
    analysis: Analysis, nodes: Sequence[Candidate], configuration: Configuration
) -> None:
    """SC430: does what is kept beside the payload fit into the two texels?"""
    if configuration.storage.depth == "ndc" and configuration.filter.marks_depths:
        message = (
            "the filter marks texels by the sign of their depth, which depths from -1 to 1 use"
        )
        raise input_error("SC432", message, "take filter=bilinear or another depth")
    layout = layout_of(tuple(node.type for node in nodes), configuration)
    if layout.fits:
        return
    kept = " and ".join(extra.name for extra in layout.extras)
    # Two texels have eight channels, and the depth takes one.
    message = f"the cache has no channel left for the {kept}: the payload takes {layout.used} of 7"
    hint = "choose a smaller value, or leave the option out"
    raise InputError(Diagnostic("SC430", message, analysis.fragment, nodes[0].expr.span, hint))


def _checked(source: Source, stage: Stage, reading: ReadOptions) -> StageTree:
    module, facts = read(source, stage, reading, needs_main=True)
    check_depth(facts, source)
    plain = plain_builtin_block(module, facts)
    # Facts are keyed by node, so a tree that changed is gone through again.
    if plain is not module:
        module, facts = plain, infer(plain, source, stage)
    return StageTree(module, facts, source, stage)


def _named(module: n.Module, facts: Facts, source: Source, stage: Stage) -> tuple[n.Module, Facts]:
    """Passes 4 to 6: everything in a checked tree has a name and a declaration of its own, and
    every value may stand anywhere."""
    plain = split_declarations(make_names_unique(module, facts))
    if plain is not module:
        facts = infer(plain, source, stage)
    spelled = spell_lists(plain, facts)
    return (plain, facts) if spelled is plain else (spelled, infer(spelled, source, stage))


def _lowered(module: n.Module, facts: Facts, source: Source) -> tuple[n.Module, Facts]:
    """Passes 8 to 10: bring a fragment shader into the form that the rest works on."""
    plain = lower_ternaries(expand_compound_assignments(module, facts), facts)
    return (module, facts) if plain is module else (plain, infer(plain, source))


def _printed(parsed: n.Module, module: n.Module) -> dict[str, str]:
    """The text of every function and initialised global as the user wrote it, by its unique name.

    Renaming keeps the order of functions, so that they can be paired.
    """
    old = [d for d in parsed.decls if isinstance(d, n.FunctionDef)]
    new = [d for d in module.decls if isinstance(d, n.FunctionDef)]
    printed = {named.name: print_node(was) for was, named in zip(old, new, strict=True)}
    for decl in module.decls:
        if isinstance(decl, n.VarDecl):
            printed |= {i.name: print_node(i.init) for i in decl.declarators if i.init is not None}
    return printed
