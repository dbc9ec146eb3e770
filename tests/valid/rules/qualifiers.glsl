//// 4.3.3 a constant needs a value | SC222
const float x;
//// 4.3.3 a constant needs a constant value | SC222
const float x = u_f;
//// 4.3.3 a constant may be computed from constants | ok
const vec3 a = normalize(AXIS) * 2.0 + vec3(1.0, K, 3u);
const float b = a.y + AXIS[1] + max(1.0, 2.0);
const float c[2] = float[](1.0, b);
const float d = c[1] + float(c.length());
const Ray r = Ray(AXIS, AXIS);
const float e = r.origin.x;
const bool f = K > 2 && true;
const float h = f ? 1.0 : 2.0;
//// 4.3.3 a global constant needs a constant value | SC222
uniform float u;
const float x = u;
void main() { }
//// 4.3.3 a user's function makes no constant | SC222
const float x = user(1.0);
//// 4.3.3 the comma makes no constant | SC222
const float x = (1.0, 2.0);
//// 4.3.3 a parameter is no constant | SC222
void f(const float p) { const float x = p; }
void main() { }
//// 4.3.3 a local constant may be computed at run time in 4.20 | ok [420]
const float x = u_f;
//// 4.3.3 but it is no constant expression | SC215 [420]
const int n = u_i;
float a[n];
//// 4.3.3 constants cannot be written | SC209
const float x = 1.0;
x = 2.0;
//// 4.3 global initialisers need not be constant | ok
uniform float u;
float g = u * 2.0;
void main() { }
//// 4.3.5 uniforms cannot be written | SC209
u_f = 1.0;
//// 4.3.5 uniforms may have a constant value | ok
uniform float u = 2.0 * 3.0;
void main() { }
//// 4.3.5 uniforms need a constant value | SC222
float g;
uniform float u = g;
void main() { }
//// 4.3.5 uniforms are global | SC221
uniform float u;
//// 4.3.4 inputs cannot be written | SC209
v_uv.x = 1.0;
//// 4.3.4 inputs are global | SC221
in float x;
//// 4.3.4 inputs have no value | SC221
in float x = 1.0;
void main() { }
//// 4.3.4 integer inputs of a fragment shader are flat | SC221
in int x;
void main() { }
//// 4.3.4 structs with integers too | SC221
struct S { int i; };
in S s;
void main() { }
//// 4.3.4 flat integer inputs | ok
flat in ivec3 x;
void main() { }
//// 4.3.4 no bool input | SC221
flat in bool x;
void main() { }
//// 4.3.4 integer attributes need no flat | ok [vertex]
in ivec3 x;
void main() { }
//// 4.3.4 attributes are no structs | SC221 [vertex]
struct S { float a; };
in S s;
void main() { }
//// 4.3.4 attributes are not interpolated | SC221 [vertex]
flat in int x;
void main() { }
//// 4.3.6 outputs are written and read | ok
o_color = vec4(1.0);
o_color.x += o_color.y;
//// 4.3.6 no matrix output of a fragment shader | SC221
out mat2 x;
void main() { }
//// 4.3.6 matrix outputs of a vertex shader | ok [vertex]
out mat2 x;
void main() { x = mat2(1.0); }
//// 4.3.6 no bool output | SC221
out bool x;
void main() { }
//// 4.3.6 fragment outputs are not interpolated | SC221
flat out vec4 x;
void main() { }
//// 4.3 inout is for parameters | SC221
inout float x;
void main() { }
//// 4.3 two storage qualifiers | SC221
in out float x;
void main() { }
//// 4.5 two interpolation qualifiers | SC221
flat smooth in float x;
void main() { }
//// 4.7 order of qualifiers before 4.20 | SC221
in flat float x;
void main() { }
//// 4.7 order of qualifiers in 4.20 | ok [420]
in flat float x;
void main() { }
//// 4.6.1 invariant outputs | ok [vertex]
invariant gl_Position;
invariant out vec3 v;
void main() { }
//// 4.6.1 no invariant uniform | SC221 [vertex]
uniform float u;
invariant u;
void main() { }
//// 4.6.1 no invariant attribute | SC221 [vertex]
invariant in vec3 a;
void main() { }
//// 4.6.1 an unknown name cannot be invariant | SC201 [vertex]
invariant nothing;
void main() { }
//// 4.5.3 precision statements | ok
precision highp float;
precision mediump int;
precision lowp sampler2D;
void main() { precision mediump float; }
//// 4.5.3 no precision of vectors | SC221
precision highp vec3;
void main() { }
//// 4.3.8 locations of fragment outputs | ok
layout(location = 0) out vec4 a;
layout(location = 1) out vec4 b;
layout(location = 2) out vec4 c[2];
void main() { }
//// 4.3.8 locations do not overlap | SC223
layout(location = 0) out vec4 a[2];
layout(location = 1) out vec4 b;
void main() { }
//// 4.3.8 one location with two indices | ok
layout(location = 0, index = 0) out vec4 a;
layout(location = 0, index = 1) out vec4 b;
void main() { }
//// 4.3.8 locations of inputs of fragment shaders need 4.10 | SC223
layout(location = 0) in vec4 a;
void main() { }
//// 4.3.8 locations of inputs of fragment shaders in 4.10 | ok [410]
layout(location = 0) in vec4 a;
void main() { }
//// 4.3.8 locations of attributes | ok [vertex]
layout(location = 0) in vec4 a;
layout(location = 1) in mat4 b;
layout(location = 5) in vec4 c;
void main() { }
//// 4.3.8 locations of uniforms need 4.30 | SC223
layout(location = 0) uniform vec4 a;
void main() { }
//// 4.3.8 a location is not negative | SC223
layout(location = -1) out vec4 a;
void main() { }
//// 4.3.8 an unknown layout word | SC223
layout(locaton = 1) out vec4 a;
void main() { }
//// 4.3.8 packing is for blocks | SC223
layout(std140) in vec4 a;
void main() { }
//// 4.3.7 members of a block without instance are global | ok
uniform Block { mat4 m; vec4 c[2]; };
void main() { vec4 x = m * c[1]; }
//// 4.3.7 members of a block cannot be written | SC209
uniform Block { float f; };
void main() { f = 1.0; }
//// 4.3.7 members of an instance | ok
layout(std140) uniform Block { layout(row_major) mat4 m; vec4 c[2]; } b;
void main() { vec4 x = b.m * b.c[1]; }
//// 4.3.7 members of an instance are no global names | SC201
uniform Block { float f; } b;
void main() { float x = f; }
//// 4.3.7 members of an instance cannot be written | SC209
uniform Block { float f; } b;
void main() { b.f = 1.0; }
//// 4.3.7 arrays of blocks | ok
uniform Block { float f; } b[2];
void main() { float x = b[1].f; }
//// 4.3.7 a member that does not exist | SC213
uniform Block { float f; } b;
void main() { float x = b.g; }
//// 4.3.7 a member clashes with a global | SC202
float f;
uniform Block { float f; };
void main() { }
//// 4.3.7 the name of a block is taken | SC202
uniform Block { float f; };
float Block;
void main() { }
//// 4.3.7 two blocks of one name | SC202
uniform Block { float f; };
uniform Block { float h; };
void main() { }
//// 4.3.7 no samplers in blocks | SC221
uniform Block { sampler2D s; };
void main() { }
//// 4.3.7 input blocks of fragment shaders | ok
in Block { vec3 n; flat int i; } b;
void main() { vec3 x = b.n * b.i; }
//// 4.3.7 output blocks of vertex shaders | ok [vertex]
out Block { vec3 n; } b;
void main() { b.n = vec3(1.0); }
//// 4.3.7 no output blocks of fragment shaders | SC221
out Block { vec4 c; } b;
void main() { }
//// 4.3.7 no input blocks of vertex shaders | SC221 [vertex]
in Block { vec4 c; } b;
void main() { }
