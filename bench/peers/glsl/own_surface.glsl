#extension GL_ARB_texture_gather : require

// x: far / (far - near), y: far * near / (far - near), of the camera's planes.
uniform vec2 u_planes;

// How many places are searched around; a constant would make drivers unroll the loop.
uniform int u_steps;

uniform sampler2D u_color;  // a picture
uniform sampler2D u_depth;  // its window depths

const float SAME = 0.01;     // of the nearness: what lies so far off a plane is another surface
const float STEEP = 1.2;     // a surface's nearness changes by no more from texel to texel
const float SIMILAR = 0.05;  // what is found elsewhere may be farther off
const mat2 TURN = 1.4 * mat2(-0.737, 0.676, -0.676, -0.737);  // by the golden angle, and outwards

// 1/w at four texels: upper left, upper right, lower right, lower left. Like window depths it is
// linear in the picture. The corner is what they share, in texels.
vec4 nearness(vec2 corner) {
    vec4 depth = textureGather(u_depth, corner / vec2(textureSize(u_depth, 0)));
    return (u_planes.x - depth) / u_planes.y;
}

// Which of the four has the most of something, from the lower left one.
vec2 which(vec4 merit) {
    vec2 upper = merit.x > merit.y ? vec2(merit.x, 0.0) : vec2(merit.y, 1.0);
    vec2 lower = merit.w > merit.z ? vec2(merit.w, 0.0) : vec2(merit.z, 1.0);
    return upper.x > lower.x ? vec2(upper.y, 1.0) : vec2(lower.y, 0.0);
}

float largest(vec4 v) {
    return max(max(v.x, v.y), max(v.z, v.w));
}

// Bilinear weights of the four.
vec4 tent(vec2 part) {
    vec2 column = vec2(1.0 - part.x, part.x), row = vec2(1.0 - part.y, part.y);
    return column.xyyx * row.yyxx;
}

// Where to fetch the picture bilinearly, in texels, so that it is that of a plane with this nearness
// at a place and this slope. The fetch is moved off the columns and rows of texels that are not on
// the plane; where that does not help, it is of the best single one, and where there is none, of one
// farther away.
vec2 own_surface(vec2 place, float near, vec2 slope) {
    vec2 corner = floor(place - 0.5) + 1.0;
    vec2 part = place + 0.5 - corner;
    vec4 plane = near + slope.x * (vec4(0.0, 1.0, 1.0, 0.0) - part.x)
        + slope.y * (vec4(1.0, 1.0, 0.0, 0.0) - part.y);
    // Seen edge on, a plane would reach whatever lies behind it.
    plane = clamp(plane, near / STEEP, near * STEEP);
    vec4 apart = abs(nearness(corner) - plane) / near;
    vec4 same = vec4(lessThan(apart, vec4(SAME)));
    vec2 moved = part;
    moved.x = same.x + same.w == 0.0 ? 1.0 : same.y + same.z == 0.0 ? 0.0 : moved.x;
    moved.y = same.z + same.w == 0.0 ? 1.0 : same.x + same.y == 0.0 ? 0.0 : moved.y;
    bool alone = dot(tent(moved), 1.0 - same) > 0.0;
    moved = alone ? which(mix(-apart, tent(part), same)) : moved;
    vec2 found = corner - 0.5 + moved;
    float best = -largest(-apart);
    vec2 way = vec2(2.0, 0.0);
    for (int i = 0; i < u_steps && best > SIMILAR; i++) {
        corner = floor(place + way + 0.5);
        apart = abs(nearness(corner) - near) / near;
        bool better = -largest(-apart) < best;
        found = better ? corner - 0.5 + which(-apart) : found;
        best = better ? -largest(-apart) : best;
        way = TURN * way;
    }
    return found;
}

vec3 picture(vec2 place) {
    return textureLod(u_color, place / vec2(textureSize(u_color, 0)), 0.0).rgb;
}
