"""What is kept between programs: shared, correct, and not without bound."""

from __future__ import annotations

from dataclasses import replace

import pytest

import shadercache.ast.memo as memo_module
from shadercache.analysis.effect_table import EffectTable
from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.caching.configuration import Mode
from shadercache.compiler import analyse
from shadercache.emit.printer import print_module
from shadercache.front.parse import parse
from shadercache.paths import data_path
from shadercache.source import Source
from shadercache.transform.proof.make_precise import make_precise
from shadercache.transform.proof.write_out_matrices import write_out_matrices
from shadercache.transform.remove_dead import remove_dead
from tests.configured import configured, rewritten

TEXT = """#version 330
in float v_a;
out vec4 color;
out vec4 store;
float g;
float f(float x) { g = x; return x * 2.0; }
float h(float x) { return f(x) + 1.0; }
// about main
void main() { float a = h(v_a); color = vec4(a); store = vec4(g); }
"""


def _function(module: n.Module, name: str) -> n.FunctionDef:
    (found,) = (d for d in module.decls if isinstance(d, n.FunctionDef) and d.name == name)
    return found


def _with(module: n.Module, function: n.FunctionDef) -> n.Module:
    """The module with another function of the same name."""
    decls = (
        function if isinstance(d, n.FunctionDef) and d.name == function.name else d
        for d in module.decls
    )
    return replace(module, decls=tuple(decls))


def test_an_unchanged_function_is_the_same_in_another_program() -> None:
    module, memo = parse(Source("test", TEXT)), Memo()
    first = EffectTable(module, memo).linked("h")
    assert EffectTable(replace(module), memo).linked("h") is first
    assert EffectTable(module, Memo()).linked("h") is not first


def test_a_function_is_another_where_one_that_it_calls_does_something_else() -> None:
    module, memo = parse(Source("test", TEXT)), Memo()
    before = EffectTable(module, memo).linked("h")
    assert "g" in before.head.effects.writes
    other = parse(Source("test", TEXT.replace("g = x; ", "")))
    changed = _with(module, _function(other, "f"))
    after = EffectTable(changed, memo).linked("h")
    assert after is not before
    assert after.function is before.function
    assert "g" not in after.head.effects.writes


def test_dead_code_is_judged_by_what_is_wanted_although_the_memo_is_shared() -> None:
    module, memo = parse(Source("test", TEXT)), Memo()
    for wanted in ("store",), ("color",), ("color", "store"), ("store",):
        alone = print_module(remove_dead(module, wanted))
        assert print_module(remove_dead(module, wanted, memo), memo) == alone
        assert ("g = x" in alone) == ("store" in wanted)


def test_comments_come_out_once_in_each_program() -> None:
    module, memo = parse(Source("test", TEXT)), Memo()
    twice = replace(module, decls=(*module.decls, _function(module, "main")))
    for _ in range(2):
        assert print_module(module, memo) == print_module(module)
        assert print_module(twice, memo) == print_module(twice)
        assert print_module(twice, memo).count("// about main") == 1


def test_precise_functions_with_matrices_need_the_types_of_the_new_ones_alone() -> None:
    text = TEXT.replace("in float v_a;", "in float v_a; uniform mat3 u_m;").replace(
        "return f(x) + 1.0;", "return dot(u_m * (u_m * vec3(x)), vec3(2.0));"
    )
    module, memo = parse(Source("test", text)), Memo()
    alone = print_module(_proven(module, Memo()))
    assert "precise vec3 sc_exact" in alone and "sc_mat3_times_vec3(u_m, sc_exact" in alone
    _proven(_with(module, _function(parse(Source("test", text)), "h")), memo)
    assert print_module(_proven(module, memo)) == alone


def _proven(module: n.Module, memo: Memo) -> n.Module:
    written_out = write_out_matrices(module, "sc_", "fragment", memo)
    return make_precise(written_out, "sc_", "fragment", memo)


@pytest.mark.parametrize("mode", ["plain", "proof"])
def test_variants_do_not_depend_on_what_was_written_before(
    mode: Mode, monkeypatch: pytest.MonkeyPatch
) -> None:
    paths = (data_path("corpus", "trashcan", f"trashcan.{end}") for end in ("frag", "vert"))
    sources = [Source(path.name, path.read_text(encoding="utf-8")) for path in paths]
    shared = analyse(*sources)
    nodes = [node.id for node in shared.nodes if node.offered][::30]
    options = configured(mode=mode)
    for most in (memo_module.MOST_ENTRIES, 1_000):
        monkeypatch.setattr(memo_module, "MOST_ENTRIES", most)
        for node in nodes:
            fresh = analyse(*sources)
            alone = rewritten(fresh, fresh.node(node), options)
            made = rewritten(shared, shared.node(node), options)
            assert made.files == alone.files
            assert made.manifest == alone.manifest


def test_a_memo_that_is_too_large_is_emptied(monkeypatch: pytest.MonkeyPatch) -> None:
    memo = Memo()
    memo.table("names")["x"] = 1
    memo.trim()
    assert memo.table("names") == {"x": 1}
    monkeypatch.setattr(memo_module, "MOST_ENTRIES", 0)
    memo.trim()
    assert memo.table("names") == {}
