// On a surface: a NaN beside an integer and a boolean, so texels are unsigned integers; all of the
// surface has the same integer, so that what is left of the filter's texels can be used.
#version 330
in vec3 v_position;
in vec3 v_normal;
out vec4 o_color;
struct Layer { vec2 depth; int kind; bool lit; };
Layer layer(vec3 at) {
    vec3 wave = sin(9.0 * at) * cos(5.0 * at.yzx);
    return Layer(vec2(sqrt(wave.x + 0.6), log(wave.y)), int(3.5 + 0.1 * wave.z), wave.z < 7.0);
}
void main() {
    Layer it = layer(v_position);
    vec2 shown = it.lit ? max(it.depth, vec2(-0.5)) : vec2(0.0);
    o_color = vec4(shown * (0.6 + 0.4 * normalize(v_normal).z), float(it.kind) / 4.0, 1.0);
}
