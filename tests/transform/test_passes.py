"""Each pass on its own, on the shaders of ``cases/``: what goes in, what comes out.

A file of cases (:mod:`tests.pairs`) is named after its pass.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import pytest
from conftest import Golden
from pairs import Case, anew
from verify_tree import verify_module

from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.walk import walk
from shadercache.emit.printer import print_module, print_node
from shadercache.emit.runtime import whole_picture
from shadercache.front.parse import parse
from shadercache.sema.facts import Facts, Stage
from shadercache.source import Source
from shadercache.transform.drop_parameters import drop_parameters
from shadercache.transform.drop_results import drop_results
from shadercache.transform.expand_compound_assignments import contract, expand_compound_assignments
from shadercache.transform.guard_loops import guard_loops
from shadercache.transform.lower_ternaries import lower_ternaries
from shadercache.transform.names import FreshNames, fresh_prefix
from shadercache.transform.proof.make_precise import make_precise
from shadercache.transform.proof.opaque_arguments import make_arguments_opaque
from shadercache.transform.proof.opaque_varyings import hide_uniform_varyings
from shadercache.transform.proof.rewrite_do_loops import rewrite_do_loops
from shadercache.transform.proof.write_out_matrices import write_out_matrices
from shadercache.transform.remove_dead import remove_dead
from shadercache.transform.rename import rename
from shadercache.transform.scale_coordinates import scale_coordinates
from shadercache.transform.specialise import Cut, CutKind, insert_clones, specialise
from shadercache.transform.spell_lists import spell_lists
from shadercache.transform.split import split_declarations
from shadercache.transform.unique_names import make_names_unique
from shadercache.transform.unroll import unroll_loops
from shadercache.transform.versions.builtin_block import plain_builtin_block
from shadercache.transform.versions.leave_discarded import leave_discarded
from shadercache.transform.versions.name_parameters import name_parameters
from shadercache.transform.versions.raise_version import StageTree, raise_versions
from shadercache.valid.validate import validate

CASES = Path(__file__).with_name("cases")

About = Sequence[tuple[str, str]]
"""What a pass is to know: words and what is said of them."""

Pass = Callable[[n.Module, Facts, About], n.Module]


def _words(about: About, default: str = "") -> tuple[str, ...]:
    return tuple(word for _, text in about or [("", default)] for word in text.split())


def _proof(pass_: Callable[[n.Module, str, Stage, Memo], n.Module]) -> Pass:
    return lambda module, facts, about: pass_(module, "sc_", "fragment", Memo())


def _specialised(module: n.Module, facts: Facts, about: About) -> n.Module:
    """Each cut is of a kind, and leads by calls to an expression."""
    cuts: list[Cut] = []
    for kind, text in about:
        *path, last = text.split(" > ")
        scope = "main"
        calls: list[n.Call] = []
        for shown in path:
            call = _find(module, scope, shown)
            assert isinstance(call, n.Call)
            calls.append(call)
            scope = call.name
        number = f"_{len(cuts) + 1}" if len(about) > 1 else ""
        names = f"sc_payload{number}", f"sc_valid{number}"
        assert kind in CutKind.__args__
        cuts.append(Cut(tuple(calls), _find(module, scope, last), names[0], kind, names[1]))
    clones = specialise(module, tuple(cuts), "sc_main", FreshNames(()), "sc_")
    return insert_clones(module, clones)


def _find(module: n.Module, function: str, shown: str) -> n.Expr:
    (scope,) = (d for d in module.decls if isinstance(d, n.FunctionDef) and d.name == function)
    found = (node for node in walk(scope.body) if not isinstance(node, n.Stmt))
    return next(node for node in found if print_node(node) == shown)  # type: ignore[return-value]


def _unrolled(module: n.Module, facts: Facts, about: About) -> n.Module:
    return unroll_loops(module, facts, Source("test.frag", "")).module


def _contracted(module: n.Module, facts: Facts, about: About) -> n.Module:
    return contract(expand_compound_assignments(module, facts), Memo())


def _exact(module: n.Module, facts: Facts, about: About) -> n.Module:
    written = write_out_matrices(module, "sc_", "fragment", Memo())
    return make_precise(written, "sc_", "fragment", Memo())


def _guarded(module: n.Module, facts: Facts, about: About) -> n.Module:
    loops = {node for node in walk(module) if isinstance(node, n.For | n.While | n.DoWhile)}
    return guard_loops(module, loops, "sc_lacks")


PASSES: dict[str, Pass] = {
    "contract": _contracted,
    "drop_parameters": lambda m, facts, about: drop_parameters(m, _words(about), Memo()),
    "drop_results": lambda m, facts, about: drop_results(m, _words(about), Memo()),
    "expand_compound_assignments": lambda m, facts, about: expand_compound_assignments(m, facts),
    "guard_loops": _guarded,
    "hide_uniform_varyings": lambda m, facts, about: hide_uniform_varyings(m, "sc_", Memo()),
    "leave_discarded": lambda m, facts, about: leave_discarded(m, "sc_"),
    "lower_ternaries": lambda m, facts, about: lower_ternaries(m, facts),
    "make_arguments_opaque": lambda m, facts, about: make_arguments_opaque(m, Memo()),
    "make_names_unique": lambda m, facts, about: make_names_unique(m, facts),
    "make_precise": _proof(make_precise),
    "name_parameters": lambda m, facts, about: name_parameters(m, "sc_"),
    "plain_builtin_block": lambda m, facts, about: plain_builtin_block(m, facts),
    "remove_dead": lambda m, facts, about: remove_dead(m, _words(about, "color")),
    "rename": lambda m, facts, about: rename(m, dict(about)),
    "rewrite_do_loops": lambda m, facts, about: rewrite_do_loops(m, "sc_"),
    "scale_coordinates": lambda m, facts, about: scale_coordinates(m, whole_picture("sc_")[1]),
    "specialise": _specialised,
    "spell_lists": lambda m, facts, about: spell_lists(m, facts),
    "split_declarations": lambda m, facts, about: split_declarations(m),
    "unroll_loops": _unrolled,
    "write_out_matrices": _exact,
}


@pytest.mark.parametrize("path", sorted(CASES.iterdir()), ids=lambda path: path.stem)
def test_cases(path: Path, golden: Golden) -> None:
    def outcome(case: Case) -> str:
        if path.stem == "raise_versions":
            return _raised(case)
        source = Source(path.name, case.shader)
        module = parse(source)
        stage: Stage = "vertex" if path.suffix == ".vert" else "fragment"
        made = PASSES[path.stem](module, validate(module, source, stage), case.about)
        # A clone shares what it did not change, and its names mean its own parameters.
        alone = parse(Source("", print_module(made))) if path.stem == "specialise" else made
        verify_module(alone, stage, path.stem)
        return print_module(made)

    golden(path, anew(path.read_text(encoding="utf-8"), outcome))


def _raised(case: Case) -> str:
    """Both stages, each with the new names of what an engine sees."""
    trees: list[StageTree] = []
    texts: list[tuple[Stage, str]] = [("fragment", case.shader)]
    if case.vertex:
        texts.append(("vertex", case.vertex))
    for stage, text in texts:
        source = Source(f"a.{stage[:4]}", text)
        module = parse(source)
        trees.append(StageTree(module, validate(module, source, stage), source, stage))
    printed = ""
    for tree, raised in zip(trees, raise_versions(trees, "legacy_"), strict=True):
        verify_module(raised.module, tree.stage)
        names = (f"// {old} is {new}\n" for old, new in raised.renamed.items())
        printed += print_module(raised.module) + "".join(names)
    return printed


NOTHING_TO_DO = """#version 330
uniform float u_a;
out vec4 color;
float f(float x) { return x; }
void main() { color = vec4(f(u_a)); }
"""


ALWAYS = {"hide_uniform_varyings", "make_precise", "specialise", "write_out_matrices"}
"""Passes that have something to do everywhere, if only with an output or with ``main``."""


@pytest.mark.parametrize("name", sorted(PASSES.keys() - ALWAYS))
def test_a_module_with_nothing_to_do_is_returned_itself(name: str) -> None:
    module = parse(Source("test.frag", NOTHING_TO_DO))
    about = [("functions", "f")] * name.startswith("drop") + [("wanted", "color")] * (
        name == "remove_dead"
    )
    facts = validate(module, Source("test.frag", NOTHING_TO_DO))
    assert PASSES[name](module, facts, about) is module


def test_functions_that_programs_share_are_made_opaque_once() -> None:
    module, memo = parse(Source("test.frag", NOTHING_TO_DO.replace("f(u_a)", "cos(u_a)"))), Memo()
    made = [make_arguments_opaque(module, memo).decls[-1] for _ in range(2)]
    assert made[0] is made[1]


def test_fresh_names() -> None:
    assert fresh_prefix("float a;", "int sc;") == "sc_"
    assert fresh_prefix("float sc_a; float sc1_b;", "#define X sc2_y") == "sc3_"
    names = FreshNames({"a", "a_1"})
    assert names.make("a") == "a_2"
    assert names.make("b") == "b"
    assert names.make("b") == "b_1"
    assert "__" not in names.make("c__d")
