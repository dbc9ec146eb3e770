"""Ids, call paths, costs and inputs of nodes."""

from __future__ import annotations

import pytest
from shaders import analysed, find

from shadercache.analysis import node_ids
from shadercache.analysis.candidates import MAX_TEXT, Candidate
from shadercache.compiler import Analysis
from shadercache.diagnostics import InputError, UsageError

FUNCTIONS = """
float wave(vec3 p) { return sin(p.x) * sin(p.y) + sin(p.z); }
float sum(vec3 p) { return wave(p) + wave(p * 2.0); }
float other(vec3 p) { return cos(p.x); }
"""
BODY = "float a = sum(v_position); o_color = vec4(a + other(v_normal) + u_time);"


def ids(body: str, declarations: str) -> dict[tuple[str, str], str]:
    return {(node.path, node.text): node.id for node in analysed(body, declarations).nodes}


def test_paths_number_repeated_calls() -> None:
    paths = {node.path for node in analysed(BODY, FUNCTIONS).nodes}
    assert paths == {
        "main",
        "main > sum",
        "main > other",
        "main > sum > wave@1",
        "main > sum > wave@2",
    }


def test_ids_are_unique() -> None:
    nodes = analysed(BODY, FUNCTIONS).nodes
    assert len({node.id for node in nodes}) == len(nodes)


def test_ids_survive_white_space_and_comments() -> None:
    spaced = FUNCTIONS.replace("{ return", "{ // a comment\n   return").replace(" + ", "\n+ ")
    before = [node.id for node in analysed(BODY, FUNCTIONS).nodes]
    assert [node.id for node in analysed(BODY, spaced).nodes] == before


def test_ids_survive_edits_off_the_call_path() -> None:
    edited = FUNCTIONS.replace("cos(p.x)", "cos(p.x) * 3.0 + p.y")
    before, after = ids(BODY, FUNCTIONS), ids(BODY, edited)
    for key, value in before.items():
        if "other" not in key[0]:
            assert after[key] == value


def test_ids_change_with_edits_on_the_call_path() -> None:
    edited = FUNCTIONS.replace("wave(p * 2.0)", "wave(p * 3.0)")
    key = ("main > sum > wave@1", "sin(p.x)")
    assert ids(BODY, FUNCTIONS)[key] != ids(BODY, edited)[key]


def test_id_from_another_source_is_told_from_an_unknown_one() -> None:
    stale = ids(BODY, FUNCTIONS)["main > sum > wave@1", "sin(p.x)"]
    edited = analysed(BODY, FUNCTIONS.replace("2.0", "3.0"))
    with pytest.raises(UsageError) as error:
        edited.node(stale)
    assert error.value.diagnostics[0].code == "SC011"
    with pytest.raises(UsageError) as error:
        edited.node("nothing.1-00000000")
    assert error.value.diagnostics[0].code == "SC010"


def many_paths(salt: int) -> Analysis:
    """40 functions that call one; what all but the first of them pass on depends on ``salt``."""
    callers = (f"float c{i}(vec3 p) {{ return wave(p * {i and salt}.{i}); }}" for i in range(40))
    body = " + ".join(f"c{i}(v_position)" for i in range(40))
    return analysed(f"o_color = vec4({body});", FUNCTIONS + "\n".join(callers))


def test_ids_that_would_collide_are_longer(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(node_ids, "SHORT", 1)
    analysis = many_paths(1)
    shorts: dict[str, list[Candidate]] = {}
    for node in analysis.nodes:
        assert node.instance is not None and node.place is not None
        assert analysis.node(node.id) is node
        shorts.setdefault(analysis.candidates.ids.short(node.instance, node.place), []).append(node)
    assert 1 < len(shorts) < len({node.id for node in analysis.nodes}) == len(analysis.nodes)
    for short, (first, *others) in shorts.items():
        if not others:
            assert first.id == short
            continue
        with pytest.raises(UsageError) as error:
            analysis.node(short)
        (diagnostic,) = error.value.diagnostics
        assert diagnostic.code == "SC012" and diagnostic.hint is not None
        assert all(node.id in diagnostic.hint for node in (first, *others))


def test_ids_that_would_collide_survive_edits_off_the_call_path(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Whatever an edit makes them collide with, an id never comes to mean another node."""
    monkeypatch.setattr(node_ids, "SHORT", 1)
    before, *after = (many_paths(salt) for salt in range(1, 5))
    seen = set[bool]()
    for node in before.nodes:
        if node.path != "main > c0 > wave":
            continue
        assert node.instance is not None and node.place is not None
        long = before.candidates.ids.long(node.instance, node.place)
        short = before.candidates.ids.short(node.instance, node.place)
        for analysis in (before, *after):
            assert (analysis.node(long).path, analysis.node(long).text) == (node.path, node.text)
            try:
                found = analysis.node(short)
            except UsageError as error:
                assert error.diagnostics[0].code == "SC012"
                seen.add(False)
            else:
                assert (found.path, found.text) == (node.path, node.text)
                seen.add(True)
    assert seen == {False, True}, "it collides with others in some of them, and not in all"


def test_cost_counts_what_the_value_depends_on_and_no_more() -> None:
    analysis = analysed(BODY, FUNCTIONS)
    variable = find(analysis, "a")
    call = find(analysis, "sum(v_position)")
    both = find(analysis, "a + other(v_normal) + u_time")
    assert variable.cost == call.cost
    assert find(analysis, "sin(p.x)", "wave@1").cost < find(analysis, "wave(p)").cost < call.cost
    assert call.cost < both.cost
    assert both.ratio == pytest.approx(1.0)


def test_inputs_are_followed_through_calls_and_variables() -> None:
    analysis = analysed(BODY, FUNCTIONS)
    assert find(analysis, "sin(p.x)", "wave@2").inputs == {"v_position"}
    assert find(analysis, "a + other(v_normal) + u_time").inputs == {
        "v_position",
        "v_normal",
        "u_time",
    }


def test_overwritten_definitions_do_not_count() -> None:
    analysis = analysed("float a = sin(v_uv.x); a = cos(u_time); o_color = vec4(a + v_uv.y);")
    assert find(analysis, "a + v_uv.y").inputs == {"u_time", "v_uv"}


def test_call_paths_are_capped() -> None:
    functions = ["float f0(float x) { return x; }"]
    for number in range(1, 20):
        below = f"f{number - 1}"
        functions.append(f"float f{number}(float x) {{ return {below}(x) + {below}(x); }}")
    with pytest.raises(InputError) as error:
        analysed("o_color = vec4(f19(v_uv.x));", "\n".join(functions))
    assert error.value.diagnostics[0].code == "SC401"
    assert str(2**20) in error.value.diagnostics[0].message


@pytest.mark.slow
def test_calls_in_a_row_are_capped() -> None:
    functions = ["float f0(float x) { return x; }"]
    functions += [f"float f{i}(float x) {{ return f{i - 1}(x); }}" for i in range(1, 10_000)]
    assert analysed("o_color = vec4(f498(v_uv.x));", "\n".join(functions[:499])).nodes
    with pytest.raises(InputError) as error:
        analysed("o_color = vec4(f9999(v_uv.x));", "\n".join(functions))
    assert error.value.diagnostics[0].code == "SC401"


def test_expressions_on_all_call_paths_are_capped() -> None:
    functions = [f"float f0(float x) {{ return x{' + x' * 100}; }}"]
    for number in range(1, 13):
        below = f"f{number - 1}"
        functions.append(f"float f{number}(float x) {{ return {below}(x) + {below}(x); }}")
    with pytest.raises(InputError) as error:
        analysed("o_color = vec4(f12(v_uv.x));", "\n".join(functions))
    assert error.value.diagnostics[0].code == "SC401"
    assert "843777 expressions on all its call paths" in error.value.diagnostics[0].message


def test_statements_on_all_call_paths_are_capped() -> None:
    with pytest.raises(InputError) as error:
        analysed("o_color = vec4(1.0);" + ";" * 40_000)
    assert error.value.diagnostics[0].code == "SC401"
    assert "40001 statements on all its call paths" in error.value.diagnostics[0].message


@pytest.mark.parametrize(
    ("terms", "names", "found"),
    [(50_000, 1, "100004 expressions, 3 names"), (5_000, 5_000, "10004 expressions, 5002 names")],
)
@pytest.mark.slow
def test_the_length_of_a_shader_is_capped(terms: int, names: int, found: str) -> None:
    uniforms = "".join(f"uniform float u{number};\n" for number in range(names))
    total = " + ".join(f"u{number % names}" for number in range(terms))
    with pytest.raises(InputError) as error:
        analysed(f"o_color = vec4(v_uv, {total}, 1.0);", uniforms)
    (diagnostic,) = error.value.diagnostics
    assert diagnostic.code == "SC401"
    assert diagnostic.message.endswith(found)


def test_the_text_of_a_long_node_is_cut_off() -> None:
    analysis = analysed(f"o_color = vec4(v_uv.x{' + v_uv.y' * 1_000});")
    text = max((node.text for node in analysis.nodes), key=len)
    assert len(text) == MAX_TEXT
    assert text.startswith("o_color = vec4(v_uv.x + v_uv.y + ")
    assert text.endswith("…")


@pytest.mark.parametrize(
    ("declarations", "body", "code"),
    [
        ("out vec4 o_more[8];", "o_color = vec4(1.0); o_more[1] = vec4(0.0);", "SC403"),
        ("", "o_color = vec4(1.0); gl_FragDepth = v_uv.x;", "SC404"),
        (
            "#extension GL_ARB_shader_atomic_counters : enable\n"
            "#extension GL_ARB_shading_language_420pack : enable\n"
            "layout(binding = 0, offset = 0) uniform atomic_uint a;",
            "o_color = vec4(float(atomicCounterIncrement(a)));",
            "SC413",
        ),
    ],
)
def test_shaders_that_cannot_be_cached(declarations: str, body: str, code: str) -> None:
    with pytest.raises(InputError) as error:
        analysed(body, declarations)
    assert error.value.diagnostics[0].code == code


def test_varyings_must_match_between_the_stages() -> None:
    with pytest.raises(InputError) as error:
        analysed("o_color = vec4(v_other, 1.0);", "in vec3 v_other;")
    assert error.value.diagnostics[0].code == "SC406"
