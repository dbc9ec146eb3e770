#version 300 es
precision highp float;

in vec2 vUv;
in vec3 vNormal;
in vec3 vViewPosition;

uniform sampler2D map;
uniform vec3 diffuse;
uniform float roughness;

out vec4 fragColor;

float grain(vec2 p) {
    float sum = 0.0;
    for (int i = 0; i < 5; ++i) {
        sum += sin(p.x * 9.0 + sin(p.y * 7.0)) * 0.2;
        p = mat2(0.8, 0.6, -0.6, 0.8) * p * 1.7;
    }
    return sum;
}

void main() {
    vec3 n = normalize(vNormal);
    vec3 color = diffuse * texture(map, vUv).rgb * (0.8 + 0.4 * grain(vUv * 3.0));
    float facing = abs(dot(n, normalize(vViewPosition)));
    fragColor = vec4(color * mix(facing, 1.0, 0.3 * roughness), 1.0);
}
