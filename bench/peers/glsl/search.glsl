// How many places are searched; a constant would make drivers unroll the loop.
uniform int u_steps;

const float SIMILAR = 0.05;  // of the nearness: what is found elsewhere may be so far off
const mat2 TURN = 1.4 * mat2(-0.737, 0.676, -0.676, -0.737);  // by the golden angle, and outwards

// The picture where a surface was found; where it was not, of something similar around the place.
vec3 picture(vec3 found, vec2 place, float near) {
    vec2 way = vec2(2.0, 0.0);
    for (int i = 0; i < u_steps && found.z > SIMILAR; i++) {
        vec2 corner = floor(place + way + 0.5);
        vec4 fit = -abs(nearness(corner) - near) / near;
        found = -largest(fit) < found.z ? vec3(corner - 0.5 + which(fit), -largest(fit)) : found;
        way = TURN * way;
    }
    return textureLod(u_color, found.xy / vec2(textureSize(u_color, 0)), 0.0).rgb;
}
