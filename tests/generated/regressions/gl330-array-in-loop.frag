#version 330
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;

void fill(out float values[3], float start) {
    for (int i = 0; i < 3; i++) {
        values[i] = start * float(i + 1);
    }
}

void main() {
    float c[3];
    fill(c, sin(v_position.x * 3.0) * cos(v_normal.y * 5.0));
    o_color = vec4(sin(v_position * 4.0) * c[1], c[2]);
}
