#version 120
varying vec3 position, normal;
varying mat3 TBN;
varying vec4 tangent;

uniform float time;

void main() {
    vec3 cells = sin(position * 12.0 + 0.1 * time) * cos(position.zxy * 7.0);
    float light = 0.4 + 0.4 * (TBN * vec3(0.0, 0.0, 1.0)).y + 0.1 * normal.x * tangent.x;
    gl_FragColor = vec4((0.6 + 0.3 * cells) * light, 1.0);
}
