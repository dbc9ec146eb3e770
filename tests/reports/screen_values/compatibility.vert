#version 120
// Coordinates of the fixed-function pipeline: one of the surface, one of the screen.
uniform float u_flip;
vec4 screenPosition(vec4 clip) {
    vec4 half_ = clip * 0.5;
    half_.xy = vec2(half_.x, half_.y * u_flip) + half_.w;
    half_.zw = clip.zw;
    return half_;
}
void main() {
    gl_Position = ftransform();
    gl_TexCoord[0] = gl_MultiTexCoord0;
    gl_TexCoord[1] = screenPosition(gl_ModelViewProjectionMatrix * gl_Vertex);
    gl_TexCoord[2] = gl_ModelViewMatrix * gl_Vertex;
}
