"""Shaders with a payload of each type, for the tests of emission and of the laws."""

from __future__ import annotations

from shadercache.analysis.candidates import Candidate
from shadercache.compiler import Analysis, analyse
from shadercache.source import Source

PAYLOADS = {
    # As floats these are a signalling NaN, infinity and two denormal numbers.
    "bits": (
        "uvec4(0x7F800001u, 0x7F800000u, 1u, 2u) << uint(wave.x > 0.0)",
        "vec3(it.x == 0xFF000002u, it.z == 2u, it.w == 4u)",
    ),
    "float": ("wave.x", "vec3(it)"),
    "vec2": ("wave.xy", "it.xyx"),
    "vec3": ("wave.xyz", "it"),
    "vec4": ("wave * wave.yzwx", "it.xyz * it.w"),
    "int": ("int(9.0 * wave.x)", "vec3(it) / 9.0"),
    "uint": ("floatBitsToUint(wave.x) >> 24", "vec3(it & 63u) / 64.0"),
    "ivec2": ("ivec2(5.0 * wave.xy)", "vec3(it, it.x - it.y) / 5.0"),
    "ivec3": ("ivec3(5.0 * wave.xyz)", "vec3(it) / 5.0"),
    "ivec4": ("ivec4(3.0 * wave)", "vec3(it.xyz + it.w) / 5.0"),
    "uvec2": ("uvec2(3.0 + 3.0 * wave.xy)", "vec3(it.xyx) / 6.0"),
    "uvec3": ("uvec3(3.0 + 3.0 * wave.xyz)", "vec3(it) / 6.0"),
    "uvec4": ("uvec4(3.0 + 3.0 * wave)", "vec3(it.xyz * it.w) / 36.0"),
    "bool": ("wave.x * wave.y > 0.0", "(it ? vec3(1.0, 0.5, 0.2) : vec3(0.1))"),
    "bvec2": ("greaterThan(wave.xy, wave.yz)", "vec3(it, it.x != it.y)"),
    "bvec3": ("greaterThan(wave.xyz, wave.yzx)", "vec3(it)"),
    "bvec4": ("greaterThan(wave, vec4(0.1))", "vec3(it.xyz) * (it.w ? 1.0 : 0.5)"),
    "mat2": ("outerProduct(wave.xy, wave.zw)", "vec3(it * wave.xy, it[1][0])"),
    "mat2x3": ("outerProduct(wave.xyz, wave.xy)", "it * wave.xy"),
    "mat3x2": ("outerProduct(wave.xy, wave.xyz)", "wave.xy * it"),
    "Pair": ("Pair(wave.xy, wave.z)", "vec3(it.a, it.b)"),
    "Whole": ("Whole(wave.xyz, wave)", "it.a + it.b.xyz * it.b.w"),
    "Mixed": (
        "Mixed(Pair(wave.xy, wave.z), wave.x > 0.3, ivec2(2.0 * wave.yz), uint(3.0 + wave.x))",
        "vec3(it.pair.a, it.pair.b) * (it.sign ? 1.0 : 0.4) + vec3(it.cell, it.number) / 9.0",
    ),
    "float[5]": (
        "float[5](wave.x, wave.y, wave.z, wave.w, wave.x * wave.y)",
        "vec3(it[0] + it[3], it[1] + it[4], it[2])",
    ),
}
"""Name (the type, but for ``bits``) -> the payload's expression, and a colour made of ``it``."""

DESKTOP = "#version 330"
ES = "#version 300 es\nprecision mediump float;\nprecision mediump int;"

FRAGMENT = """HEAD
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;
struct Pair { vec2 a; float b; };
struct Whole { vec3 a; vec4 b; };
struct Mixed { Pair pair; bool sign; ivec2 cell; uint number; };
void main() {
    vec4 wave = sin(9.0 * v_position.xyzx) * cos(5.0 * v_position.yzxy);
    TYPE it = VALUE;
    o_color = vec4(0.5 + 0.5 * (USE) * normalize(v_normal).z, 1.0);
}
"""

VERTEX = """HEAD
in vec3 a_position;
in vec3 a_normal;
uniform mat4 u_modelViewProjection;
out vec3 v_position;
out vec3 v_normal;
void main() {
    v_position = a_position;
    v_normal = a_normal;
    gl_Position = u_modelViewProjection * vec4(a_position, 1.0);
}
"""


def type_of(name: str) -> str:
    """The payload's type."""
    return "uvec4" if name == "bits" else name


def analysed_payload(name: str, head: str = DESKTOP) -> tuple[Analysis, Candidate]:
    """The shader of that name, and the node that is its payload."""
    value, use = PAYLOADS[name]
    words = {"HEAD": head, "TYPE": type_of(name), "VALUE": value, "USE": use}
    text = FRAGMENT
    for word, meaning in words.items():
        text = text.replace(word, meaning)
    vertex = VERTEX.replace("HEAD", head)
    analysis = analyse(Source("typed.frag", text), Source("typed.vert", vertex))
    node = next(node for node in analysis.nodes if node.text == value)
    assert str(node.type) == type_of(name)
    return analysis, node
