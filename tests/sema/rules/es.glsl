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
