#version 410 core
#define VARIES in
VARIES vec3 FragPos;
in vec3 v_normal;
layout(location = 3) in vec2 uv;
flat in int unread;
in vec4 vertexColor;

uniform vec3 u_eye;
uniform mat4 u_model;
uniform vec3 lightDir;
uniform float a_position;

out vec4 color;

float bands(vec2 p) {
    float sum = 0.0;
    for (int i = 1; i < 5; ++i) sum += sin(p.x * 7.0 * float(i) + sin(p.y * 3.0)) / float(i);
    return sum;
}

void main() {
    vec3 normal = normalize(v_normal);
    float light = 0.3 + max(dot(normal, lightDir), 0.0) + 0.0 * a_position * u_model[0].x;
    float edge = dot(normal, normalize(u_eye - FragPos));
    color = vec4((0.6 + 0.2 * bands(uv)) * light * edge * vertexColor.rgb, 1.0);
}
