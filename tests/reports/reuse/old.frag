#version 120
// An older version.
varying vec3 v_position;
void main() {
    float rings = sin(20.0 * length(v_position.xy)) * exp(v_position.z); // the node
    gl_FragColor = vec4(rings, 0.5 * rings, 1.0 - rings, 1.0);
}
