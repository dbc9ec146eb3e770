"""Unrolled loops: which they are, what becomes of them, and what is said of the others."""

from __future__ import annotations

import re

import pytest

from shadercache.compiler import Analysis, analyse
from shadercache.diagnostics import InputError, UsageError
from shadercache.front.read_options import ReadOptions
from shadercache.source import Source
from shadercache.transform.unroll import MAX_TRIPS
from tests.cases.cases import sources
from tests.configured import rewritten
from tests.shaders import VERTEX, analysed, find, fragment

WAVE = "float wave(float x) { return sin(x) * cos(x + 1.0) * sin(x * 2.0); }\n"
SUM = "a += wave(v_uv.x + float({}));"


def unrolled(body: str, declarations: str = "") -> Analysis:
    source = fragment(f"float a = 0.0;\n{body}\no_color = vec4(a);", WAVE + declarations)
    return analyse(source, Source("test.vert", VERTEX), ReadOptions(unroll=True))


def trips(body: str, declarations: str = "") -> list[str]:
    """What the paths of the nodes ``a += ...`` have in brackets."""
    paths = [
        node.path for node in unrolled(body, declarations).nodes if node.text.startswith("a +")
    ]
    return [found[1] for path in paths if (found := re.fullmatch(r"main \[(.*)\]", path))]


@pytest.mark.parametrize(
    ("head", "expected"),
    [
        ("int i = 0; i < 3; i++", "i=0 i=1 i=2"),
        ("int i = 2; i >= 0; --i", "i=2 i=1 i=0"),
        ("int i = 1; i != 9; i *= 3", "i=1 i=3"),
        ("int i = -N; i <= N; i = i + N", "i=-2 i=0 i=2"),
        ("int i = 1 << 4; bool(i & 12) || i == 16; i >>= 1", "i=16 i=8 i=4"),
        ("uint i = 2u; i < 3u; i--", "i=2u i=1u i=0u"),
        ("uint i = 4294967294u; i > 1u; i++", "i=4294967294u i=4294967295u"),
        ("int i = 2147483646; i > 0; i++", "i=2147483646 i=2147483647"),
        ("int i = -2147483647; i < 0; i--", "i=-2147483647 i=-2147483648"),
        ("float i = 0.0; i < 0.3; i += 0.1", "i=0.0 i=0.1 i=0.2"),
        ("float i = 16777216.0; i < 16777219.0; i += 1.5", "i=16777216.0 i=16777218.0"),
        ("float i = 1; i < 1e9; i *= 3e4", "i=1.0 i=30000.0 i=900000000.0"),
        ("int i = 0, j = 9; i < j; i += 4, j--", "i=0,j=9 i=4,j=8"),
    ],
)
def test_the_counters_of_each_trip(head: str, expected: str) -> None:
    assert trips(f"for ({head}) {SUM.format('i')}", "const int N = 2;") == [
        item.replace(",", ", ") for item in expected.split()
    ]


def test_floats_are_rounded_as_in_the_shader() -> None:
    """Ten times 0.1 is more than 1.0 in 32 bits, and seven times more than 0.7; less in 64."""
    assert len(trips(f"for (float t = 0.0; t < 1.0; t += 0.1) {SUM.format('t')}")) == 10
    assert len(trips(f"for (float t = 0.0; t <= 0.7; t += 0.1) {SUM.format('t')}")) == 7


def test_loops_in_loops() -> None:
    body = f"for (int i = 0; i < 3; i++) for (int j = i; j < 2; j++) {SUM.format('i - j')}"
    assert trips(body) == ["i=0, j=0", "i=0, j=1", "i=1, j=1"]


def test_conditions_on_counters_are_decided() -> None:
    jumps = "if (i == 1) continue; if (i > 3) { a *= 2.0; break; }"
    assert trips(f"for (int i = 0; i < 9; i++) {{ {jumps} {SUM.format('i')} }}") == [
        "i=0",
        "i=2",
        "i=3",
    ]


@pytest.mark.parametrize(
    ("loop", "reason"),
    [
        ("for (int i = 0; i < 1000000000; i++) a += 1.0;", f"more than {MAX_TRIPS} trips"),
        ("for (float t = 0.0; t < 20000000.0; t += 1.0) a += t;", f"more than {MAX_TRIPS} trips"),
        ("for (float t = 1.0; t < 2.0; t += 1e-9) a += t;", f"more than {MAX_TRIPS} trips"),
        ("for (float t = 1e30; t > 0.0; t *= 1e5) a += t;", "leaves the numbers of its type"),
        ("for (int i = 0; i < 3; i--) a += 1.0;", f"more than {MAX_TRIPS} trips"),
        ("for (uint i = 3u; i >= 0u; i--) a += 1.0;", f"more than {MAX_TRIPS} trips"),
        ("for (int i = 0; i < 3; i += 0) a += 1.0;", f"more than {MAX_TRIPS} trips"),
        ("for (int i = 0; i < 3; i /= 0) a += 1.0;", "more than count by constants"),
        ("for (int i = 5; i < 3; i++) a += 1.0;", "makes no trip"),
        ("for (int i = 0; i < 3; i++) { if (a > 1.0) break; a += 1.0; }", "break or continue"),
        ("for (int i = 0; i < 3; i++) { if (a > 1.0) continue; a += 1.0; }", "break or continue"),
        ("for (int i = 0; i < 3; i++) a += float(i++);", "written in its body"),
        ("for (int i = 0; i < 3; i++) { advance(i); a += 1.0; }", "written in its body"),
        ("int i; for (i = 0; i < 3; i++) a += 1.0;", "does not declare its counter"),
        ("for (int i = 0; i < int(u_time); i++) a += 1.0;", "needs more than its counters"),
        ("for (int i = int(u_time); i < 3; i++) a += 1.0;", "does not begin with a constant"),
        ("for (ivec2 i = ivec2(0); i.x < 3; i.x++) a += 1.0;", "does not begin with a constant"),
        ("for (int i = 0; i < 3; i += int(u_time)) a += 1.0;", "more than count by constants"),
        ("for (int i = 0; i < 3; i++, a += 1.0) a += 2.0;", "more than count by constants"),
        ("for (int i = 0; bool b = i < 3; i++) a += 1.0;", "no condition that ends it"),
        ("for (int i = 0; i < 2; i++) { struct S { float x; } s; s.x = a; a += s.x; }", "a struct"),
    ],
)
def test_loops_that_stay_and_why(loop: str, reason: str) -> None:
    analysis = unrolled(loop, "void advance(inout int i) { i++; }\n")
    (note,) = analysis.kept_loops
    assert note.code == "SC414" and reason in note.message
    assert note.span is not None and note.source is not None
    assert note.source.excerpt(note.span).startswith("for (")
    assert not analysis.program.unrolled
    assert note in analysis.notes


def test_too_many_trips_together_leave_the_inner_loop() -> None:
    inner = f"for (int j = 0; j < 10; j++) {SUM.format('i + j')}"
    analysis = unrolled(f"for (int i = 0; i < 10; i++) {{ {inner} }}")
    assert [note.message for note in analysis.kept_loops] == [
        "this loop is not unrolled: "
        f"with the loop around it there would be more than {MAX_TRIPS} trips"
    ]
    assert find(analysis, "a").path.startswith("main")
    assert (
        rewritten(analysis, find(analysis, "vec4(a)")).files["2-pass.miss.frag"].count("for (")
        == 10
    )


def test_too_long_loops_stay() -> None:
    more = "".join(
        f"float f{i}(float x) {{ return f{i - 1}(x) + f{i - 1}(x + 0.1); }}\n" for i in range(1, 9)
    )
    functions = "float f0(float x) { return wave(x); }\n" + more
    analysis = unrolled("for (int i = 0; i < 60; i++) a += f8(v_uv.x + float(i));", functions)
    (note,) = analysis.kept_loops
    assert "60000 expressions" in note.message
    assert not analysis.program.unrolled


def test_nothing_changes_unless_asked_for() -> None:
    body = f"float a = 0.0; for (int i = 0; i < 3; i++) {SUM.format('i')} o_color = vec4(a);"
    analysis = analysed(body, WAVE)
    assert not analysis.kept_loops and not analysis.program.unrolled
    assert find(analysis, "vec4(a)").offered, "the value of a whole loop needs no unrolling"
    inside = find(analysis, "wave(v_uv.x + float(i))")
    with pytest.raises(InputError, match="SC301") as raised:
        analysis.require_all([inside])
    assert "--unroll" in str(raised.value.diagnostics[0].hint)


def test_ids_are_not_those_of_the_loop() -> None:
    loop = f"for (int i = 0; i < 3; i++) {SUM.format('i')}"
    source = fragment(
        f"float a = far();\n{loop}\no_color = vec4(a);", WAVE + "float far() { return v_uv.x; }"
    )
    plain = {node.id for node in analyse(source).nodes}
    analysis = analyse(source, None, ReadOptions(unroll=True))
    ids = [node.id for node in analysis.nodes]
    assert len(ids) == len(set(ids)) and plain.isdisjoint(ids)
    assert all(re.search(r"\.\d+u-", item) for item in ids)
    with pytest.raises(UsageError, match="SC010") as raised:
        analyse(source).node(ids[0])
    assert "add --unroll" in str(raised.value.diagnostics[0].hint)
    with pytest.raises(UsageError) as raised:
        analysis.node(min(plain))
    assert "nodes test.frag --unroll" in str(raised.value.diagnostics[0].hint)


def test_what_no_loop_leads_to_keeps_its_ids() -> None:
    """A loop in one function is nothing to another."""
    text = "float loop(float a) {{ for (int i = 0; i < {}; i++) a += 1.0; return a; }}"
    main = "o_color = vec4(loop(v_uv.x), wave(v_uv.y), 0.0, 1.0);"
    source = fragment(main, WAVE + text.format(2))
    plain, made = (
        {node.id for node in analyse(source, None, ReadOptions(unroll=flag)).nodes}
        for flag in (False, True)
    )
    assert {item for item in plain if item.startswith(("main", "wave"))} <= made
    assert not {item for item in made if item.startswith("loop")} & plain


def test_24_of_25_samples() -> None:
    fragment_source, vertex = sources("unrolled_trashcan")
    analysis = analyse(fragment_source, vertex, ReadOptions(unroll=True))
    sums = [node for node in analysis.nodes if node.text.startswith("light +=")]
    assert len(sums) == 25 and all(node.offered for node in sums)
    assert sums[23].path == "main [y=2, x=1]"
    assert sums[23].ratio == pytest.approx(24 / 25, abs=0.03)
    shade = rewritten(analysis, sums[23], algorithms=("3-pass",)).files["3-pass.shade.frag"]
    assert shade.count("sampled(float(") == 1 and "for (" not in shade
