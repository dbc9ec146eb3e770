#version 400 core

in vec3 v_position;
invariant in vec4 sc_previous;
precise layout(location = 0) out vec4 o_color;
precise layout(location = 1) out vec4 o_cache;
uniform samplerCubeArray u_sky;

float half_of(float x, precise out float rest) {
    precise float y = x * 0.5;
    rest = x - y;
    return y;
}

void main() {
    precise float rest;
    precise vec3 p = v_position * half_of(v_position.x, rest);
    double d = 1.0lf;
    o_color = vec4(p, rest) + texture(u_sky, vec4(p, float(d)));
    o_cache = sc_previous;
}
