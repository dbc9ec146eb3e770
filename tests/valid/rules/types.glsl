//// 4.1.10 int becomes float | ok
float x = 1;
vec3 y = ivec3(1);
float z = 1u;
//// 4.1.10 float does not become int | SC210
int x = 1.0;
//// 4.1.10 int does not become uint before 4.00 | SC210
uint x = 1;
//// 4.1.10 int becomes uint in 4.00 | ok [400]
uint x = 1;
double d = 1.0;
//// 4.1.10 bool becomes nothing | SC210
float x = true;
//// 4.1.10 a scalar becomes no vector | SC210
vec3 x = 1.0;
//// 4.1.10 arrays do not convert | SC210
float a[2] = int[2](1, 2);
//// 4.1.8 a struct is assigned to its own type only | SC210
struct A { float x; };
struct B { float x; };
A a = A(1.0);
B b = a;
//// 4.1.8 fields of structs | ok
Lit lit = Lit(Ray(vec3(0.0), vec3(1.0)), float[3](1.0, 2.0, 3.0));
float x = lit.ray.direction.y + lit.weights[2];
lit.ray.origin.xz = vec2(1.0);
//// 4.1.8 a field that does not exist | SC213
Ray r;
float x = r.orign;
//// 4.1.8 a field twice | SC202
struct S { float a; int a; };
//// 4.1.8 fields have no storage | SC221
struct S { uniform float a; };
void main() { }
//// 4.1.8 fields may have a precision | ok
struct S { highp float a; };
void main() { }
//// 4.1.8 no struct inside a struct definition | SC221
struct S { struct T { float a; } t; };
void main() { }
//// 4.1.8 a struct of the same name twice | SC202
struct S { float a; };
struct S { float a; };
void main() { }
//// 4.1.8 a struct cannot hold itself | SC103
struct S { S s; };
void main() { }
//// 4.1.8 a field cannot be void | SC204
struct S { void a; };
void main() { }
//// 4.1.9 an array size is positive | SC215
float a[0];
//// 4.1.9 an array size is not negative | SC215
float a[-1];
//// 4.1.9 an array size is a constant | SC215
float a[u_i];
//// 4.1.9 an array size is an integer | SC215
float a[2.0];
//// 4.1.9 an array size may be an expression | ok
float a[K * 2 + 1];
a[6] = 1.0;
//// 4.1.9 an array size may use constant built-in functions | ok
float a[int(sqrt(16.0)) + max(1, 2)];
a[5] = 1.0;
//// 4.1.9 a constant index is inside of the array | SC214
float a[3];
a[3] = 1.0;
//// 4.1.9 a constant index is not negative | SC214
float a[3];
a[-1] = 1.0;
//// 4.1.9 a dynamic index | ok
float a[3];
a[u_i] = a[uint(u_i)];
//// 4.1.9 an index is an integer | SC214
float a[3];
float x = a[1.0];
//// 4.1.9 a scalar has no index | SC214
float x = u_f[0];
//// 4.1.9 a struct has no index | SC214
Ray r;
vec3 x = r[0];
//// 4.1.9 a constant index is inside of a vector | SC214
float x = u_v[3];
//// 4.1.9 a constant index is inside of a matrix | SC214
vec3 x = u_m[3];
//// 4.1.9 columns and components of matrices | ok
float x = u_m[2][1] + u_m[u_i].y;
//// 4.1.9 length of an array | ok
float a[5];
float b[a.length()];
int n = b.length();
//// 4.1.9 no length of an array without size | SC213
float a[];
int n = a.length();
//// 4.1.9 no length of a vector before 4.20 | SC213
int n = u_v.length();
//// 4.1.9 an array without size gets that of its initialiser | ok
float a[] = float[](1.0, 2.0, 3.0);
a[2] = 1.0;
int n = a.length();
//// 4.1.9 its size holds afterwards | SC214
float a[] = float[](1.0, 2.0, 3.0);
a[3] = 1.0;
//// 4.1.9 an array may be declared again with a size | ok
float a[];
float a[4];
void main() { a[3] = 1.0; }
//// 4.1.9 an array with a size is declared once | SC202
float a[4];
float a[4];
void main() { }
//// 4.1.9 a constant indexes an array without size | ok
float a[];
void main() { a[2] = 1.0; }
//// 4.1.9 a variable does not | SC214
float a[];
void main() { int i = 1; a[i] = 1.0; }
//// 4.1.9 arrays of arrays need 4.30 | SC225
float a[2][3];
//// 4.1.9 arrays of arrays in 4.30 | ok [430]
float a[2][3];
a[1][2] = 1.0;
float[3] row = a[0];
int n = a.length() + a[0].length();
//// 4.1.9 the size may stand at the type | ok
float[2] a = float[2](1.0, 2.0);
float b[2] = a;
//// 4.1.9 arrays of one size are assigned and compared | ok
float a[2] = float[2](1.0, 2.0);
float b[2] = a;
bool same = a == b;
//// 4.1.9 arrays of two sizes are not | SC210
float a[2] = float[2](1.0, 2.0);
float b[3];
b = a;
//// 4.1.7 samplers are uniforms | SC221
sampler2D s;
//// 4.1.7 samplers are parameters | ok
vec4 f(sampler2D s) { return texture(s, vec2(0.0)); }
uniform sampler2D u_map;
void main() { vec4 c = f(u_map); }
//// 4.1.7 samplers are not written by functions | SC221
void f(out sampler2D s) { }
void main() { }
//// 4.1.7 samplers are not assigned | SC209 SC210
u_map = u_map;
//// 4.1.7 samplers are not returned | SC224
uniform sampler2D u_map;
sampler2D f() { return u_map; }
void main() { }
//// 4.1.7 samplers do not choose | SC205 [glslang refuses]
vec4 c = texture(u_f > 0.0 ? u_maps[0] : u_maps[1], v_uv);
//// 4.1.7 arrays of samplers, constant index | ok
vec4 c = texture(u_maps[1], v_uv);
//// 4.1.7 arrays of samplers, dynamic index before 4.00 | SC214
vec4 c = texture(u_maps[u_i], v_uv);
//// 4.1.7 arrays of samplers, dynamic index in 4.00 | ok [400]
vec4 c = texture(u_maps[u_i], v_uv);
//// 4.1.7 structs with samplers are uniforms | SC221
struct S { sampler2D s; };
S s;
void main() { }
//// 4.1.1 no variable is void | SC204
void x;
//// 4.1.1 void has no value | SC210
void f() { }
void main() { float x = f(); }
//// 4.1.3 an integer literal of 32 bits | ok
uint a = 0xFFFFFFFFu;
int b = 0x7FFFFFFF;
int c = 0xFFFFFFFF;
//// 4.1.3 an integer literal of more than 32 bits | SC227
uint a = 0x1FFFFFFFFu;
