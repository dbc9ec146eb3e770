#version 400
in vec3 a_position;
uniform mat4 u_matrix;
uniform vec4 u_tint;

//// What is uniform is hidden.
out vec4 v_tint;
void main() {
    gl_Position = u_matrix * vec4(a_position, 1.0);
    v_tint = u_tint;
}
//// becomes
#version 400

in vec3 a_position;
uniform mat4 u_matrix;
uniform vec4 u_tint;
out vec4 v_tint;

void sc_main() {
    gl_Position = u_matrix * vec4(a_position, 1.0);
    v_tint = u_tint;
}

void main() {
    sc_main();
    if (gl_VertexID < 0) {
        v_tint = -v_tint;
    }
}

//// Constants are uniform, and so are matrices.
out float v_a;
out mat2 v_b;
void main() {
    gl_Position = u_matrix * vec4(a_position, 1.0);
    v_a = 0.5;
    v_b = mat2(u_tint);
}
//// becomes
#version 400

in vec3 a_position;
uniform mat4 u_matrix;
uniform vec4 u_tint;
out float v_a;
out mat2 v_b;

void sc_main() {
    gl_Position = u_matrix * vec4(a_position, 1.0);
    v_a = 0.5;
    v_b = mat2(u_tint);
}

void main() {
    sc_main();
    if (gl_VertexID < 0) {
        v_a = -v_a;
        v_b = -v_b;
    }
}

//// What is uniform by way of a global variable and a return.
out vec4 v_tint;
vec4 g;
void main() {
    gl_Position = u_matrix * vec4(a_position, 1.0);
    g = u_tint;
    v_tint = g;
    if (g.x > 0.0)
        return;
    v_tint *= 2.0;
}
//// becomes
#version 400

in vec3 a_position;
uniform mat4 u_matrix;
uniform vec4 u_tint;
out vec4 v_tint;
vec4 g;

void sc_main() {
    gl_Position = u_matrix * vec4(a_position, 1.0);
    g = u_tint;
    v_tint = g;
    if (g.x > 0.0)
        return;
    v_tint *= 2.0;
}

void main() {
    sc_main();
    if (gl_VertexID < 0) {
        v_tint = -v_tint;
    }
}

//// What an attribute is part of varies.
out vec4 v_tint;
void main() {
    gl_Position = u_matrix * vec4(a_position, 1.0);
    v_tint = u_tint * a_position.x;
}
//// becomes
#version 400

in vec3 a_position;
uniform mat4 u_matrix;
uniform vec4 u_tint;
out vec4 v_tint;

void main() {
    gl_Position = u_matrix * vec4(a_position, 1.0);
    v_tint = u_tint * a_position.x;
}

//// What an attribute decides on varies.
out vec4 v_tint;
vec3 g;
void main() {
    gl_Position = u_matrix * vec4(a_position, 1.0);
    g = a_position;
    v_tint = u_tint;
    if (g.x > 0.0)
        v_tint.x = 1.0;
}
//// becomes
#version 400

in vec3 a_position;
uniform mat4 u_matrix;
uniform vec4 u_tint;
out vec4 v_tint;
vec3 g;

void main() {
    gl_Position = u_matrix * vec4(a_position, 1.0);
    g = a_position;
    v_tint = u_tint;
    if (g.x > 0.0)
        v_tint.x = 1.0;
}

//// What the number of the vertex is in varies.
out float v_number;
void main() {
    gl_Position = u_matrix * vec4(a_position, 1.0);
    v_number = float(gl_VertexID);
}
//// becomes
#version 400

in vec3 a_position;
uniform mat4 u_matrix;
uniform vec4 u_tint;
out float v_number;

void main() {
    gl_Position = u_matrix * vec4(a_position, 1.0);
    v_number = float(gl_VertexID);
}

//// What is flat stays.
flat out vec4 v_tint;
void main() {
    gl_Position = u_matrix * vec4(a_position, 1.0);
    v_tint = u_tint;
}
//// becomes
#version 400

in vec3 a_position;
uniform mat4 u_matrix;
uniform vec4 u_tint;
flat out vec4 v_tint;

void main() {
    gl_Position = u_matrix * vec4(a_position, 1.0);
    v_tint = u_tint;
}

//// A whole number stays.
flat out int v_number;
void main() {
    gl_Position = u_matrix * vec4(a_position, 1.0);
    v_number = 3;
}
//// becomes
#version 400

in vec3 a_position;
uniform mat4 u_matrix;
uniform vec4 u_tint;
flat out int v_number;

void main() {
    gl_Position = u_matrix * vec4(a_position, 1.0);
    v_number = 3;
}
