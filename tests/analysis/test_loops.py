"""Which loops run for longer or shorter with other values of a variable."""

from __future__ import annotations

import pytest

from shadercache.analysis.dataflow import LOOPS
from shadercache.analysis.loops import decided_loops
from shadercache.ast.walk import walk
from shadercache.front.parse import parse
from shadercache.source import Source

DECIDED = [
    "for (float t = 0.0; t < 2.0; t += x) s += t;",
    "for (int i = 0; i < int(x); i++) s += 1.0;",
    "while (true) { if (s > x) break; s += 1.0; }",
    "while (s < 9.0) { if (s > x) continue; s += 1.0; }",
    "do { s += 1.0; } while (s < x);",
    "float a = x; float b = a * 2.0; while (s < b) s += 1.0;",
    "while (s < twice(x)) s += 1.0;",
    "while (s < kept()) s += 1.0;",
    "float a = 1.0; if (x > 0.5) a = 2.0; while (s < a) s += 1.0;",
    "float a = 1.0; switch (int(x)) { case 1: a = 2.0; } while (s < a) s += 1.0;",
    "float a; store(a, x); while (s < a) s += 1.0;",
    "float a; modf(x, a); while (s < a) s += 1.0;",
    "int i = 0; float a = x > 0.5 ? float(i++) : 1.0; while (i < 4) i++;",
    "int i = 0; bool a = x > 0.5 && i++ > 0; while (i < 4) i++;",
    "vec2 v = vec2(0.0); v.x = x; while (v.y < 1.0) v.y += v.x;",
    "int i = 0; for (float t = 0.0; t < 1.0; t += x) i++; while (i < 9) i++;",
    "float a = 1.0; early(a, x); while (s < a) s += 1.0;",
    "float a = 1.0; chosen(a, x); while (s < a) s += 1.0;",
    "float a = 1.0; switch (1) { case 1: if (x > 0.5) break; a = 2.0; } while (s < a) s += 1.0;",
    "float a; if (x > 0.5) { a = 1.0; if (y > 0.5) a = 2.0; while (s < a) s += a * x; "
    "while (s < a) { s += 1.0; a -= x; } }",
    "float sum = x; while (s < noise(sum)) s += 1.0;",
]
NOT_DECIDED = [
    "for (int i = 0; i < 4; i++) s += x;",
    "for (int i = 0; i < 4; i++) s += x * float(i++);",
    "float a = x; while (s < 2.0) { s += 1.0; a *= 2.0; }",
    "while (s < twice(y)) s += 1.0;",
    "for (float t = 0.0; t < 2.0; t += x) s += dFdx(t);",
    "if (x > 0.5) { for (int i = 0; i < 4; i++) s += x; }",
    "if (x > 0.5) { float a = 1.0; float b = 0.0; while (b < a) b += 1.0; s += b; }",
    "float sum = x; s += noise(sum); { float b = octaves(y); }",
]
"""The last one has a derivative in it: what decides on that is refused as a payload."""

HELPERS = """#version 330
in float x; in float y; out vec4 color;
float g;
float twice(float p) { return 2.0 * p; }
float kept() { return g; }
void store(out float r, float p) { r = p; }
void chosen(inout float r, float p) {
    switch (2) { case 1: break; case 2: { if (p > 0.5) return; } r = 2.0; }
}
float noise(float p) { float sum = 2.0 * p; return sum; }
float octaves(float p) {
    float sum = p;
    for (int i = 0; i < 4; i++) { sum += float(i); }
    float far = 0.5;
    if (sum > p) { return sum; }
    while (far < 4.0) { far *= 2.0; }
    return sum + far;
}
void early(inout float r, float p) { if (p > 0.5) return; r = 2.0; }
"""


def decided(body: str) -> list[bool]:
    """For each loop of ``main``, whether ``x`` decides on it."""
    module = parse(Source("loops.frag", f"{HELPERS}void main() {{ float s = y; g = x; {body} }}"))
    found = decided_loops(module, ["x"])
    return [item in found for item in walk(module) if isinstance(item, LOOPS)]


@pytest.mark.parametrize("body", DECIDED)
def test_decided(body: str) -> None:
    assert decided(body)[-1]


@pytest.mark.parametrize("body", NOT_DECIDED)
def test_not_decided(body: str) -> None:
    assert decided(body)
    assert not any(decided(body))
