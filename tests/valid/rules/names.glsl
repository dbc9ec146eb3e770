//// 4.2 an undeclared variable | SC201
float x = nothing;
//// 4.2 an undeclared function | SC201
float x = nothing(1.0);
//// 4.2 an undeclared name is told once, and silences what depends on it | SC201
float x = nothing + 1.0;
x = nothing.x * 2.0;
vec3 y = vec3(nothing, 1.0, 2.0);
//// 4.2.2 an initialiser sees the outer name | ok
float c = 1.0;
{ float c = c + 1.0; o_color = vec4(c); }
//// 4.2.2 a variable is visible after its initialiser | ok
float a = 1.0, b = a;
//// 4.2.2 a variable does not see itself | SC201
float a = a;
//// 4.2.2 a name declared twice in a scope | SC202
float a;
int a;
//// 4.2.2 a nested scope may declare the name again | ok
float a;
{ int a; }
float b = a;
//// 4.2.2 a name ends with its scope | SC201
{ float inner = 1.0; }
float x = inner;
//// 4.2.2 a loop's body shares the scope of its head | SC202
for (int i = 0; i < 2; ++i) { int i; }
//// 4.2.2 a block inside a loop's body is a scope of its own | ok
for (int i = 0; i < 2; ++i) { { int i; } }
//// 4.2.2 a loop's variable ends with the loop | SC201
for (int i = 0; i < 2; ++i) { }
int j = i;
//// 4.2.2 two loops may use the same variable | ok
for (int i = 0; i < 2; ++i) { }
for (int i = 0; i < 2; ++i) { }
//// 4.2.2 a while loop's body shares the scope of its condition | SC202
while (bool go = u_f > 0.0) { bool go; }
//// 4.2.2 the branch of an if is a scope | SC201
if (u_f > 0.0) float t = 1.0;
float x = t;
//// 4.2.2 both branches may declare the same name | ok
if (u_f > 0.0) float t = 1.0; else float t = 2.0;
//// 4.2.2 a do loop's condition does not see its body | SC201
do { bool again = false; } while (again);
//// 6.1 parameters and body share one scope | SC202
void f(float x) { float x; }
void main() { }
//// 6.1 a block in the body may hide a parameter | ok
void f(float x) { { float x = x; } }
void main() { }
//// 6.1 two parameters of one name | SC202
void f(float x, int x) { }
void main() { }
//// 6.1 a parameter may have the name of its function | ok
float f(float f) { return f; }
void main() { }
//// 4.2.2 a local hides a function | SC204
float user = 1.0;
user(1.0);
//// 4.2.2 a local may have the name of a function | ok
float user = 1.0;
float x = user;
//// 4.2.2 a local may have the name of a type | ok
float Ray = 1.0;
float x = Ray;
//// 4.2.2 a local may have the name of a built-in function | ok
float mix = 1.0;
float x = mix + radians(mix);
//// 4.2.2 a local hides an input | ok
float v_uv = 1.0;
float x = v_uv;
//// 4.2.2 a type is no variable | SC103
float x = Ray;
//// 4.2.2 a function is no variable | SC204
float x = user;
//// 4.2.2 a built-in function is no variable | SC204 [glslang refuses]
float x = sin;
//// 4.2.2 a variable is no function | SC204
float x = u_f(1.0);
//// 4.2.2 a global variable and a function of one name | SC202
float f;
void f() { }
void main() { }
//// 4.2.2 a function and a global variable of one name | SC202
void f() { }
float f;
void main() { }
//// 4.2.2 two globals of one name | SC202
float a;
float a;
void main() { }
//// 4.2.2 a struct and a variable of one name | SC202
struct S { float a; };
float S;
void main() { }
//// 4.2.2 a struct declared in a function | ok
struct S { float a; };
S s = S(1.0);
float x = s.a;
//// 4.2.2 a struct ends with its scope | SC201
void f() { struct S { float a; }; }
void main() { float x = S(1.0).a; }
//// 3.7 names with gl_ are reserved | SC203
float gl_mine = 1.0;
//// 3.7 functions with gl_ are reserved | SC203 [glslang accepts]
void gl_f() { }
void main() { }
//// 3.7 names with two underscores are allowed with a warning | ok
float a__b = 1.0;
//// 7.1 gl_FragCoord may be declared again with a layout | ok
layout(origin_upper_left) in vec4 gl_FragCoord;
void main() { }
//// 7.1 a built-in variable keeps its type | SC202
in vec3 gl_FragCoord;
void main() { }
//// 7.1 a built-in variable keeps its storage | SC202
uniform vec4 gl_FragCoord;
void main() { }
//// 7.1 gl_ClipDistance may be given a size | ok
in float gl_ClipDistance[4];
void main() { float x = gl_ClipDistance[3]; }
//// 7.1 gl_Position is of the vertex stage | SC201
vec4 x = gl_Position;
//// 7.1 gl_Position in a vertex shader | ok [vertex]
void main() { gl_Position = vec4(float(gl_VertexID)); gl_PointSize = 1.0; }
//// 7.1 gl_FragCoord cannot be written | SC209
gl_FragCoord = vec4(1.0);
//// 7.1 gl_FragDepth can be written | ok
gl_FragDepth = 0.5;
//// 7.1 the old outputs | ok
gl_FragColor = vec4(1.0);
//// 7.3 built-in constants are constant | ok
float a[gl_MaxDrawBuffers];
const int n = gl_MaxTextureImageUnits + 1;
//// 7.5 built-in uniform state | ok
float x = gl_DepthRange.far - gl_DepthRange.near + gl_DepthRange.diff;
