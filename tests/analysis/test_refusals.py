"""Which values are offered, and the true reason where one is refused (law 9)."""

from __future__ import annotations

import pytest
from shaders import analysed, find

from shadercache.analysis.candidates import Candidate

NOISE = """
float noise(vec3 p) {
    return sin(p.x * 12.9) * sin(p.y * 78.2) * sin(p.z * 37.7) * sin(dot(p, p));
}
"""

UNSURE = "offered, but not every fragment needs it"


def verdict(node: Candidate) -> str | None:
    if node.refusal is not None:
        return node.refusal.code.code
    return UNSURE if node.unsure else None


OTHERS = "uniform samplerCube u_cube; struct Big { vec3 x; vec3 y; vec2 z; };\n"

CASES = {
    "offered": ("o_color = vec4(noise(v_position));", "noise(v_position)", None),
    "offered in a declaration": (
        "float a = noise(v_position); o_color = vec4(a);",
        "noise(v_position)",
        None,
    ),
    "offered in the condition of an if": (
        "o_color = vec4(0.0); if (noise(v_position) > 0.0) o_color = vec4(1.0);",
        "noise(v_position)",
        None,
    ),
    "offered before an early return": (
        "float a = noise(v_position); o_color = vec4(a); if (a > 0.0) return; o_color.x = 1.0;",
        "noise(v_position)",
        None,
    ),
    "offered after a loop that feeds it": (
        "vec3 q = v_position; for (int i = 0; i < 4; i++) q += noise(q); o_color = vec4(noise(q));",
        "noise(q)",
        "SC301",  # the first one of that text: inside the loop
    ),
    "loop": (
        "float s = 0.0; for (int i = 0; i < 3; i++) s += noise(v_position * float(i));"
        "o_color = vec4(s);",
        "noise(v_position * float(i))",
        "SC301",
    ),
    "loop header": (
        "float s = 0.0; for (float f = noise(v_position); f < 3.0; f += 1.0) s += f;"
        "o_color = vec4(s);",
        "noise(v_position)",
        "SC301",
    ),
    "constant": ("o_color = vec4(sin(2.0) * 3.0);", "sin(2.0) * 3.0", "SC302"),
    "uniform only": (
        "o_color = vec4(pow(u_tint, vec3(sin(u_time))), 1.0);",
        "pow(u_tint, vec3(sin(u_time)))",
        "SC303",
    ),
    "uniform only through a variable": (
        "float a = sin(u_time); o_color = vec4(pow(u_tint, vec3(a)), 1.0);",
        "pow(u_tint, vec3(a))",
        "SC303",
    ),
    "side effect": (
        "float a = v_uv.x; float b = (a += noise(v_position)); o_color = vec4(a, b, 0, 1);",
        "a += noise(v_position)",
        "SC304",
    ),
    "opaque": ("o_color = texture(u_map, v_uv);", "u_map", "SC305"),
    "offered with four channels": (
        "o_color = sin(v_position.xyzx) * cos(v_position.yzxy);",
        "sin(v_position.xyzx) * cos(v_position.yzxy)",
        None,
    ),
    "cheaper than the two fetches of four channels": (
        "o_color = textureLod(u_map, v_uv, 0.0);",
        "textureLod(u_map, v_uv, 0.0)",
        "SC308",
    ),
    "too wide": (
        "mat3 m = outerProduct(sin(v_position), cos(v_position)); o_color = vec4(m[0], 1.0);",
        "outerProduct(sin(v_position), cos(v_position))",
        "SC306",
    ),
    "too wide a struct": (
        "Big b = Big(v_position, sin(v_normal), v_uv); o_color = vec4(b.x, b.z);",
        "Big(v_position, sin(v_normal), v_uv)",
        "SC306",
    ),
    "a struct without a place outside": (
        "struct Small { vec3 x; }; Small s = Small(sin(v_position)); o_color = vec4(s.x, 1.0);",
        "Small(sin(v_position))",
        "SC317",
    ),
    "l-value": ("o_color = vec4(noise(v_position));", "o_color", "SC307"),
    "l-value of a swizzle": (
        "vec3 a; a.xy = v_uv; a.z = noise(v_position); o_color = vec4(a, 1.0);",
        "a.xy",
        "SC307",
    ),
    "cheaper than a fetch": ("o_color = vec4(v_position * 2.0, 1.0);", "v_position * 2.0", "SC308"),
    "conditional branch": (
        "o_color = vec4(0.0); if (v_uv.x > 0.5) o_color = vec4(noise(v_position));",
        "noise(v_position)",
        UNSURE,
    ),
    "conditional operator": (
        "o_color = vec4(v_uv.x > 0.5 ? noise(v_position) : 0.0);",
        "noise(v_position)",
        UNSURE,
    ),
    "right operand of &&": (
        "bool b = v_uv.x > 0.5 && noise(v_position) > 0.0; o_color = vec4(b);",
        "noise(v_position)",
        UNSURE,
    ),
    "cheap part of a conditional operator": (
        "o_color = vec4(v_uv.x > 0.5 ? v_uv.y * 2.0 : 0.0);",
        "v_uv.y * 2.0",
        "SC309",
    ),
    "conditional operator beside a side effect": (
        "float a = 0.0; o_color = vec4(v_uv.x > 0.5 ? noise(v_position) : 0.0, a++, 0.0, 1.0);",
        "noise(v_position)",
        "SC309",
    ),
    "switch": (
        "o_color = vec4(0.0); switch (int(v_uv.x)) { case 0: o_color = vec4(noise(v_position)); }",
        "noise(v_position)",
        UNSURE,
    ),
    "after an early return": (
        "o_color = vec4(0.0); if (v_uv.x > 0.5) return; o_color = vec4(noise(v_position));",
        "noise(v_position)",
        UNSURE,
    ),
    "after a discard": (
        "if (v_uv.x > 0.5) discard; o_color = vec4(noise(v_position));",
        "noise(v_position)",
        UNSURE,
    ),
    "screen position in the condition alone": (
        "o_color = vec4(0.0); if (gl_FragCoord.x > 9.0) { float a = noise(v_position);"
        " o_color = vec4(noise(v_position + a)); }",
        "noise(v_position + a)",
        UNSURE,
    ),
    "screen position in a condition inside": (
        "o_color = vec4(0.0); if (v_uv.x > 0.5) { float a = 1.0;"
        " if (gl_FragCoord.x > 9.0) a = 2.0; o_color = vec4(noise(v_position * a)); }",
        "noise(v_position * a)",
        "SC313",
    ),
    "screen position in a case that falls through": (
        "float a = 0.0; switch (int(v_uv.x)) { case 0: a = gl_FragCoord.x;"
        " case 1: o_color = vec4(noise(v_position * a)); }",
        "noise(v_position * a)",
        "SC313",
    ),
    "a fetch under the same condition that it does not feed": (
        "o_color = vec4(0.0); if (v_uv.x > 0.5) {"
        " o_color = texture(u_map, v_uv); o_color *= noise(v_position); }",
        "noise(v_position)",
        UNSURE,
    ),
    "a fetch under the same condition that it feeds": (
        "o_color = vec4(0.0); if (v_uv.x > 0.5) {"
        " vec2 a = vec2(noise(v_position)); o_color = texture(u_map, a); }",
        "noise(v_position)",
        "SC315",
    ),
    "the condition of a fetch": (
        "o_color = vec4(0.0); if (noise(v_position) > 0.5) o_color = texture(u_map, v_uv);",
        "noise(v_position)",
        "SC315",
    ),
    "the condition of a return before a fetch in a branch": (
        "o_color = vec4(0.0); if (v_uv.x > 0.5) { if (noise(v_position) > 0.5) return;"
        " o_color = texture(u_map, v_uv); }",
        "noise(v_position)",
        "SC315",
    ),
    "the condition of a return before a fetch": (
        "o_color = vec4(0.0); if (noise(v_position) > 0.5) return; o_color = texture(u_map, v_uv);",
        "noise(v_position)",
        "SC315",
    ),
    "the condition of a return behind a fetch": (
        "o_color = texture(u_map, v_uv); if (noise(v_position) > 0.5) return; o_color.x = 0.5;",
        "noise(v_position)",
        None,
    ),
    "the condition of a return before a discard": (
        "o_color = vec4(0.0); if (noise(v_position) > 0.5) return; if (v_uv.x > 0.5) discard;",
        "noise(v_position)",
        "SC316",
    ),
    "before a discard": (
        "float a = noise(v_position); if (a > 0.5) discard; o_color = vec4(a);",
        "noise(v_position)",
        "SC316",
    ),
    "explicit derivative": (
        "o_color = vec4(noise(dFdx(v_position)));",
        "noise(dFdx(v_position))",
        "SC312",
    ),
    "derivative through a variable": (
        "float w = fwidth(v_uv.x); o_color = vec4(noise(v_position * w));",
        "noise(v_position * w)",
        "SC312",
    ),
    "screen position": (
        "o_color = vec4(noise(gl_FragCoord.xyz));",
        "noise(gl_FragCoord.xyz)",
        "SC313",
    ),
    "screen position through a condition": (
        "float s = 1.0; if (gl_FragCoord.x > 9.0) s = 2.0; o_color = vec4(noise(v_position * s));",
        "noise(v_position * s)",
        "SC313",
    ),
    "another side effect in the statement": (
        "float a = v_uv.x; float b = a++ + noise(v_position); o_color = vec4(a + b);",
        "noise(v_position)",
        "SC314",
    ),
    "feeds an implicit fetch": (
        "float a = noise(v_position); o_color = texture(u_map, vec2(a, 0.5));",
        "noise(v_position)",
        "SC315",
    ),
    "feeds an implicit fetch in the same statement": (
        "o_color = texture(u_map, vec2(noise(v_position), 0.5));",
        "noise(v_position)",
        "SC315",
    ),
    "feeds a derivative": (
        "float a = noise(v_position); o_color = vec4(fwidth(a));",
        "noise(v_position)",
        "SC315",
    ),
    "feeds an explicit fetch": (
        "float a = noise(v_position); o_color = textureLod(u_map, vec2(a, 0.5), 0.0);",
        "noise(v_position)",
        None,
    ),
    "decides whether a fetch is made": (
        "o_color = vec4(0.0); if (noise(v_position) > 0.0) o_color = texture(u_map, v_uv);",
        "noise(v_position)",
        "SC315",
    ),
    "decides a look-up in a cube map": (
        "vec3 ray = reflect(v_position, normalize(v_normal) + sin(v_position));"
        "o_color = textureLod(u_cube, ray, 0.0);",
        "reflect(v_position, normalize(v_normal) + sin(v_position))",
        "SC319",
    ),
    "integers": (
        "int i = int(noise(v_position)); o_color = vec4(i);",
        "int(noise(v_position))",
        None,
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_verdict(name: str) -> None:
    body, text, code = CASES[name]
    node = find(analysed(body, NOISE + OTHERS), text)
    assert verdict(node) == code


GLOBAL = NOISE + "float g = 1.0; void change() { g = v_uv.x; } float helper(vec3 p) { return "


@pytest.mark.parametrize(
    ("declarations", "body", "text", "code"),
    [
        (
            GLOBAL + "noise(p) * g; }",
            "change(); o_color = vec4(helper(v_position));",
            "noise(p) * g",
            "SC311",
        ),
        (
            GLOBAL + "noise(p) * g; }",
            "o_color = vec4(helper(v_position)); change();",
            "helper(v_position)",
            "SC311",
        ),
        (
            NOISE + "const float k = 2.0; float scale = u_time * k;",
            "o_color = vec4(noise(v_position) * scale);",
            "noise(v_position) * scale",
            None,
        ),
        (
            NOISE + "float scale = sin(u_time);",
            "o_color = vec4(noise(v_position) * scale);",
            "sin(u_time)",
            "SC318",
        ),
        (
            NOISE + "float twice(float x, out float y) { y = x; return noise(v_position + x); }",
            "float y; float z = twice(v_uv.x, y); o_color = vec4(y + z);",
            "noise(v_position + x)",
            None,
        ),
        (
            NOISE + "float twice(float x, out float y) { y = x; return noise(v_position + x); }",
            "float y; float z = 1.0 + twice(v_uv.x, y); o_color = vec4(y + z);",
            "noise(v_position + x)",
            "SC314",
        ),
        (
            NOISE + "float in_loop(float x) { return noise(v_position + x); }",
            "float s = 0.0; while (s < 3.0) s += in_loop(s) + 1.0; o_color = vec4(s);",
            "noise(v_position + x)",
            "SC301",
        ),
        (
            NOISE + "float guarded(float x) { if (x > 0.5) return 1.0; return noise(v_position); }",
            "o_color = vec4(guarded(v_uv.x));",
            "noise(v_position)",
            UNSURE,
        ),
        (
            NOISE + "vec4 fetched() { return texture(u_map, v_uv); }",
            "o_color = vec4(0.0); if (noise(v_position) > 0.5) return; o_color = fetched();",
            "noise(v_position)",
            "SC315",
        ),
        (
            NOISE + "vec4 fetched() { return texture(u_map, v_uv); }",
            "o_color = vec4(0.0); if (noise(v_position) > 0.5) o_color = fetched();",
            "noise(v_position)",
            "SC315",
        ),
    ],
)
def test_verdict_across_functions(declarations: str, body: str, text: str, code: str) -> None:
    node = find(analysed(body, declarations), text)
    assert verdict(node) == code


def test_every_refusal_says_why() -> None:
    analysis = analysed(CASES["conditional branch"][0], NOISE)
    refused = [node for node in analysis.nodes if node.refusal]
    assert refused
    for node in refused:
        assert node.refusal is not None
        assert node.refusal.code.code.startswith("SC3")
        assert len(node.refusal.sentence) > 20
        source = analysis.fragment.text
        assert source[node.expr.span.start : node.expr.span.end].split() == node.text.split()


def test_every_expression_of_every_reached_function_is_a_node() -> None:
    from shadercache.ast import nodes as n
    from shadercache.ast.walk import expressions

    analysis = analysed("o_color = vec4(noise(v_position) + noise(v_normal));", NOISE)
    bodies = {
        d.name: len(list(expressions(d.body)))
        for d in analysis.program.module.decls
        if isinstance(d, n.FunctionDef)
    }
    assert len(analysis.nodes) == bodies["main"] + 2 * bodies["noise"]
