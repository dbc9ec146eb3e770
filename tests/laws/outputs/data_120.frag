#version 120
// gl_FragData, two of them.

varying vec3 p;
varying vec3 n;

float noise(vec3 q) {
    return sin(q.x * 9.0) * cos(q.y * 7.0 + sin(q.z * 5.0));
}

void main() {
    float grain = noise(p);
    gl_FragData[0] = vec4(vec3(0.5 + 0.5 * grain * n.z), 1.0);
    gl_FragData[1] = vec4(grain, n);
}
