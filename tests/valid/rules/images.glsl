//// 4.20 8.12 images are read and written | ok [420]
layout(r32i) uniform iimage2D im;
layout(rgba8, binding = 3) writeonly uniform image2D w;
void main() { int i = imageLoad(im, ivec2(0)).x; imageStore(w, ivec2(1), vec4(i)); imageAtomicAdd(im, ivec2(0), 3); }
//// 4.20 4.10 an argument may get qualifiers | ok [420]
writeonly uniform image2D im;
void f(coherent writeonly image2D i) { }
void main() { f(im); }
//// 4.30 4.3.7 buffers are read and written | ok [430]
layout(std430, binding = 0) buffer B { int n; float a[]; } b;
void main() { b.a[b.n] = float(b.a.length()); atomicAdd(b.n, 1); }
//// 4.30 4.3.7 buffers are blocks | SC221 [430]
buffer int n;
void main() { }
//// 4.20 4.3.7 no buffers | SC221 [420]
#extension GL_ARB_shading_language_420pack : enable
uniform B { float a; };
in B2 { float a2; };
out B3 { float a3; };
void main() { }
//// 4.20 8.10 atomic counters | ok [420]
layout(binding = 0, offset = 4) uniform atomic_uint a;
void main() { uint u = atomicCounterIncrement(a) + atomicCounter(a); memoryBarrier(); }
//// ES 3.10 4.9 images and buffers | ok [310 es]
layout(rgba8) readonly uniform highp image2D im;
layout(std430) buffer B { float a[]; };
void main() { a[0] = imageLoad(im, ivec2(0)).x; }
//// ES 3.10 4.1.9 only the end of a buffer has no size | SC215 [310 es]
buffer B { float a[]; float b; };
void main() { }
//// 4.10 7.1 gl_PerVertex is redeclared | ok [410 vertex]
out gl_PerVertex { vec4 gl_Position; float gl_ClipDistance[3]; };
void main() { gl_Position = vec4(0.0); gl_ClipDistance[2] = 1.0; }
//// 4.10 7.1 gl_PerVertex with what it has | SC202 [410 vertex]
out gl_PerVertex { vec4 other; };
void main() { }
//// 3.30 7.1 gl_PerVertex is as it is | SC221 [330 vertex]
out gl_PerVertex { vec4 gl_Position; };
void main() { }
