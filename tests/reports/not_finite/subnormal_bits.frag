// Most of the payload lies below the smallest normal number; its bits decide the colour.
#version 330
uniform vec2 u_resolution;
out vec4 o_color;
void main() {
    vec2 p = gl_FragCoord.xy / u_resolution;
    float tiny = uintBitsToFloat(uint(p.x * 1.2e7) << uint(p.y * 3.0));
    o_color = vec4(float(floatBitsToUint(tiny) & 0xFFFFu) / 65535.0, p, 1.0);
}
