precision highp float;
in vec3 v_position;
out vec4 colour;

void main() {
    colour = vec4(exp(sin(v_position * 9.0)), 1.0);
}
