#version 300 es
precision highp float;

in vec2 vUv;
in mediump vec3 vNormal;
in vec3 vViewPosition;

uniform sampler2D map;
uniform vec3 diffuse;

out vec4 fragColor;

void main() {
    float facing = abs(dot(normalize(vNormal), normalize(vViewPosition)));
    float rings = 0.6 + 0.4 * sin(40.0 * length(fract(vUv) - 0.5));
    fragColor = vec4(diffuse * texture(map, vUv).rgb * rings * facing, 1.0);
}
