const float SAME = 0.01;  // of the nearness: what lies so far off a plane is another surface
const float STEEP = 1.2;  // a surface's nearness changes by no more from texel to texel

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

// Where to fetch a picture bilinearly, in texels, so that it is that of a plane with this nearness at
// a place and this slope. The fetch is moved off the columns and rows of texels that are not on the
// plane; where that does not help, it is of the best single one. z: how far that is off, as a share
// of the nearness.
vec3 own_surface(vec2 place, float near, vec2 slope) {
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
    return vec3(corner - 0.5 + moved, -largest(-apart));
}
