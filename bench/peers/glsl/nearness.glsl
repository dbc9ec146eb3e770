// How near a window depth is: 1/w, which is linear in the picture, as window depths are.
// x: far / (far - near), y: far * near / (far - near).
uniform vec2 u_planes;

float nearness(float window_depth) {
    return (u_planes.x - window_depth) / u_planes.y;
}
