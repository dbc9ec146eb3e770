struct Ray { vec3 origin; vec3 direction; };
struct Lit { Ray ray; float weights[3]; };
uniform sampler2D u_map;
uniform samplerCube u_cube;
uniform sampler2D u_maps[2];
uniform float u_f;
uniform int u_i;
uniform vec3 u_v;
uniform mat3 u_m;
in vec2 v_uv;
in vec3 v_n;
flat in int v_id;
out vec4 o_color;
const int K = 3;
const vec3 AXIS = vec3(0.0, 1.0, 0.0);
float g;
float user(float x) { return x; }
void writes(out float x, inout vec3 y) { x = y.x; y.x = 0.0; }
