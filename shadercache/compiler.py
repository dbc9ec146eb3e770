"""The compiler: from two shader sources and a node to the programs of its variants.

The passes, in order (each in its own file):

1.  :mod:`front.parse`              text to tree
2.  :mod:`sema.check`               names and types; every error of the user is found here
3.  :mod:`transform.raise_version`  older versions, in words of the first that has what it takes
4.  :mod:`transform.unique_names`   every identifier means one thing, so the rest works by name
5.  :mod:`transform.split`          one declarator to a declaration
6.  :mod:`transform.lower_choices`  costly choices inside expressions become conditionals
7.  :mod:`sema.check`               types of the tree that the rest works on
8.  :mod:`analysis.candidates`      every node, offered or refused

and for one node, for each pass of each algorithm:

9.  :mod:`transform.specialise`     cut the node out of clones of the functions on its call path
10. :mod:`emit.assemble`            add the look-up, the store and a new ``main``
11. :mod:`transform.remove_dead`    keep what the pass's outputs need, in turns with
12. :mod:`transform.drop_parameters`
13. :mod:`transform.make_precise`   in proof mode only
14. :mod:`emit.printer`             tree to text
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from shadercache.analysis.candidates import Candidate, Candidates, find_candidates
from shadercache.analysis.cost import CostTable
from shadercache.analysis.definitions import Definitions
from shadercache.analysis.effects import EffectTable
from shadercache.analysis.groups import Group, find_groups
from shadercache.analysis.inputs import input_kinds
from shadercache.analysis.overlap import OverlapTable, Parts
from shadercache.analysis.refusals import Code
from shadercache.analysis.restrictions import check_depth, check_size, check_stages, find_color
from shadercache.ast import nodes as n
from shadercache.ast.large import allow_deep_trees
from shadercache.ast.walk import walk
from shadercache.diagnostics import Diagnostic, InputError, UsageError, input_error
from shadercache.emit import program_set
from shadercache.emit.fragment import FragmentProgram
from shadercache.emit.printer import print_node
from shadercache.emit.vertex import VertexEmitter
from shadercache.front.options import ReadOptions
from shadercache.manifest import build_manifest, original_manifest
from shadercache.options import ALGORITHMS, Mode, Options
from shadercache.sema.check import check
from shadercache.sema.facts import Facts, Stage
from shadercache.sema.read import read
from shadercache.source import Source
from shadercache.transform.lower_choices import lower_choices
from shadercache.transform.make_precise import precise_version
from shadercache.transform.names import fresh_prefix
from shadercache.transform.raise_version import Raised, StageTree, raise_versions
from shadercache.transform.split import split_declarations
from shadercache.transform.unique_names import later_keywords, make_names_unique

_INCLUDE = re.compile(r"#[ \t]*include\b")


@dataclass(frozen=True)
class Analysis:
    """A fragment shader with all its nodes, and the vertex shader where one was given."""

    fragment: Source
    vertex: Source | None
    candidates: Candidates
    program: FragmentProgram
    raised: tuple[Raised, ...]
    vertex_module: n.Module | None
    reading: ReadOptions

    @property
    def nodes(self) -> tuple[Candidate, ...]:
        """Every node, in order of call paths and source."""
        return self.candidates.nodes

    @property
    def notes(self) -> tuple[Diagnostic, ...]:
        """What became of the stages where they were of an older version."""
        return tuple(note for stage in self.raised for note in stage.notes)

    @property
    def renamed(self) -> dict[str, str]:
        """What an engine knows by another name than the user's text has: old name to new."""
        return {old: new for stage in self.raised for old, new in stage.renamed.items()}

    @property
    def reads_fixed_function(self) -> bool:
        """Does it use attributes or state that only the compatibility profile has?"""
        return any(re.match(r"gl_(?!Frag(Color|Data))", name) for name in self.renamed)

    @property
    def stands_alone(self) -> bool:
        """Could a driver be given the user's own text, or does it need what is outside of it?"""
        reading = self.reading
        texts = (self.fragment.text, self.vertex.text if self.vertex else "")
        changed = reading.defines or reading.undefined or reading.dialect != "glsl"
        return not changed and not any(_INCLUDE.search(text) for text in texts)

    @cached_property
    def groups(self) -> Mapping[Candidate, Group]:
        """Which nodes have the same value: the group of every node."""
        program = self.program
        return find_groups(
            program.module, program.facts, EffectTable(program.module), self.candidates
        )

    def on_cpu(self, node: Candidate) -> str | None:
        """What to compute on the CPU in place of a value of uniforms only (SC303), as GLSL.

        ``None`` for any other value, and where it takes more than one expression.
        """
        if node.refusal is None or node.refusal.code is not Code.UNIFORM:
            return None
        assert node.instance is not None and node.place is not None
        found = self._definitions.closed(node.instance, node.place.step, node.expr)
        return None if found is None else print_node(found)

    def parts(self, *nodes: Candidate) -> Parts:
        """What the payload pass and the shading pass cost where the nodes are cached together."""
        return self._overlaps.parts(nodes)

    @cached_property
    def input_kinds(self) -> dict[str, str]:
        """What the inputs of nodes are, by their names: see :mod:`analysis.inputs`."""
        return input_kinds(self.program.module, self.program.facts)

    @cached_property
    def _definitions(self) -> Definitions:
        program = self.program
        return Definitions(program.facts, EffectTable(program.module), self.candidates.instances)

    @cached_property
    def _overlaps(self) -> OverlapTable:
        program = self.program
        costs, table = CostTable(program.facts), EffectTable(program.module)
        return OverlapTable(self.candidates.instances, table, costs, program.color)

    @cached_property
    def _by_id(self) -> dict[str, Candidate]:
        return {node.id: node for node in self.nodes}

    def node(self, node_id: str) -> Candidate:
        """The node with this id. Raises :class:`UsageError` SC010 or SC011 if there is none."""
        found = self._by_id.get(node_id)
        if found is not None:
            return found
        hint = f"'shadercache nodes {self.fragment.name}' lists the nodes"
        stem = node_id.rpartition("-")[0]
        if any(node.id.rpartition("-")[0] == stem for node in self.nodes):
            message = (
                f"node '{node_id}' is not from this source of {self.fragment.name}: "
                "a function on its call path has changed since"
            )
            raise UsageError(Diagnostic("SC011", message, hint=hint))
        message = f"{self.fragment.name} has no node '{node_id}'"
        raise UsageError(Diagnostic("SC010", message, hint=hint))

    def require(self, node: Candidate, unprofitable: bool = False) -> None:
        """Raise :class:`InputError` with the refusal's code if the node may not be cached.

        ``unprofitable`` lets nodes pass that are refused only as cheaper than a fetch.
        """
        refusal = node.refusal
        if refusal is None or (refusal.unprofitable and unprofitable):
            return
        hint = "caching it anyway takes --unprofitable" if refusal.unprofitable else None
        message = f"'{node.text}' {refusal.sentence}"
        raise InputError(
            Diagnostic(refusal.code.code, message, self.fragment, node.expr.span, hint)
        )


@dataclass(frozen=True, slots=True)
class Emission:
    """What a rewrite yields: the texts by file name, and the manifest."""

    files: dict[str, str]
    manifest: dict[str, Any]


def analyse(
    fragment: Source, vertex: Source | None = None, reading: ReadOptions | None = None
) -> Analysis:
    """Parse, check and judge every expression of a fragment shader.

    ``reading`` holds for both shaders, but the dialect is the fragment shader's.

    Raises :class:`InputError` with every diagnostic of the first stage that finds any.
    """
    allow_deep_trees()
    reading = reading or ReadOptions()
    texts = (fragment.text, vertex.text if vertex else "")
    prefix = fresh_prefix(*texts)
    trees = [_checked(fragment, "fragment", reading)]
    check_size(trees[0].module, fragment)
    if vertex is not None:
        trees.append(_checked(vertex, "vertex", replace(reading, dialect="glsl")))
    raised = raise_versions(trees, fresh_prefix(*texts, stem="legacy"))
    module, facts = _normalise(raised[0], fragment, "fragment")
    color = find_color(module, fragment)
    printed = _printed(trees[0].module, module)
    candidates = find_candidates(module, facts, fragment, printed, EffectTable(module))
    program = FragmentProgram(raised[0].module, module, facts, candidates, color, prefix)
    vertex_module = None
    if vertex is not None:
        vertex_module, _ = _normalise(raised[1], vertex, "vertex")
        check_stages(module, fragment, vertex_module, vertex)
    return Analysis(fragment, vertex, candidates, program, tuple(raised), vertex_module, reading)


def rewrite(
    analysis: Analysis,
    node: Candidate,
    options: Options | None = None,
    algorithms: tuple[int, ...] = ALGORITHMS,
    *,
    unprofitable: bool = False,
) -> Emission:
    """The programs that cache ``node``, by the given algorithms, with their manifest.

    A node that is refused only as cheaper than a fetch is rewritten where ``unprofitable`` is set.
    Raises :class:`InputError` with the refusal's code for any other refused node, SC402 without a
    vertex shader, SC407 where an algorithm that was asked for alone cannot be used for the node,
    SC408 where a name that has to stay is a keyword in proof mode.
    """
    analysis.require(node, unprofitable)
    options = options or Options()
    _check_names(analysis, options.mode)
    programs = program_set.emit_programs(
        analysis.program, _vertex(analysis), node, options, algorithms
    )
    if not programs.variants:
        raise InputError(_unfit(analysis, node, programs))
    sources = analysis.fragment, _vertex_source(analysis)
    manifest = build_manifest(*sources, node, options, programs, analysis.renamed)
    return Emission(programs.files, manifest)


def emit_original(analysis: Analysis, mode: Mode = "plain") -> Emission:
    """The user's own shaders, printed from the tree: what variants are compared with.

    In plain mode nothing is changed but the layout; proof mode also makes every value precise.
    """
    options = Options(mode)
    _check_names(analysis, mode)
    programs = program_set.emit_original(analysis.program, _vertex(analysis), options)
    return Emission(programs.files, original_manifest(programs, options))


def _check_names(analysis: Analysis, mode: Mode) -> None:
    """Proof mode raises the version: do the names that an engine or a struct knows stay legal?"""
    stages = (
        (analysis.program.module, analysis.fragment),
        (analysis.vertex_module, analysis.vertex),
    )
    problems: list[Diagnostic] = []
    for module, source in stages if mode == "proof" else ():
        later = later_keywords(module) if module is not None else frozenset()
        for node in walk(module) if module is not None and later else ():
            name = getattr(node, "name", "")
            if name in later and isinstance(node, n.Declarator | n.BlockDecl | n.StructDef):
                assert module is not None
                version = precise_version(module)
                message = f"proof mode needs #version {version}, where '{name}' is a keyword"
                problems.append(Diagnostic("SC408", message, source, node.span))
    if problems:
        raise InputError(problems)


def _unfit(analysis: Analysis, node: Candidate, programs: program_set.ProgramSet) -> Diagnostic:
    reason = next(iter(programs.refused.values()))
    message = f"'{node.text}' cannot be cached in one pass: {reason}"
    return Diagnostic("SC407", message, analysis.fragment, node.expr.span)


def _vertex(analysis: Analysis) -> VertexEmitter:
    if analysis.vertex_module is None:
        raise input_error("SC402", "a vertex shader is needed to rewrite a shader", "give --vert")
    program = analysis.program
    parsed, module = analysis.raised[1].module, analysis.vertex_module
    return VertexEmitter(parsed, module, program.prefix, program.memo)


def _vertex_source(analysis: Analysis) -> Source:
    assert analysis.vertex is not None
    return analysis.vertex


def _checked(source: Source, stage: Stage, reading: ReadOptions) -> StageTree:
    module, facts = read(source, stage, reading, needs_main=True)
    check_depth(facts, source)
    return StageTree(module, facts, source, stage)


def _normalise(raised: Raised, source: Source, stage: Stage) -> tuple[n.Module, Facts]:
    """Passes 4 to 7: bring a checked tree into the form that the rest works on."""
    module, facts = raised.module, raised.facts
    plain = split_declarations(make_names_unique(module, facts))
    if plain is not module:
        module, facts = plain, check(plain, source, stage)
    plain = lower_choices(module, facts) if stage == "fragment" else module
    return (module, facts) if plain is module else (plain, check(plain, source, stage))


def _printed(parsed: n.Module, module: n.Module) -> dict[str, str]:
    """The text of every function and initialised global as the user wrote it, by its unique name.

    Renaming keeps the order of functions, so that they can be paired.
    """
    old = [d for d in parsed.decls if isinstance(d, n.FunctionDef)]
    new = [d for d in module.decls if isinstance(d, n.FunctionDef)]
    printed = {item.name: print_node(was) for was, item in zip(old, new, strict=True)}
    for decl in module.decls:
        if isinstance(decl, n.VarDecl):
            printed |= {i.name: print_node(i.init) for i in decl.declarators if i.init is not None}
    return printed
