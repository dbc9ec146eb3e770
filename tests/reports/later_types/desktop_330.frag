#version 330
// Structs and their members named like types that GLSL 4.00 and later have, or extensions.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
out vec4 o_color;

struct int64_t { float x; vec2 uint64_t; };
struct atomic_uint { int64_t inner; vec3 i64vec2; };
struct dmat2 { float x; };
struct samplerExternalOES { dmat2 m; };
struct f16vec2 { float x; };

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}

atomic_uint made(vec3 p) {
    return atomic_uint(int64_t(wave(p), p.xy), p);
}

const samplerExternalOES none = samplerExternalOES(dmat2(0.0));

void main() {
    atomic_uint a = made(v_position);
    f16vec2 b = f16vec2(wave(v_normal));
    a.inner.x += b.x + none.m.x;
    o_color = vec4(a.inner.x * a.i64vec2, wave(vec3(a.inner.uint64_t, 1.0)));
}
