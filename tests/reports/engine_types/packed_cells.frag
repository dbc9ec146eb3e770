#version 450
#extension GL_EXT_shader_explicit_arithmetic_types : require
// Noise of cells whose numbers are hashed in 8 and 16 bits.
layout(location = 0) in vec3 v_position;
layout(location = 0) out vec4 o_color;
uniform vec3 u_tint;

uint16_t hash(i16vec3 cell) {
    uint16_t h = uint16_t(cell.x) * 31us + uint16_t(cell.y) * 57us + uint16_t(cell.z) * 101us;
    h ^= h >> 7us;
    return h * 1031us;
}

u8vec4 bytes(vec3 at) {
    i16vec3 cell = i16vec3(floor(at));
    int16_t parity = (cell.x + cell.y) & 1s;
    return unpack8(uint32_t(hash(cell)) << 8 | uint32_t(uint8_t(parity)));
}

void main() {
    u8vec4 near = bytes(v_position * 16.0);
    i8vec2 low = i8vec2(near.xy) - int8_t(3);
    float32_t ring = sin(dot(v_position, v_position) * 40.0);
    int picked = near.x > uint8_t(1) ? int(low.x) : 2;
    o_color = vec4(u_tint * (float(near.y) / 255.0 + ring * exp(-v_position.z)), float(picked));
}
