uniform sampler2D u_history;  // the last picture, behind 16/w
uniform int u_begins;         // 1: there is none

// 1/w at four texels of it, in the order of a gather. The corner is what they share, in texels.
vec4 nearness(vec2 corner) {
    return textureGather(u_history, corner / u_size) / 16.0;
}
