#version 420 core
in vec3 a_position;
in vec3 a_normal;
uniform mat4 u_modelViewProjection;
uniform vec3 u_shift;
out vec3 v_normal;

void main() {
    vec3 moved[2] = { { a_position.x, a_position.y, a_position.z }, u_shift };
    mat4 rows = { u_modelViewProjection[0], u_modelViewProjection[1], u_modelViewProjection[2],
                  { u_modelViewProjection[3].x, u_modelViewProjection[3].y, 0.0, 1.0 } };
    vec4 at = { moved[0].x + moved[1].x, moved[0].y, moved[0].z, 1 };
    v_normal = a_normal;
    gl_Position = rows * at;
}
