//// 5.5 swizzles | ok
vec4 x = v_uv.xyxy + u_v.rgbr + v_n.stpp;
float y = u_v.z;
//// 5.5 letters of two sets | SC213
vec2 x = u_v.xg;
//// 5.5 a component that the vector lacks | SC213
float x = v_uv.z;
//// 5.5 more than four components | SC213
vec4 x = u_v.xyzxy;
//// 5.5 no swizzle of a scalar before 4.20 | SC213
float x = u_f.x;
//// 5.5 swizzles of scalars in 4.20 | ok [420]
vec3 x = u_f.xxx;
//// 5.5 no swizzle of a matrix | SC213
float x = u_m.x;
//// 5.5 no swizzle of an array | SC213
float a[2];
float x = a.x;
//// 5.5 a swizzle is assigned | ok
vec3 a;
a.zx = vec2(1.0);
a.xyz.yz.x = 1.0;
//// 5.5 a swizzle with a component twice is no l-value | SC209
vec3 a;
a.xx = vec2(1.0);
//// 5.8 a component of a swizzle | ok
vec3 a;
a.zx[0] = 1.0;
//// 5.8 a value is no l-value | SC209
(u_f + 1.0) = 2.0;
//// 5.8 a call is no l-value | SC209
user(1.0) = 2.0;
//// 5.8 a constructor is no l-value | SC209
vec3(1.0).x = 2.0;
//// 5.8 a ternary is no l-value | SC209
float a, b;
(u_f > 0.0 ? a : b) = 1.0;
//// 5.8 an increment is no l-value | SC209
int i;
++i = 1;
//// 5.8 an assignment has a value | ok
float a, b;
a = b = 1.0;
a += b *= 2.0;
//// 5.8 increments need an l-value | SC209
5++;
//// 5.8 increments of constants | SC209
++K;
//// 5.8 increments of floats and vectors | ok
float a = 1.0;
vec3 b = vec3(1.0);
a++;
--b;
b.x++;
//// 5.8 compound assignment keeps the type of its target | SC210
int i = 1;
i += 1.5;
//// 5.8 a vector is scaled by a matrix | ok
vec3 a = u_v;
a *= u_m;
a /= 2;
//// 5.8 a scalar is not added to by a vector | SC210
float a;
a += u_v;
//// 5.9 conditions are bool | SC212
float x = u_i ? 1.0 : 2.0;
//// 5.9 both sides of a ternary have one type | SC205
float x = u_f > 0.0 ? 1.0 : vec2(1.0);
//// 5.9 a ternary of structs and arrays | ok
Ray a, b;
Ray c = u_f > 0.0 ? a : b;
//// 5.9 structs are compared | ok
Ray a, b;
bool x = a == b && a != b;
//// 5.9 structs are not added | SC205
Ray a, b;
Ray c = a + b;
//// 5.9 functions are not added | SC204 [glslang refuses]
float x = user + 1.0;
//// 5.9 samplers are not compared | SC205
bool x = u_map == u_map;
//// 5.9 the comma takes the type on the right | ok
float x = (u_i, true, u_f);
//// 5.9 an operator on void | SC205
void f() { }
void main() { float x = 1.0 + f(); }
//// 5.9 an operator on a type error is silent | SC205
float x = (u_map + 1.0) * 2.0 + vec3(1.0);
//// 5.4 constructors | ok
mat3 a = mat3(1.0);
mat2 b = mat2(a);
mat4 c = mat4(a);
vec4 d = vec4(v_uv, 0, 1);
vec2 e = vec2(d);
float f = float(d);
Ray r = Ray(vec3(0), vec3(1.0));
float w[2] = float[](1.0, 2.0);
//// 8 const expressions as texture offsets | ok
vec4 c = textureOffset(u_map, v_uv, ivec2(K, -1));
//// 8 variables as texture offsets | SC226
vec4 c = textureOffset(u_map, v_uv, ivec2(u_i));
