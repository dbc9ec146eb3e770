#version 400
// One where a fetch at the level of detail that the driver tells is another than its own.
uniform sampler2D u_map;
in vec2 v_at;
out float o_other;
void main() {
    vec2 at = v_at + 0.2 * sin(v_at.yx * 5.0);
    vec4 level = textureLod(u_map, at, textureQueryLod(u_map, at).y);
    o_other = float(texture(u_map, at) != level);
}
