#version 330
in vec3 v_position;
in vec3 v_normal;
uniform samplerCube u_cube;
out vec4 o_color;
void main() {
    vec3 n = sin(exp(v_position) * 3.0);
    o_color = 3.0 * textureLod(u_cube, n, 0.0) + textureLod(u_cube, vec3(0.3, n.x, v_normal.x), 0.0);
}
