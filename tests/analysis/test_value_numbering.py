"""Which nodes count as one value, and what is to be computed on the CPU."""

from __future__ import annotations

import pytest
from shaders import analysed, find

from shadercache.analysed import on_cpu
from shadercache.analysis.precision import PrecisionTable
from shadercache.analysis.value_numbering import one_of_each
from shadercache.ast.walk import expressions
from shadercache.compiler import Analysis, analyse
from shadercache.source import Source
from shadercache.valid.read import read

WAVE = "float wave(vec3 p) { return sin(p.x * 3.0) * cos(p.y) + sin(p.z); }"


def texts(analysis: Analysis, text: str, path: str = "main") -> set[tuple[str, str]]:
    group = analysis.groups[find(analysis, text, path)]
    return {(node.path, node.text) for node in group.nodes}


def test_copies_parentheses_calls_and_what_they_return() -> None:
    body = """
    float a = wave(v_position);
    float b = (a);
    o_color = vec4(b + wave((v_position)) * 2.0);
    """
    assert texts(analysed(body, WAVE), "a") == {
        ("main", "wave(v_position)"),
        ("main", "wave((v_position))"),
        ("main", "a"),
        ("main", "b"),
        ("main > wave@1", "sin(p.x * 3.0) * cos(p.y) + sin(p.z)"),
        ("main > wave@2", "sin(p.x * 3.0) * cos(p.y) + sin(p.z)"),
    }


@pytest.mark.parametrize(
    "between",
    (
        "a += 1.0;",
        "a++;",
        "if (v_uv.x > 0.5) a = 0.5;",
        "for (int i = 0; i < 3; i++) a *= 0.5;",
        "change(a);",
        "float c = (a = 0.25) + 1.0;",
        "float c = modf(v_uv.x, a);",
    ),
)
def test_a_variable_that_is_written_between_is_another_value(between: str) -> None:
    declarations = WAVE + "void change(inout float x) { x *= 2.0; }"
    body = f"float a = wave(v_position); float b = a * 2.0; {between} o_color = vec4(b + sin(a));"
    analysis = analysed(body, declarations)
    reads = [node for node in analysis.nodes if node.text == "a" and node.path == "main"]
    before, after = reads[0], reads[-1]
    assert analysis.groups[before] is analysis.groups[find(analysis, "wave(v_position)")]
    assert analysis.groups[before] is not analysis.groups[after]


def test_reads_on_both_sides_of_a_write_in_one_statement_differ() -> None:
    analysis = analysed("float x = v_uv.x; float y = x++ + sin(x); o_color = vec4(y);")
    first = find(analysis, "v_uv.x")
    inner = [node for node in analysis.nodes if node.text == "x"]
    assert all(analysis.groups[node] is not analysis.groups[first] for node in inner)


def test_a_part_that_is_written_makes_another_variable() -> None:
    analysis = analysed("vec3 v = v_normal; v.x = 0.5; o_color = vec4(v * 2.0, 1.0);")
    assert ("main", "v") not in texts(analysis, "v_normal")


def test_globals_that_change_are_equal_to_nothing() -> None:
    body = "float a = g * 2.0; set(); float b = g * 2.0; o_color = vec4(a, b, 0.0, 1.0);"
    analysis = analysed(body, "float g = 0.5;\nvoid set() { g = v_uv.x; }")
    products = [node for node in analysis.nodes if node.text == "g * 2.0"]
    assert analysis.groups[products[0]] is not analysis.groups[products[1]]


def test_conversions_are_part_of_a_value() -> None:
    body = "int i = int(v_uv.x * 4.0); float a = i; o_color = vec4(a / 2.0, i / 2, a / 2.0, 1.0);"
    analysis = analysed(body)
    assert texts(analysis, "a / 2.0") == {("main", "a / 2.0")}
    assert texts(analysis, "a") == {("main", "a")}


def test_derivatives_in_different_flow_are_different() -> None:
    body = "float a = dFdx(v_uv.x); if (v_uv.y > 0.5) a += dFdx(v_uv.x); o_color = vec4(a);"
    analysis = analysed(body)
    calls = [node for node in analysis.nodes if node.text == "dFdx(v_uv.x)"]
    assert analysis.groups[calls[0]] is not analysis.groups[calls[1]]


def test_structs_of_one_name_in_two_scopes_are_two_types() -> None:
    body = """
    float a = 0.0;
    { struct S { float x; float y; }; S s = S(v_uv.x, v_uv.y); a += sin(s.x); }
    { struct S { float y; float x; }; S s = S(v_uv.x, v_uv.y); a += sin(s.x); }
    o_color = vec4(a);
    """
    analysis = analysed(body)
    first, second = (node for node in analysis.nodes if node.text == "sin(s.x)")
    assert analysis.groups[first] is not analysis.groups[second]


KILL = "void kill() { if (v_uv.y > 0.5) discard; }"


@pytest.mark.parametrize("value", ("fwidth(v_uv.x)", "texture(u_map, v_uv).x"))
@pytest.mark.parametrize(
    "between",
    (
        "if (v_uv.y > 0.5) discard;",
        "if (v_uv.y > 0.5) return;",
        "if (v_uv.x > 0.5) { if (v_uv.y > 0.5) return; }",
        "kill();",
    ),
)
def test_derivatives_with_an_exit_between_are_different(value: str, between: str) -> None:
    """Neighbours that have left take part in the first and in no later one."""
    body = f"""
    float a = {value}; float b = {value};
    {between}
    float c = {value};
    o_color = vec4(a, b, c, 1.0);
    """
    analysis = analysed(body, KILL)
    a, b, c = (analysis.groups[node] for node in analysis.nodes if node.text == value)
    assert a is b and a is not c


def test_derivatives_before_and_behind_a_callee_s_exits_are_different() -> None:
    declarations = """
    float early() { float x = fwidth(v_uv.x); if (v_uv.y > 0.5) discard; return x; }
    float late() { if (v_uv.y > 0.5) return 0.0; return fwidth(v_uv.x); }
    """
    body = "float a = early(); float b = fwidth(v_uv.x); o_color = vec4(a, b, late(), 1.0);"
    analysis = analysed(body, declarations)
    found = [analysis.groups[node] for node in analysis.nodes if node.text == "fwidth(v_uv.x)"]
    assert len(found) == len(set(found)) == 3


def test_an_exit_between_leaves_other_values_equal() -> None:
    body = "float a = sin(v_uv.x); if (a > 0.5) discard; o_color = vec4(a, sin(v_uv.x), 0.0, 1.0);"
    analysis = analysed(body)
    first, second = (node for node in analysis.nodes if node.text == "sin(v_uv.x)")
    assert analysis.groups[first] is analysis.groups[second]


def test_of_another_precision_is_another_value() -> None:
    """In GLSL ES a variable rounds what is assigned to it."""
    text = """#version 300 es
    precision highp float;
    in vec2 v_uv;
    out vec4 o_color;
    float low(mediump float x) { return x * 1.5; }
    float high(highp float x) { return x * 1.5; }
    void main() {
        mediump float a = v_uv.x * 3.0;
        float b = v_uv.x * 3.0;
        mediump float c = v_uv.x * 3.0;
        float d = b;
        o_color = vec4(a * 2.0, b * 2.0, c * 2.0, d * 2.0) + low(b) + high(b);
    }
    """
    analysis = analyse(Source("test.frag", text), mapping="screen")
    a, b, c, d, products, rest = (
        analysis.groups[find(analysis, value)]
        for value in ("a * 2.0", "b * 2.0", "c * 2.0", "d * 2.0", "v_uv.x * 3.0", "b")
    )
    assert a is c and b is d and a is not b
    assert products is rest and analysis.groups[find(analysis, "a")] is not products
    assert (
        analysis.groups[find(analysis, "low(b)")] is not analysis.groups[find(analysis, "high(b)")]
    )


def test_precisions_of_long_chains() -> None:
    text = f"""#version 300 es
    precision mediump float;
    in float v;
    out vec4 o_color;
    void main() {{ float a = v{" + v" * 20_000}; o_color = vec4(a); }}
    """
    module, facts = read(Source("test.frag", text), "fragment")
    chain = max(expressions(module), key=lambda expr: expr.span.end - expr.span.start)
    assert PrecisionTable(module, facts).of(chain) == "mediump"


def test_a_sweep_takes_one_of_each() -> None:
    body = "float a = wave(v_position); o_color = vec4(a * wave(v_normal) + wave(v_position));"
    analysis = analysed(body, WAVE)
    offered = [node for node in analysis.nodes if node.offered]
    found = one_of_each(offered, analysis.groups)
    assert sum(found.values()) == len(offered) > len(found)
    assert all(analysis.groups[node].first is node for node in found)
    first = find(analysis, "wave(v_position)")
    assert found[first] == sum(node in analysis.groups[first].nodes for node in offered)


def test_text_for_the_cpu() -> None:
    declarations = """
    float half_of(float x) { return x * 0.5; }
    float loop(float x) { for (int i = 0; i < 3; i++) x *= 1.5; return x; }
    """
    body = """
    float k = u_time * 3.0;
    float m = half_of(k + 1.0);
    int n = int(m);
    float f = n;
    k += u_tint.x;
    float l = k;
    l++;
    o_color = vec4(sin(m) * v_uv.x, f * 2.0, k * 2.0 + l * 3.0, loop(m) + v_uv.y);
    """
    analysis = analysed(body, declarations)

    def cpu(text: str) -> str | None:
        return on_cpu(analysis, find(analysis, text))

    assert cpu("sin(m)") == "sin((u_time * 3.0 + 1.0) * 0.5)"
    assert cpu("f * 2.0") == "float(int((u_time * 3.0 + 1.0) * 0.5)) * 2.0"
    assert cpu("loop(m)") == "loop((u_time * 3.0 + 1.0) * 0.5)"
    assert cpu("k * 2.0") == "(u_time * 3.0 + u_tint.x) * 2.0"
    assert cpu("l * 3.0") is None, "l was changed in a way that no expression tells"
    assert cpu("v_uv.x") is None, "nothing for the CPU"


@pytest.mark.slow
def test_long_chains_of_definitions_end() -> None:
    chain = "".join(f"float k{i} = k{i - 1} * 1.5 + k{i - 1};" for i in range(1, 2000))
    analysis = analysed(
        f"float k0 = u_time; {chain} o_color = vec4(k1999 * v_uv.x, k3 + 1.0, v_uv);"
    )
    assert on_cpu(analysis, find(analysis, "k3 + 1.0")) is not None
    assert on_cpu(analysis, find(analysis, "k1998 * 1.5")) is None
    assert len(analysis.groups) == len(analysis.nodes)
