//// 4.20 4.4.6 an image that is read needs a format | ok [420, glslang refuses]
uniform image2D im;
void main() { }
//// 4.20 4.10 writeonly images are not read | ok [420, glslang refuses]
writeonly uniform image2D im;
void main() { imageLoad(im, ivec2(0)); }
//// 4.20 4.10 readonly images are not written | ok [420, glslang refuses]
readonly layout(rgba8) uniform image2D im;
void main() { imageStore(im, ivec2(0), vec4(1.0)); }
//// 4.20 4.10 an argument keeps its qualifiers | ok [420, glslang refuses]
writeonly uniform image2D im;
void f(image2D i) { }
void main() { f(im); }
//// 4.30 4.10 readonly buffers are not written | ok [430, glslang refuses]
readonly buffer B { float a[]; };
void main() { a[1] = 2.0; }
//// 4.30 4.10 readonly members are not written | ok [430, glslang refuses]
buffer B { readonly float a; float b; };
void main() { b = 1.0; a = 2.0; }
//// 4.30 8.11 atomic functions are for buffers | ok [430, glslang refuses]
void main() { int n; atomicAdd(n, 1); }
//// 4.20 4.4.6 a format is of the sort of the image | ok [420, glslang refuses]
layout(r32ui) uniform iimage2D im;
void main() { }
//// 4.20 4.10 samplers have no memory qualifiers | ok [420, glslang refuses]
readonly uniform sampler2D s;
void main() { }
//// 4.60 4.4.2 strides of a buffer agree | ok [450 vertex, glslang refuses]
layout(xfb_stride = 20, xfb_buffer = 0) out;
layout(xfb_buffer = 0) out A { vec4 a; };
layout(xfb_stride = 32) out B { vec4 b; };
void main() { }
//// 4.60 4.4.2 the last stride counts | ok [450 vertex, glslang refuses]
layout(xfb_stride = 20, xfb_stride = 32) out A { vec4 a; };
layout(xfb_buffer = 0, xfb_stride = 20) out B { vec4 b; };
void main() { }
//// 4.60 4.4.2 members go to the buffer of their block | ok [450 vertex, glslang refuses]
layout(xfb_buffer = 2) out;
layout(xfb_buffer = 1) out A { layout(xfb_buffer = 1) vec4 a; };
out B { layout(xfb_buffer = 2) vec4 b; };
out C { layout(xfb_buffer = 1) vec4 c; };
void main() { }
//// 4.60 4.4.2 offsets are multiples of the size of a component | ok [450 vertex, glslang refuses]
struct S { double d; };
layout(xfb_offset = 2) out vec4 a;
layout(xfb_offset = 36) out S s;
void main() { }
//// ES 3.10 4.9 most images are read or written | ok [310 es glslang refuses]
layout(rgba8) uniform mediump image2D a;
layout(rgba8) uniform mediump readonly image2D b;
layout(r32f) uniform mediump image2D c;
void main() { }
//// 4.60 4.10 a readonly member of a named block | ok [450, glslang refuses]
buffer B { readonly float f; float g; } b[2];
void main() { b[0].g = 1.0; b[1].f = 1.0; }
//// ARB_fragment_shader_interlock: under no condition | ok [450, glslang refuses]
#extension GL_ARB_fragment_shader_interlock : enable
void main() { if (true) beginInvocationInterlockARB(); endInvocationInterlockARB(); }
//// ARB_fragment_shader_interlock: in this order | ok [450, glslang refuses]
#extension GL_ARB_fragment_shader_interlock : enable
void main() { endInvocationInterlockARB(); beginInvocationInterlockARB(); }
//// ARB_fragment_shader_interlock: before a return | ok [450, glslang refuses]
#extension GL_ARB_fragment_shader_interlock : enable
void main() { if (true) return; beginInvocationInterlockARB(); endInvocationInterlockARB(); }
//// 4.60 4.4.6.1 atomic counters have a binding | ok [450, glslang refuses]
uniform atomic_uint x;
void main() { }
//// 4.60 4.4.6.1 offsets of counters are multiples of 4 | ok [450, glslang refuses]
layout(binding = 0, offset = 3) uniform atomic_uint x;
void main() { }
//// 4.60 4.4.6.1 counters do not share an offset | ok [450, glslang refuses]
layout(binding = 0) uniform atomic_uint x[3], y;
layout(binding = 0, offset = 8) uniform atomic_uint z;
void main() { }
//// 4.60 4.4.6.1 the offset of the next counter | ok [450, glslang refuses]
layout(binding = 0, offset = 8) uniform atomic_uint;
layout(binding = 0) uniform atomic_uint y;
layout(binding = 0, offset = 8) uniform atomic_uint z;
void main() { }
//// 4.60 4.4.2 feedback is of outputs of vertex shaders | ok [450, glslang refuses]
layout(xfb_stride = 16) out;
void main() { }
