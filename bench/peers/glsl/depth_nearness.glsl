uniform sampler2D u_color;  // a picture
uniform sampler2D u_depth;  // its window depths
uniform vec2 u_planes;      // of the camera: far / (far - near), far * near / (far - near)

// 1/w at four texels: upper left, upper right, lower right, lower left. Like window depths it is
// linear in the picture. The corner is what they share, in texels.
vec4 nearness(vec2 corner) {
    vec4 depth = textureGather(u_depth, corner / vec2(textureSize(u_depth, 0)));
    return (u_planes.x - depth) / u_planes.y;
}
