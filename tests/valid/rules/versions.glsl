//// 1.20 5.9 % needs integers of 1.30 | SC205 [120]
void main() { int a = 5 % 3; }
//// 1.30 5.9 % is there | ok [130]
void main() { int a = 5 % 3; }
//// 1.20 5.9 bitwise operators are reserved | SC205 SC205 SC210 [120]
void main() { int a = 5 & 3; a = ~a; a <<= 1; }
//// 1.10 4.1.10 nothing converts | SC210 [110]
void main() { float a = 1; }
//// 1.20 4.1.10 integers become floats | ok [120]
void main() { float a = 1; vec2 b = ivec2(1) + vec2(2.0); a += 1; }
//// 1.10 5.7 arrays are no values | SC210 [110]
void main() { float a[2]; float b[2]; a = b; }
//// 1.10 5.7 nor are structs with arrays inside | SC210 [110]
struct S { float a[2]; };
void main() { S s; S t; s = t; }
//// 1.20 5.7 arrays are values | ok [120]
void main() { float a[2] = float[2](1.0, 2.0); float b[2]; b = a; bool c = a == b; int n = a.length(); }
//// 1.10 5.9 arrays are not compared | SC205 [110]
void main() { float a[2]; float b[2]; bool c = a == b; }
//// 1.10 4.1.9 no constructors of arrays | SC221 SC219 [110]
void main() { float[2] a; float[2](1.0, 2.0); }
//// 1.10 4.1.9 no length() | SC213 [110]
void main() { float a[2]; int n = a.length(); }
//// 1.10 6.1 no functions that return arrays | SC224 [110]
struct S { float a[2]; };
S f() { S s; return s; }
void main() { }
//// 1.10 5.4.2 no matrix from a matrix | SC219 [110]
void main() { mat3 m = mat3(mat4(1.0)); }
//// 1.20 5.4.2 a matrix from a matrix | ok [120]
void main() { mat3 m = mat3(mat4(1.0)); }
//// 1.10 4.2 functions have names of their own | ok [110]
float f(float a) { return a; }
float f;
void main() { float f = f(1.0); f = f(2.0); }
//// 1.20 4.2 functions and variables share their names | SC202 [120]
float f(float a) { return a; }
float f;
void main() { }
//// 1.10 4.3.5 uniforms have no value | SC221 [110]
uniform float u = 1.0;
void main() { }
//// 1.20 4.3.5 uniforms may have a value | ok [120]
uniform float u = 1.0;
void main() { }
//// 1.20 4.3 inputs are varyings | SC221 [120]
in vec4 v;
void main() { }
//// 1.20 4.3.6 varyings and the output of old | ok [120]
varying vec2 v;
uniform sampler2D s;
void main() { gl_FragColor = texture2D(s, v) + gl_Color; gl_FragData[1] = vec4(0.0); }
//// 4.20 4.3.6 varyings are gone from the core profile | SC221 [420]
varying vec2 v;
void main() { }
//// 4.20 4.3.6 the compatibility profile has them | ok [420 compatibility]
varying vec2 v;
void main() { gl_FragColor = v.xyxy; }
//// 4.20 4.3.4 attributes are gone from the core profile | SC221 [420 vertex]
attribute vec2 v;
void main() { }
//// 1.20 7.5 the state of the fixed pipeline | ok [120 vertex]
varying vec4 gl_TexCoord[3];
void main() {
    int i = 0;
    gl_TexCoord[i] = gl_TextureMatrix[1] * gl_MultiTexCoord0;
    gl_FrontColor = gl_LightSource[2].diffuse * gl_FrontMaterial.shininess;
    gl_Position = ftransform() + gl_ModelViewProjectionMatrix * gl_Vertex;
    gl_MaterialParameters m = gl_BackMaterial;
}
//// 3.30 7.5 which the core profile lacks | SC201 [330 vertex]
void main() { gl_Position = ftransform(); }
//// 3.30 7.5 the compatibility profile has it | ok [330 compatibility vertex]
void main() { gl_Position = ftransform(); }
//// 1.30 4.3.4 attributes are no arrays | SC221 [130 vertex]
in vec4 v[3];
void main() { }
//// 1.50 4.3.4 attributes may be arrays | ok [150 vertex]
in vec4 v[3];
void main() { }
//// 1.30 4.3.7 no structs between the stages | SC221 [130]
struct S { vec4 a; };
in S s;
void main() { }
//// 1.30 4.3.7 no uniform blocks | SC221 [130]
uniform B { vec4 v; };
void main() { }
//// 1.30 4.3.7 but with the extension | ok [130]
#extension GL_ARB_uniform_buffer_object : enable
uniform B { vec4 v; };
void main() { }
//// 1.30 3.3 all : disable takes every extension back | SC221 [130]
#extension GL_ARB_uniform_buffer_object : enable
#extension all : disable
uniform B { vec4 v; };
void main() { }
//// 1.30 3.3 behind all : disable one may come back | ok [130]
#extension all : disable
#extension GL_ARB_uniform_buffer_object : enable
uniform B { vec4 v; };
void main() { }
//// 1.30 3.3 all : warn turns every extension on | ok [130]
#extension all : warn
uniform B { vec4 v; };
void main() { }
//// 1.30 3.3 but one that is disabled behind it | SC221 [130]
#extension all : warn
#extension GL_ARB_uniform_buffer_object : disable
uniform B { vec4 v; };
void main() { }
//// 3.30 3.3 all : warn brings keywords | SC106
#extension all : warn
void main() { float buffer = 1.0; }
//// 1.20 4.1.8 a struct may have the name of a type of 1.30 | ok [120 glslang refuses]
struct uint { float x; };
struct sampler2DMSArray { uint of[2]; };
uniform sampler2DMSArray s;
void main() { uint a = uint(1.0); float b = s.of[1].x + a.x; }
//// 3.30 4.1.8 a struct may have the name of a type of 4.00 | ok [glslang refuses]
struct dmat2 { float x; };
struct int64_t { dmat2 m; };
in int64_t v;
void main() { int64_t a = int64_t(dmat2(1.0)); a.m.x += v.m.x; }
//// 4.00 4.1.10 to uint and to double | ok [400]
void main() { uint u = 1; double d = 1; d = 1.0; dvec2 v = ivec2(1); dmat2 m = mat2(1.0); d = sqrt(d); }
//// 4.00 4.1.10 but nothing back | SC210 [400]
void main() { double d = 1.0; float f = d; }
//// 4.00 4.3.4 attributes of double | SC221 [400 vertex]
in dvec2 v;
void main() { }
//// 4.10 4.3.4 attributes of double | ok [410 vertex]
in dvec2 v;
void main() { }
//// 4.00 4.3.6 no outputs of double | SC221 [400]
out dvec2 v;
void main() { }
//// 4.20 4.1.11 lists in braces | ok [420]
struct S { vec2 a; float b[2]; };
void main() {
    float a[] = { 1.0, 2, 3.0 };
    S s = { { 1.0, 2.0 }, { 3.0, a[2] } };
    mat2 m = { { 1.0, 0.0 }, { 0.0, 1.0 } };
    const int n[2] = { 4, 5 };
    float c[n[1]];
    c[4] = 1.0;
}
//// 4.20 4.1.11 lists of a wrong length | SC219 SC219 [420]
void main() { float a[2] = { 1.0 }; vec3 b = { 1.0, 2.0 }; }
//// 4.20 4.1.11 lists of a wrong type | SC210 [420]
void main() { int a[2] = { 1, 2.0 }; }
//// 4.20 4.1.11 a scalar takes no list | SC219 [420]
void main() { float a = { 1.0 }; }
//// 4.20 5.5 swizzles of scalars | ok [420]
void main() { vec3 v = (1.0).xxx; }
//// 4.40 4.4 layouts may be computed | ok [440]
const int n = 1;
layout(location = n + 1) out vec4 v;
void main() { }
//// 4.30 4.4 layouts are plain numbers | SC223 [430]
const int n = 1;
layout(location = n + 1) out vec4 v;
void main() { }
//// 4.20 4.4 layouts in capitals | ok [420]
layout(LOCATION = 1) out vec4 v;
void main() { }
//// ARB_gpu_shader_int64 integers of 64 bits | ok [400]
#extension GL_ARB_gpu_shader_int64 : enable
void main() { int64_t a = 1; uint64_t b = 5ul + uint64_t(a); i64vec2 c = i64vec2(1l) << 3; double d = a; }
//// ARB_gpu_shader_int64 nothing back | SC210 [400]
#extension GL_ARB_gpu_shader_int64 : enable
void main() { int a = 1l; }
//// ARB_bindless_texture samplers are values | ok [400]
#extension GL_ARB_bindless_texture : enable
struct S { sampler2D s; };
flat in sampler2D t;
uniform B { sampler2D u; };
void main() { }
//// ARB_shader_texture_lod in fragment shaders | ok [120]
#extension GL_ARB_shader_texture_lod : enable
uniform sampler2D s;
void main() { gl_FragColor = texture2DLod(s, vec2(0.0), 1.0); }
//// ARB_shader_texture_lod is needed for it | SC201 [120]
uniform sampler2D s;
void main() { gl_FragColor = texture2DLod(s, vec2(0.0), 1.0); }
//// ARB_texture_rectangle | ok [120]
#extension GL_ARB_texture_rectangle : enable
uniform sampler2DRect s;
void main() { gl_FragColor = texture2DRect(s, vec2(0.0)); }
//// 4.40 4.4.1 variables share a location by components | ok [440 vertex]
layout(location = 0) out vec2 a;
layout(location = 0, component = 2) out vec2 b;
layout(location = 1) out dvec3 c;
layout(location = 2, component = 2) out double d;
void main() { }
//// 4.40 4.4.1 but not a component | SC223 [440 vertex]
layout(location = 0) out vec3 a;
layout(location = 0, component = 2) out vec2 b;
void main() { }
//// 4.40 4.4.1 four components are there | SC223 [440 vertex]
layout(location = 0, component = 3) out vec2 b;
void main() { }
//// 4.40 4.4.1 members of a block stand one behind the other | SC223 [440 vertex]
layout(location = 1) out B { mat2 m; vec4 a; layout(location = 2) vec4 b; };
void main() { }
//// 4.10 4.4.1 blocks have no locations | SC223 [410 vertex]
layout(location = 1) out B { vec4 a; };
void main() { }
//// 1.50 7.1 gl_FragCoord has one layout | SC223 [150]
layout(origin_upper_left) in vec4 gl_FragCoord;
layout(pixel_center_integer) in vec4 gl_FragCoord;
void main() { }
//// EXT_frag_depth is of GLSL ES alone | SC201 [120]
#extension GL_EXT_frag_depth : enable
void main() { gl_FragDepthEXT = 1.0; }
//// EXT_frag_depth in GLSL ES | ok [100]
#extension GL_EXT_frag_depth : enable
void main() { gl_FragDepthEXT = 1.0; }
