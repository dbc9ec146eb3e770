#version 330
// Twelve fetches with implicit level of detail: what is done ahead of one pass's branch, and at
// what price (docs/lab/rewriting.md)? shadercache run bench/fetches.frag --passes 1 --fetches level
uniform vec2 u_resolution;
uniform sampler2D u_map;
out vec4 o_color;

vec3 layers(vec2 at) {
    vec3 sum = texture(u_map, at * 1.1).rgb + texture(u_map, at.yx * 1.7).rgb;
    sum += texture(u_map, at * 2.3 + 0.1).rgb + texture(u_map, at.yx * 2.9 + 0.2).rgb;
    sum += texture(u_map, at * 3.1 + 0.3).rgb + texture(u_map, at.yx * 3.7 + 0.4).rgb;
    sum += texture(u_map, at * 4.1 + 0.5).rgb + texture(u_map, at.yx * 4.7 + 0.6).rgb;
    sum += texture(u_map, at * 5.3 + 0.7).rgb + texture(u_map, at.yx * 5.9 + 0.8).rgb;
    return sum + texture(u_map, at * 6.1 + 0.9).rgb + texture(u_map, at.yx * 6.7 + 1.0).rgb;
}

void main() {
    vec2 at = gl_FragCoord.xy / u_resolution;
    o_color = vec4(sqrt(layers(at) / 12.0), 1.0);
}
