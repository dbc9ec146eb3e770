#version 330 core
in vec2 TexCoord;
out vec4 FragColor;

uniform sampler2D texture1;
uniform float time;

void main() {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 5; ++i) {
        sum += texture(texture1, TexCoord + 0.02 * vec2(float(i), -float(i))).rgb * 0.2;
    }
    FragColor = vec4(sum * (0.9 + 0.1 * sin(time)), 1.0);
}
