#version 120
// Structs and their members named like types that GLSL 1.30 and later have.
varying vec3 v_position;
varying vec3 v_normal;
varying vec2 v_uv;

struct uint { float x; vec2 sampler2DMSArray; };
struct dmat2 { uint inner; vec3 image2D; };
struct f16vec2 { float x; };

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}

dmat2 made(vec3 p) {
    return dmat2(uint(wave(p), p.xy), p);
}

void main() {
    dmat2 a = made(v_position);
    f16vec2 b = f16vec2(wave(v_normal));
    a.inner.x += b.x;
    gl_FragColor = vec4(a.inner.x * a.image2D, wave(vec3(a.inner.sampler2DMSArray, 1.0)));
}
