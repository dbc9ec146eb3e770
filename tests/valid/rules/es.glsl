//// ES 3.00 4.1.10 nothing converts | SC210 [es]
void main() { float x = 1; }
//// ES 3.00 5.9 operands have one type | SC205 [es]
void main() { float x = 1.0 + 1; }
//// ES 3.00 5.9 the same with one type | ok [es]
void main() { float x = 1.0 + 1.0; mat3 m = mat3(1.0) * 2.0; }
//// ES 3.00 6.1 arguments have the types of the parameters | SC206 [es]
float f(float x) { return x; }
void main() { float x = f(1); }
//// ES 3.00 4.3 global initialisers are constant | SC222 [es]
uniform float u;
float g = u;
void main() { }
//// ES 3.00 4.3.3 local constants are constant | SC222 [es]
uniform float u;
void main() { const float x = u; }
//// ES 3.00 4.3.8 locations of outputs | ok [es]
layout(location = 0) out vec4 a;
layout(location = 1) out vec4 b;
void main() { a = b = vec4(1.0); }
//// ES 3.00 4.3.8 no locations of inputs of fragment shaders | SC223 [es]
layout(location = 0) in vec4 a;
void main() { }
//// ES 3.00 4.3.8 no locations of uniforms | SC223 [es]
layout(location = 0) uniform vec4 a;
void main() { }
//// ES 3.00 4.1.9 no arrays of arrays | SC225 [es]
void main() { float a[2][2]; }
//// ES 3.00 8.4 packing functions are there | ok [es]
void main() { uint x = packHalf2x16(vec2(1.0)); }
//// ES 3.00 8.8 the old texture functions are not | SC201 [es]
uniform sampler2D s;
void main() { vec4 x = texture2D(s, vec2(0.0)); }
//// ES 3.00 4.5.4 floats have no default precision in fragment shaders | SC228 [es bare]
float a;
float b;
void main() { }
//// ES 1.00 4.5.3 nor have parameters and vectors | SC228 [100 bare]
vec2 f(vec3 a) { return a.xy; }
void main() { }
//// ES 3.00 4.5.4 a precision of its own | ok [es bare]
uniform highp vec3 a;
uniform sampler2D s;
int i;
bool b;
void main() { }
//// ES 3.00 4.5.4 vertex shaders have one | ok [es bare vertex]
float a;
void main() { }
//// ES 3.00 4.5.4 a default ends with its scope | SC228 [es bare]
void f() { precision highp float; float a; }
void main() { float a; }
//// ES 3.00 4.5.4 most samplers have no default | SC228 SC228 [es bare]
uniform sampler3D s;
precision highp isampler2D;
uniform isampler2D t;
uniform lowp sampler2DShadow u;
uniform sampler2DArray v;
void main() { }
//// ES 3.00 4.5.4 a struct has no precision | SC221 [es bare]
lowp struct S { lowp float a; } s;
void main() { }
//// ES 3.00 6.1 built-in functions are not overloaded | SC202 [es]
float sin(int a) { return 1.0; }
void main() { }
//// ES 1.00 6.1 built-in functions are not redefined | SC202 [100]
float sin(float a) { return 1.0; }
void main() { }
//// ES 1.00 6.1 but overloaded | ok [100]
float sin(int a) { return 1.0; }
void main() { float a = sin(1) + sin(1.0); }
//// ES 3.00 4.2.2 names of built-in functions are taken | SC202 [es]
float sin;
void main() { }
//// ES 3.00 4.2.2 locals may have them | ok [es]
void main() { float sin = 1.0; }
//// ES 3.00 6.1 functions are declared at global scope | SC221 [es]
void main() { float f(float x); }
//// ES 1.00 6.1 a function is declared once | SC202 [100]
float f(float x);
float f(float x);
void main() { }
//// ES 1.00 4.2.2 parameters have a scope of their own | ok [100]
void f(int a) { int a; }
void main() { }
//// ES 3.00 4.2.2 parameters share the scope of the body | SC202 [es]
void f(int a) { int a; }
void main() { }
//// ES 1.00 5.9 no integer operators | SC205 [100]
void main() { int a = 1 & 2; }
//// ES 1.00 4.3.3 no attributes of int | SC221 [100 vertex]
attribute int a;
void main() { }
//// ES 3.00 4.3.6 vertex outputs of int are flat | SC221 [es vertex]
out int a;
void main() { a = 1; }
//// ES 3.00 4.6.1 inputs are not invariant | SC221 [es]
in vec4 a;
invariant a;
void main() { }
//// ES 3.00 4.3.5 uniforms have no value | SC221 [es]
uniform float u = 1.0;
void main() { }
//// ES 3.00 4.3 global initialisers may be computed with an extension | ok [es]
#extension GL_EXT_shader_non_constant_global_initializers : enable
uniform float u;
float g = u;
void main() { }
//// ES 3.00 4.1.9 arrays have sizes | SC215 [es]
float a[];
void main() { }
//// ES 3.00 4.3.7 arrays of blocks have constant indices | SC214 [es]
uniform B { mat4 m; } b[2];
void main() { int i = 0; vec4 x = b[i].m[0]; }
//// ES 3.00 4.3.7 arrays in a block take any index | ok [es]
struct P { vec4 v; };
uniform B { P p[3]; } b;
void main() { int i = 0; vec4 x = b.p[i].v; }
//// ES 3.20 4.3.7 any index will do | ok [320 es]
uniform B { mat4 m; } b[2];
void main() { int i = 0; vec4 x = b[i].m[0]; }
//// ES 3.00 4.3.7 no blocks between the stages | SC221 [es]
in B { vec4 v; };
void main() { }
//// ES 3.20 4.3.7 blocks between the stages | ok [320 es]
in B { vec4 v; };
void main() { }
//// ES 1.00 8.8 derivatives need an extension | SC201 [100]
void main() { gl_FragColor = dFdx(gl_FragCoord); }
//// ES 1.00 extensions of fragment shaders | ok [100]
#extension GL_OES_standard_derivatives : enable
#extension GL_EXT_shader_texture_lod : enable
#extension GL_EXT_frag_depth : enable
uniform sampler2D s;
void main() {
    gl_FragColor = fwidth(gl_FragCoord) + texture2DLodEXT(s, vec2(0.0), 1.0);
    gl_FragDepthEXT = 1.0;
}
//// ES 1.00 OES_texture_3D | ok [100]
#extension GL_OES_texture_3D : enable
uniform lowp sampler3D s;
void main() { gl_FragColor = texture3D(s, vec3(0.0)); }
//// ES 1.00 EXT_shadow_samplers | ok [100]
#extension GL_EXT_shadow_samplers : enable
uniform lowp sampler2DShadow s;
void main() { gl_FragColor = vec4(shadow2DEXT(s, vec3(0.0))); }
//// ES 3.00 OVR_multiview | ok [es vertex]
#extension GL_OVR_multiview : require
layout(num_views = 2) in;
void main() { gl_Position = vec4(gl_ViewID_OVR); }
//// ES 3.10 8.8 bits of integers | ok [310 es]
void main() { int a = bitCount(5) + findMSB(7); uint b = bitfieldReverse(3u); float c = ldexp(1.0, 2); }
//// ES 3.10 4.1.9 arrays of arrays | ok [310 es]
void main() { int a[2][3]; a[1][2] = a.length() + a[0].length(); }
//// ES 3.20 8.14 interpolation | ok [320 es]
in vec2 v;
void main() { vec2 a = interpolateAtCentroid(v) + interpolateAtOffset(v, vec2(0.1)); }
