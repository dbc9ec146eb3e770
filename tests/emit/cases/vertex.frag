//// A twin does not share the place of its original.
//// node: sin(v_position * 12.9) * cos(v_position)
//// shows: 3-pass.reuse.vert
#version 330

uniform sampler2D u_map;
uniform vec3 u_tint;
uniform float u_time;
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
out vec4 o_color;

void main() {
    o_color = vec4(sin(v_position * 12.9) * cos(v_position), 1.0);
}
//// vertex
#version 430

layout(std140, binding = 1) uniform Camera {
    mat4 view;
};

layout(location = 2) uniform float u_sway;
in vec3 a_position;
out vec3 v_position;
out vec3 v_normal;
out vec2 v_uv;

void main() {
    v_position = a_position;
    v_normal = a_position;
    v_uv = a_position.xy;
    gl_Position = view * vec4(a_position * u_sway, 1.0);
}
//// becomes
#version 430
// shadercache: 3-pass.reuse, node main.3-fddef76e

invariant gl_Position;
out vec4 sc_current;
out vec4 sc_previous;

layout(std140, binding = 1) uniform Camera {
    mat4 view;
};

layout(location = 2) uniform float u_sway;
in vec3 a_position;

void sc_vertex() {
    gl_Position = view * vec4(a_position * u_sway, 1.0);
}

layout(binding = 2, std140) uniform sc_previous_Camera {
    mat4 sc_previous_view;
};

uniform float sc_previous_u_sway;

void sc_vertex_previous() {
    sc_previous = sc_previous_view * vec4(a_position * sc_previous_u_sway, 1.0);
}

void main() {
    sc_vertex();
    sc_current = gl_Position;
    sc_vertex_previous();
}

//// Interface blocks meet by their block names, and the previous position's slice writes to a block of its own.
//// node: sin(s.position * s.normal) * cos(s.position)
//// shows: original.vert
//// shows: 3-pass.reuse.vert
#version 330

in Surface {
    vec3 position;
    vec3 normal;
} s;

in Extra {
    vec3 tone;
};

out vec4 o_color;

void main() {
    o_color = vec4(sin(s.position * s.normal) * cos(s.position) * tone, 1.0);
}
//// vertex
#version 330

uniform mat4 u_m;
uniform float u_sway;
in vec3 a_position;

out Surface {
    vec3 position;
    vec3 normal;
} o;

out Extra {
    vec3 tone;
};

void main() {
    o.position = a_position * u_sway;
    o.normal = a_position;
    tone = o.position;
    gl_Position = u_m * vec4(o.position, 1.0);
}
//// becomes
#version 330
// shadercache: original, node main.4-6eae0ed1

uniform mat4 u_m;
uniform float u_sway;
in vec3 a_position;

out Surface {
    vec3 position;
    vec3 normal;
} o;

out Extra {
    vec3 tone;
};

void main() {
    o.position = a_position * u_sway;
    o.normal = a_position;
    tone = o.position;
    gl_Position = u_m * vec4(o.position, 1.0);
}

#version 330
// shadercache: 3-pass.reuse, node main.4-6eae0ed1

invariant gl_Position;
out vec4 sc_current;
out vec4 sc_previous;
uniform mat4 u_m;
uniform float u_sway;
in vec3 a_position;

out Surface {
    vec3 position;
    vec3 normal;
} o;

void sc_vertex() {
    o.position = a_position * u_sway;
    o.normal = a_position;
    gl_Position = u_m * vec4(o.position, 1.0);
}

uniform mat4 sc_previous_u_m;
uniform float sc_previous_u_sway;

out sc_previous_Surface {
    vec3 position;
    vec3 normal;
} sc_previous_o;

void sc_vertex_previous() {
    sc_previous_o.position = a_position * sc_previous_u_sway;
    sc_previous_o.normal = a_position;
    sc_previous = sc_previous_u_m * vec4(sc_previous_o.position, 1.0);
}

void main() {
    sc_vertex();
    sc_current = gl_Position;
    sc_vertex_previous();
}

//// Twins of functions, a changing global and a block.
//// node: sin(v_position * 12.9) * cos(v_position)
//// shows: 2-pass.hit.vert
//// shows: 3-pass.payload.vert
#version 330

uniform sampler2D u_map;
uniform vec3 u_tint;
uniform float u_time;
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
out vec4 o_color;

void main() {
    o_color = vec4(sin(v_position * 12.9) * cos(v_position), 1.0);
}
//// vertex
#version 330

layout(std140) uniform Camera {
    mat4 view;
    mat4 projection;
};

uniform float u_sway;
uniform mat4 u_unrelated;
const float HALF = 0.5;
float amount;
in vec3 a_position;
in vec3 a_normal;
out vec3 v_position;
out vec3 v_normal;
out vec2 v_uv;

vec3 sway(vec3 p) {
    amount = u_sway * HALF;
    p.x += amount;
    return p;
}

void main() {
    vec3 p = sway(a_position);
    v_position = p;
    v_normal = mat3(u_unrelated) * a_normal;
    v_uv = p.xy;
    gl_Position = projection * view * vec4(p, 1.0);
    gl_Position.z -= 0.001;
    gl_PointSize = 2.0;
}
//// becomes
#version 330
// shadercache: 2-pass.hit, node main.3-fddef76e

invariant gl_Position;
out vec4 sc_current;
out vec4 sc_previous;

layout(std140) uniform Camera {
    mat4 view;
    mat4 projection;
};

uniform float u_sway;
const float HALF = 0.5;
float amount;
in vec3 a_position;

vec3 sway(vec3 p) {
    amount = u_sway * HALF;
    p.x += amount;
    return p;
}

void sc_vertex() {
    vec3 p = sway(a_position);
    gl_Position = projection * view * vec4(p, 1.0);
    gl_Position.z -= 0.001;
    gl_PointSize = 2.0;
}

layout(std140) uniform sc_previous_Camera {
    mat4 sc_previous_view;
    mat4 sc_previous_projection;
};

uniform float sc_previous_u_sway;
float sc_previous_amount;

vec3 sc_previous_sway(vec3 p) {
    sc_previous_amount = sc_previous_u_sway * HALF;
    p.x += sc_previous_amount;
    return p;
}

void sc_vertex_previous() {
    vec3 p = sc_previous_sway(a_position);
    sc_previous = sc_previous_projection * sc_previous_view * vec4(p, 1.0);
    sc_previous.z -= 0.001;
}

void main() {
    sc_vertex();
    sc_current = gl_Position;
    sc_vertex_previous();
}

#version 330
// shadercache: 3-pass.payload, node main.3-fddef76e

invariant gl_Position;
out vec4 sc_current;

layout(std140) uniform Camera {
    mat4 view;
    mat4 projection;
};

uniform float u_sway;
const float HALF = 0.5;
float amount;
in vec3 a_position;
out vec3 v_position;

vec3 sway(vec3 p) {
    amount = u_sway * HALF;
    p.x += amount;
    return p;
}

void sc_vertex() {
    vec3 p = sway(a_position);
    v_position = p;
    gl_Position = projection * view * vec4(p, 1.0);
    gl_Position.z -= 0.001;
    gl_PointSize = 2.0;
}

void main() {
    sc_vertex();
    sc_current = gl_Position;
}

//// Twins of an early return.
//// node: sin(v_position * 12.9) * cos(v_position)
//// shows: 2-pass.hit.vert
//// shows: 3-pass.payload.vert
#version 330

uniform sampler2D u_map;
uniform vec3 u_tint;
uniform float u_time;
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
out vec4 o_color;

void main() {
    o_color = vec4(sin(v_position * 12.9) * cos(v_position), 1.0);
}
//// vertex
#version 330

uniform mat4 u_m;
uniform bool u_flat;
in vec3 a_position;
out vec3 v_position;
out vec3 v_normal;
out vec2 v_uv;

void main() {
    v_position = a_position;
    v_normal = a_position;
    v_uv = a_position.xy;
    gl_Position = u_m * vec4(a_position, 1.0);
    if (u_flat)
        return;
    gl_Position.x *= 2.0;
}
//// becomes
#version 330
// shadercache: 2-pass.hit, node main.3-fddef76e

invariant gl_Position;
out vec4 sc_current;
out vec4 sc_previous;
uniform mat4 u_m;
uniform bool u_flat;
in vec3 a_position;

void sc_vertex() {
    gl_Position = u_m * vec4(a_position, 1.0);
    if (u_flat)
        return;
    gl_Position.x *= 2.0;
}

uniform mat4 sc_previous_u_m;
uniform bool sc_previous_u_flat;

void sc_vertex_previous() {
    sc_previous = sc_previous_u_m * vec4(a_position, 1.0);
    if (sc_previous_u_flat)
        return;
    sc_previous.x *= 2.0;
}

void main() {
    sc_vertex();
    sc_current = gl_Position;
    sc_vertex_previous();
}

#version 330
// shadercache: 3-pass.payload, node main.3-fddef76e

invariant gl_Position;
out vec4 sc_current;
uniform mat4 u_m;
uniform bool u_flat;
in vec3 a_position;
out vec3 v_position;

void sc_vertex() {
    v_position = a_position;
    gl_Position = u_m * vec4(a_position, 1.0);
    if (u_flat)
        return;
    gl_Position.x *= 2.0;
}

void main() {
    sc_vertex();
    sc_current = gl_Position;
}
