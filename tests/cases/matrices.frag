#version 330
// Matrices as values, built, multiplied, indexed, transposed and inverted.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


mat3 frame(vec3 n) {
    vec3 t = normalize(cross(n, vec3(0.3, 0.9, 0.1)));
    return mat3(t, cross(n, t), n);
}

mat2 turn(float angle) { return mat2(cos(angle), sin(angle), -sin(angle), cos(angle)); }

void main() {
    mat3 basis = frame(normalize(v_normal));
    mat2 r = turn(wave(v_position));
    vec2 uv = r * v_uv;
    vec3 local = transpose(basis) * u_light;
    mat2 m = inverse(r) * turn(0.5) + outerProduct(v_uv, uv);
    mat3x2 wide = mat3x2(uv, v_uv, m[0]);
    mat3 back = matrixCompMult(basis, frame(u_light));
    o_color = vec4(wide * local, determinant(m), wave(back[1]));
}
