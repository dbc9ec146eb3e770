//// 4.60 4.4 a word has a value or has none | SC223 SC223 [450]
layout(binding) uniform sampler2D s;
layout(early_fragment_tests = 1) in;
void main() { }
//// 4.60 4.4 small letters and capitals | ok [450]
layout(LocatioN = 3) in vec4 p;
void main() { }
//// ES 3.00 4.3.8 small letters and capitals | ok [es vertex]
layout(LocatioN = 3) in vec4 p;
void main() { }
//// 4.60 4.4 the set of Vulkan is 0 | SC223 [450]
layout(set = 0, binding = 1) uniform sampler2D a;
layout(set = 1, binding = 1) uniform sampler2D b;
void main() { }
//// 4.60 4.4 the last of the same words counts | ok [450]
layout(location = 1, location = 2) out vec4 a;
layout(location = 1) out vec4 b;
void main() { }
//// 4.60 4.4.1 locations stand on what is passed or set | SC223 SC223 [450]
layout(location = 1) float a;
layout(location = 1) const float b = 1.0;
void main() { }
//// 4.60 4.4.1 a local variable has no layout | SC223 [450]
void main() { layout(location = 1) float a; }
//// 4.60 4.4 a parameter has no layout | SC223 [450]
void f(layout(location = 0) float x) { }
void main() { }
//// 4.60 4.1.8 a field has no layout | SC223 [450]
struct S { layout(location = 0) float x; };
void main() { }
//// 4.60 4.4.1 component needs location | SC223 [450]
layout(component = 1) in float x;
void main() { }
//// 4.60 4.4.1 no component of a matrix | SC223 [450]
layout(location = 1, component = 1) in mat2 x;
void main() { }
//// 4.60 4.4.1 a double starts at component 0 or 2 | SC223 [450 vertex]
layout(location = 1, component = 2) out double a;
layout(location = 2, component = 1) out double b;
void main() { }
//// 4.60 4.4.1 dvec3 has no component | SC223 [450]
layout(location = 1, component = 0) flat in dvec3 x;
void main() { }
//// 4.60 4.4.1 a vector fits behind its component | SC223 [450]
layout(location = 0, component = 2) in vec2 a;
layout(location = 1, component = 3) in vec2 b;
void main() { }
//// 4.60 4.4.1 all members have a location or none | SC223 [450]
in B { layout(location = 1) float x; float y; };
void main() { }
//// 4.60 4.4.1 the block has the location | ok [450]
layout(location = 1) in B { float x; layout(location = 7) float y; };
void main() { }
//// 4.60 4.4.1 uniform blocks have no location | SC223 SC223 [450]
layout(location = 1) uniform B { float x; };
uniform C { layout(location = 1) float y; };
void main() { }
//// 4.60 4.4.2 index needs location | SC223 [450]
layout(index = 1) out vec4 x;
void main() { }
//// 4.60 4.4.2 index is 0 or 1 | SC223 [450]
layout(location = 1, index = 2) out vec4 x;
void main() { }
//// 4.60 4.4.2 index is for outputs | SC223 [450]
layout(location = 1, index = 1) in vec4 x;
void main() { }
//// 4.60 4.4.2 outputs that share a location hold one sort | SC223 [450]
layout(location = 1, component = 0) out float x;
layout(location = 1, component = 1) out int y;
void main() { }
//// 4.60 4.4.2 depths are for gl_FragDepth | SC223 [450]
layout(depth_any) out float gl_FragDepth;
layout(depth_any) out float x;
void main() { }
//// 4.60 4.4.1 early tests are for inputs of fragment shaders | SC223 [450]
layout(early_fragment_tests) in;
layout(early_fragment_tests) out;
void main() { }
//// 4.60 4.4.1 early tests are not for vertex shaders | SC223 [450 vertex]
layout(early_fragment_tests) in;
void main() { }
//// 4.60 4.4.3 uniforms do not share locations | SC223 [450]
layout(location = 1) uniform float x[2];
layout(location = 2) uniform float y;
void main() { }
//// 4.60 4.4.3 a matrix is one uniform | ok [450]
layout(location = 1) uniform mat4 x;
layout(location = 2) uniform float y;
void main() { }
//// 4.60 4.4.4 attributes share locations | ok [450 vertex]
layout(location = 1) in float x;
layout(location = 1) in float y;
void main() { }
//// 4.60 4.4.5 packings are of blocks | SC223 SC223 [450]
layout(std140) uniform float x;
layout(std140) in B { float y; };
void main() { }
//// 4.60 4.4.5 std430 is of buffers | SC223 [450]
layout(std430) uniform B { float x; };
layout(std430) buffer C { float y; };
void main() { }
//// 4.60 4.4.5 offsets need std140 or std430 | SC223 [450]
uniform A { layout(offset = 8) float a; };
void main() { }
//// 4.60 4.4.5 the default packing counts | ok [450]
layout(std140) uniform;
uniform A { layout(offset = 8) float a; };
void main() { }
//// 4.60 4.4.5 offsets grow | SC223 [450]
layout(std140) uniform A { layout(offset = 8) float a; layout(offset = 4) float b; };
void main() { }
//// 4.60 4.4.5 an offset is a multiple of the alignment | SC223 SC223 [450]
layout(std140) uniform A { layout(offset = 8) vec3 a; };
layout(std140) uniform B { layout(offset = 8) float b[2]; };
layout(std430) buffer C { layout(offset = 8) float c[2]; };
void main() { }
//// 4.60 4.4.5 alignments are powers of 2 | SC223 [450]
layout(std140) uniform A { layout(align = 7) vec4 a; };
void main() { }
//// 4.60 4.4.5 a block has no offset | SC223 [450]
layout(std140, offset = 16) uniform A { vec4 a; };
void main() { }
//// 4.60 4.4.6 bindings are of blocks and opaque types | SC223 SC223 SC223 [450]
layout(binding = 1) uniform float x;
layout(binding = 1) in float y;
uniform B { layout(binding = 1) float z; };
layout(binding = 1) uniform C { float w; };
void main() { }
//// 4.60 4.4.7 formats are of images | SC223 SC223 [450]
layout(r32f) uniform float x;
layout(r32f) uniform sampler2D s;
layout(r32f) uniform image2D i;
void main() { }
//// 4.20 4.9 an array of images has memory qualifiers | ok [420]
writeonly uniform image2D a[2];
void main() { imageStore(a[0], ivec2(0), vec4(0.0)); }
//// 4.60 4.3.9 members are stored as their block | SC221 SC221 [450]
uniform A { uniform float a; };
uniform B { in float b; };
uniform C { const float c; };
void main() { }
//// 4.60 4.3.9 no struct is defined in a block | SC221 [450]
uniform B { struct S { float a; } s; };
void main() { }
//// 4.60 4.4 what stands on its own | SC221 [450]
uniform;
const;
void main() { }
//// ARB_fragment_shader_interlock: the critical section | ok [450]
#extension GL_ARB_fragment_shader_interlock : enable
layout(pixel_interlock_ordered) in;
void main() { beginInvocationInterlockARB(); endInvocationInterlockARB(); }
//// ARB_bindless_texture: samplers are made from handles | ok [450]
#extension GL_ARB_bindless_texture : enable
uniform uvec2 h;
struct S { sampler2D s; };
S f() { S s; return s; }
void g(out S s) { s = f(); }
void main() { vec4 c = texture(sampler2D(h), vec2(0.0)); }
//// 4.60 4.1.7 no sampler is made | SC219 [450]
uniform uvec2 h;
void main() { vec4 c = texture(sampler2D(h), vec2(0.0)); }
//// 4.60 4.1.7 no struct of samplers is made | SC219 [450]
struct S { sampler2D s; float f; };
uniform S s;
void main() { S(s.s, 1.0); }
//// 4.60 4.4 defaults stand outside of functions | SC221 [450]
void main() { layout(std140) uniform; }
//// 4.60 4.3.9 qualifiers of members go together | SC221
in B { flat flat int a; centroid vec2 b; } b;
void main() { }
//// 4.60 4.1.9 only the last array of a buffer has no size | SC214 [450]
buffer B { float a[]; float b[]; };
void main() { int i = 1; b[i] = 1.0; int n = b.length(); a[i] = 1.0; }
//// 1.30 7.1 no more clip distances than there are | SC214 [130 vertex]
void main() { gl_ClipDistance[7] = 1.0; gl_ClipDistance[8] = 1.0; }
//// 4.60 4.4.6 bindings have no default | SC223 [450]
layout(binding = 0) uniform;
void main() { }
