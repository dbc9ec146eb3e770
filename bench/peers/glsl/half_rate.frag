#version 330
// The last frame, warped: each pixel takes what its point showed there. Where that was hidden, some
// places around are tried, ever farther away.

uniform int u_steps;  // how many; a constant would make drivers unroll the loop

layout(location = 0) out vec4 o_color;

const float SIMILAR = 0.05;  // of the nearness: what fills holes may be so far off
const mat2 TURN = 1.4 * mat2(-0.737, 0.676, -0.676, -0.737);  // by the golden angle, and outwards

void main() {
    vec2 slope = vec2(dFdx(gl_FragCoord.w), dFdy(gl_FragCoord.w));
    vec2 place = last_place();
    float near = last_nearness();
    vec3 found = own_surface(place, near, slope);
    vec2 way = vec2(2.0, 0.0);
    for (int i = 0; i < u_steps && found.z > SIMILAR; i++) {
        vec2 corner = floor(place + way + 0.5);
        vec4 fit = -abs(nearness(corner) - near) / near;
        found = -largest(fit) < found.z ? vec3(corner - 0.5 + which(fit), -largest(fit)) : found;
        way = TURN * way;
    }
    o_color = vec4(picture(found.xy), 1.0);
}
