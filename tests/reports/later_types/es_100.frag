#version 100
// Structs and their members named like types that GLSL ES 3.00 and later have, or extensions.
precision highp float;
varying vec3 v_position;
varying vec3 v_normal;
varying vec2 v_uv;

struct uint { float x; vec2 usampler2D; };
struct image2D { uint inner; vec3 isamplerCube; };
struct samplerExternalOES { float x; };

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}

image2D made(vec3 p) {
    return image2D(uint(wave(p), p.xy), p);
}

void main() {
    image2D a = made(v_position);
    samplerExternalOES b = samplerExternalOES(wave(v_normal));
    a.inner.x += b.x;
    gl_FragColor = vec4(a.inner.x * a.isamplerCube, wave(vec3(a.inner.usampler2D, 1.0)));
}
