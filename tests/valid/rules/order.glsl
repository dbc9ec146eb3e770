//// ES 1.00 4.7 precisions come last | SC221 [100 bare]
mediump uniform vec2 x;
void main() { }
//// ES 3.00 4.7 precisions come last | SC221 SC221 [es]
highp in vec2 x;
centroid highp in vec2 y;
in highp vec2 z;
void main() { }
//// ES 1.00 4.7 invariant comes first | SC221 [100]
mediump invariant varying vec2 x;
void main() { }
//// 3.30 4.7 interpolation before precision | SC221 SC221
highp smooth in vec2 x;
highp centroid in vec2 y;
void main() { }
//// 3.30 4.5.2 precisions beside a storage qualifier | ok
highp uniform vec2 x;
void main() { }
//// 3.30 4.7 const before in | SC221
float f(in const float x) { return x; }
float g(const in float x) { return x; }
void main() { }
//// 3.30 4.7 interpolation before storage | SC221
in smooth vec2 x;
void main() { }
//// 4.20 4.7 any order | ok [420]
in highp smooth vec2 x;
float f(in const float y) { return y; }
void main() { }
//// ES 3.10 4.10 any order | ok [310 es]
in mediump smooth vec2 x;
void main() { }
//// 4.60 4.8.1 invariant before use | SC221 [120 vertex]
void main() { gl_Position = vec4(1.0); }
invariant gl_Position;
//// 4.60 4.8.1 inputs are not invariant | SC221 SC221 [430]
in vec2 a;
invariant a;
invariant in vec2 b;
void main() { }
//// 3.30 4.6.1 inputs of fragment shaders are invariant | ok [330]
in vec2 a;
invariant a;
void main() { }
//// ES 3.00 4.6.1 inputs are not invariant | SC221 [es]
invariant in vec2 a;
void main() { }
//// ES 3.00 4.3.6 integer outputs of a vertex shader are flat | SC221 [es vertex]
out uvec4 x;
void main() { }
//// ES 3.10 4.3.6 only inputs are flat | ok [310 es vertex]
out uvec4 x;
void main() { }
//// ES 3.10 6.2 a switch ends as it likes | ok [310 es]
void main() { switch (1) { case 1: } }
//// ES 3.00 6.2 a switch ends with a statement | SC220 [es]
void main() { switch (1) { case 1: } }
//// ES 1.00 3.8 two underscores are reserved | SC203 [100]
float a__b;
void main() { }
//// ES 1.00 6.1 a definition may come before its declaration | ok [100]
float f(float x) { return x; }
float f(float x);
void main() { }
//// 1.50 7.2 gl_FragCoord is redeclared before its use | SC202 [150]
vec4 x = gl_FragCoord;
in vec4 gl_FragCoord;
void main() { }
//// 1.50 7.2 the second time may come after | ok [150]
in vec4 gl_FragCoord;
vec4 x() { return gl_FragCoord; }
in vec4 gl_FragCoord;
void main() { }
//// 1.30 7.1 gl_VertexID stays as it is | SC203 [130 vertex]
in int gl_VertexID;
void main() { }
//// 3.30 7.2 gl_FragDepth stays as it is | SC203
out float gl_FragDepth;
void main() { }
//// 4.20 7.2 gl_FragDepth has a layout | ok [420]
layout(depth_less) out float gl_FragDepth;
void main() { }
//// 1.30 7.1 as many clip distances as there are | SC215 [130 vertex]
out float gl_ClipDistance[9];
void main() { }
//// 3.30 8.7 offsets are near | SC226
uniform sampler2D s;
void main() { textureOffset(s, vec2(0.0), ivec2(7, -8)); textureOffset(s, vec2(0.0), ivec2(8, 0)); }
