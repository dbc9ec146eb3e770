#version 450 core
uniform float u_time;
uniform vec2 u_resolution;
out vec4 colour;

vec3 rough(vec2 p) {
    vec3 e = { sin(p.x * 3.1 + u_time), exp(sin(p.y * 2.7)), p.x, };
    return e * 0.5;
}

void main() {
    vec2 uv = gl_FragCoord.xy / u_resolution;
    ivec2 cell = { int(floor(uv.x * 8.0)), 3 };
    mat3x2 turn = { { 1, rough(uv).x }, uv, { cell.x, rough(uv.yx).y } };
    mat2 both = { uv, { exp(sin(uv.x)), 1.0 } }, other = { rough(uv).xy, rough(uv).yz };
    vec4 wide = { rough(uv).x, 1, cell.y, both[1].x };
    colour = vec4(turn * rough(uv) + both * other[0], wide.x, wide.w);
}
