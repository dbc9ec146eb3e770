#version 120
varying vec3 v_position;
varying vec3 v_normal;
varying vec2 v_uv;
const bool off = false;
const bvec2 both = bvec2(false, true);
void main() {
    float x = float(!false) + 3.0 * v_position.x;
    vec2 y = vec2(both) * v_uv + float(off) * v_normal.x;
    gl_FragColor = vec4(sin(x), y * vec2(float(false), float(true && off)), v_uv.x);
}
