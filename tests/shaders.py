"""Small shaders for tests: a fragment shader is written as its body, with declarations."""

from __future__ import annotations

from shadercache.analysis.candidates import Candidate
from shadercache.compiler import Analysis, analyse
from shadercache.source import Source

INTERFACE = """#version 330
uniform sampler2D u_map;
uniform vec3 u_tint;
uniform float u_time;
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
out vec4 o_color;
"""

VERTEX = """#version 330
in vec3 a_position;
in vec3 a_normal;
uniform mat4 u_modelViewProjection;
out vec3 v_position;
out vec3 v_normal;
out vec2 v_uv;
void main() {
    v_position = a_position;
    v_normal = a_normal;
    v_uv = a_position.xy;
    gl_Position = u_modelViewProjection * vec4(a_position, 1.0);
}
"""


def fragment(body: str, declarations: str = "") -> Source:
    """A fragment shader with :data:`INTERFACE`, further declarations and ``main``'s body."""
    return Source("test.frag", f"{INTERFACE}{declarations}\nvoid main() {{\n{body}\n}}\n")


def analysed(body: str, declarations: str = "") -> Analysis:
    """The analysis of such a shader with :data:`VERTEX`."""
    return analyse(fragment(body, declarations), Source("test.vert", VERTEX))


def find(analysis: Analysis, text: str, path: str | None = None) -> Candidate:
    """The first node whose expression is written ``text`` (and whose path ends in ``path``)."""
    found = [
        node
        for node in analysis.nodes
        if node.text == text and (path is None or node.path.endswith(path))
    ]
    assert found, f"no node {text!r}; there are: {sorted({n.text for n in analysis.nodes})}"
    return found[0]
