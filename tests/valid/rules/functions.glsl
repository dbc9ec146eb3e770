//// 6.1 too few arguments | SC207
float x = user();
//// 6.1 too many arguments | SC207
float x = user(1.0, 2.0);
//// 6.1 an argument of another type | SC206
float x = user(u_v);
//// 6.1 an argument is converted | ok
float x = user(1) + user(2u);
//// 6.1 built-in functions with arguments of other types | SC206
float x = dot(1.0, u_v);
//// 6.1 too few arguments of a built-in function | SC207
float x = mix(1.0, 2.0);
//// 6.1 arguments of built-in functions are converted | ok
float x = max(1, 2.0) + pow(2, 3) + mix(0, 1, u_f) + clamp(u_f, 0, 1);
vec3 y = mix(u_v, vec3(1), 1) * sqrt(2);
//// 6.1 an argument in error is silent | SC201
float x = user(nothing) + dot(nothing, u_v);
//// 6.1 overloads by type | ok
float f(float x) { return x; }
vec2 f(vec2 x) { return x; }
int f(int x) { return x; }
void main() { vec2 a = f(vec2(1.0)); int b = f(1); float c = f(1.0); }
//// 6.1 overloads by number of arguments | ok
float f(float x) { return x; }
float f(float x, float y) { return x + y; }
void main() { float a = f(f(1.0), f(1.0, 2.0)); }
//// 6.1 an ambiguous call | SC208
float f(float x, int y) { return x; }
float f(int x, float y) { return y; }
void main() { float a = f(1, 1); }
//// 6.1 an exact match wins | ok
float f(float x, int y) { return x; }
float f(int x, float y) { return y; }
float f(int x, int y) { return 1.0; }
void main() { float a = f(1, 1); }
//// 6.1 before 4.00 all conversions are equal | SC208
float f(float x, float y) { return y; }
float f(int x, float y) { return y; }
void main() { float a = f(1, 1); }
//// 6.1 from 4.00 on an exact argument is better | ok [400]
float f(float x, float y) { return y; }
float f(int x, float y) { return y; }
void main() { float a = f(1, 1); }
//// 6.1 from 4.00 on float is nearer than double | ok [400]
float f(float x) { return x; }
double f(double x) { return x; }
void main() { float a = f(1); }
//// 6.1 from 4.00 on int is no nearer to uint than to float | SC208 [400]
float f(float x) { return x; }
uint f(uint x) { return x; }
void main() { f(1); }
//// 6.1 overloads do not differ by their result alone | SC224
float f(int x) { return 1.0; }
int f(int x) { return 1; }
void main() { }
//// 6.1 a function is defined once | SC202
float f(int x) { return 1.0; }
float f(int x) { return 2.0; }
void main() { }
//// 6.1 a prototype and its definition | ok
float f(int x);
void main() { float a = f(1); }
float f(int y) { return 1.0; }
//// 6.1 several prototypes | ok
float f(int x);
float f(int);
float f(int y) { return 1.0; }
float f(int x);
void main() { float a = f(1); }
//// 6.1 a prototype with another result | SC224
float f(int x);
int f(int x) { return 1; }
void main() { }
//// 6.1 a prototype with other qualifiers | SC224
void f(out float x);
void f(in float x) { }
void main() { }
//// 6.1 a function is declared before its call | SC201
void main() { float a = f(1); }
float f(int x) { return 1.0; }
//// 6.1 recursion | SC216 [glslang accepts]
float f(float x) { return f(x); }
void main() { }
//// 6.1 recursion through another function | SC216 [glslang accepts]
float f(float x);
float h(float x) { return f(x); }
float f(float x) { return h(x); }
void main() { }
//// 6.1 recursion that is never run | SC216 [glslang accepts]
float f(float x) { if (false) return f(x); return 1.0; }
void main() { }
//// 6.1 an overload that calls another is no recursion | ok
float f(float x) { return x; }
float f(vec2 x) { return f(x.x); }
void main() { float a = f(vec2(1.0)); }
//// 6.1 a built-in function may be overloaded | ok
float mix(int a, int b) { return 1.0; }
void main() { float a = mix(1, 2); float b = mix(1.0, 2.0, 0.5); }
//// 6.1 a built-in function may be replaced | ok
float mix(float a, float b, float c) { return a; }
void main() { float a = mix(1.0, 2.0, 0.5); }
//// 6.1 a user's overload hides conversions to the built-in ones | SC206
float max(vec2 a, vec2 b) { return 1.0; }
void main() { float a = max(1, 2.0); }
//// 6.1.1 the result is of the declared type | SC211
float f() { return vec2(1.0); }
void main() { }
//// 6.1.1 the result is converted | ok
float f() { return 1; }
void main() { }
//// 6.1.1 a value is missing | SC211
float f() { return; }
void main() { }
//// 6.1.1 a void function returns no value | SC211
void f() { return 1.0; }
void main() { }
//// 6.1.1 a function without return | SC211
float f() { }
void main() { }
//// 6.1.1 a return in one branch is enough | ok
float f(float x) { if (x > 0.0) return x; }
void main() { }
//// 6.1.1 a parameter is a local variable | ok
float f(float x) { x += 1.0; return x; }
void main() { }
//// 6.1.1 a constant parameter is not | SC209
float f(const float x) { x += 1.0; return x; }
void main() { }
//// 6.1.1 out arguments are l-values | SC209
vec3 v;
writes(1.0, v);
//// 6.1.1 out arguments are not constant | SC209
float x;
writes(x, AXIS);
//// 6.1.1 out arguments may be parts | ok
vec3 a;
mat3 m;
writes(a.y, m[1]);
writes(m[u_i][2], a);
//// 6.1.1 an inout argument has exactly the type | SC206
ivec3 a;
float x;
writes(x, a);
//// 6.1.1 an out argument is converted on the way back | ok
void f(out int x) { x = 1; }
void main() { float a; f(a); }
//// 6.1.1 and not the other way | SC206
void f(out float x) { x = 1.0; }
void main() { int a; f(a); }
//// 6.1.1 built-in functions with an out argument | ok
float whole;
float x = modf(u_f, whole);
//// 6.1.1 built-in functions need an l-value for it | SC209
float x = modf(u_f, u_f);
//// 6.1 arrays as parameters and results | ok
float[2] f(float a[2]) { return a; }
void main() { float b[2] = f(float[](1.0, 2.0)); }
//// 6.1 an array parameter has a size | SC215
float f(float a[]) { return a[0]; }
void main() { }
//// 6.1 an array argument has the same size | SC206
float f(float a[2]) { return a[0]; }
void main() { float x = f(float[](1.0, 2.0, 3.0)); }
//// 6.1 structs as parameters | ok
struct S { float a; };
S f(S s) { s.a = 1.0; return s; }
void main() { float x = f(S(2.0)).a; }
//// 6.1 a parameter is not uniform | SC221
void f(uniform float x) { }
void main() { }
//// 6.1 a constant parameter is not written | SC221
void f(const out float x) { }
void main() { }
//// 6.1 results have no storage | SC224
const float f() { return 1.0; }
void main() { }
//// 6.1 a parameter is not void | SC204
void f(void x) { }
void main() { }
//// 6.1 main takes nothing | SC217
void main(float x) { }
//// 6.1 main returns nothing | SC217
int main() { return 1; }
//// 6.1 main is there | SC217 [glslang accepts]
void f() { int main; }
//// 8.8 derivatives are for fragment shaders | SC201 [vertex]
in float a;
void main() { float x = dFdx(a); }
//// 8.7 a bias is for fragment shaders | SC207 [vertex]
uniform sampler2D s;
void main() { vec4 x = texture(s, vec2(0.0), 1.0); }
//// 8.7 textures | ok
vec4 a = texture(u_map, v_uv) + texture(u_cube, u_v) + texture(u_map, v_uv, 1);
vec4 b = textureLod(u_map, v_uv, 0) + texelFetch(u_map, ivec2(1), 0);
ivec2 c = textureSize(u_map, 0);
vec4 d = texture2D(u_map, v_uv);
//// 8.7 another sampler | SC206
vec4 a = texture(u_cube, v_uv);
//// 8 functions of 4.00 | SC201
float x = fma(u_f, u_f, u_f);
//// 8 functions of 4.00 in 4.00 | ok [400]
float x = fma(u_f, u_f, u_f);
vec2 lod = textureQueryLod(u_map, v_uv);
//// 8 functions of 4.00 by extension | ok [glslang refuses]
#extension GL_ARB_gpu_shader5 : enable
void main() { float x = fma(1.0, 2.0, 3.0); uint y = 1; }
