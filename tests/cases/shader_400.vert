#version 400
in vec3 a_position;
in vec3 a_normal;
in vec2 a_uv;
uniform mat4 u_modelViewProjection;
flat out vec3 v_flat;
centroid out vec3 v_centre;
noperspective out vec2 v_linear;

void main() {
    v_flat = a_position;
    v_centre = a_normal;
    v_linear = a_uv;
    gl_Position = u_modelViewProjection * vec4(a_position, 1.0);
}
