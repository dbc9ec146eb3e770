#version 450
// Push constants without an instance name, a block of varyings without one, sets with a gap.
layout(constant_id = 4) const float SCALE = 2.0;
layout(location = 0) in Surface {
    vec3 v_position;
    vec3 v_normal;
};
layout(location = 0) out vec4 o_color;
layout(set = 2, binding = 0) uniform texture2D u_picture;
layout(set = 2, binding = 1) uniform sampler u_how;
layout(push_constant, std430) uniform Draw {
    mat4 u_model;
    vec3 u_tint[2];
};

void main() {
    float veins = exp(sin(v_position.x * SCALE) * sin(v_position.y * 5.0) * cos(v_position.z * 9.0));
    vec3 picture = texture(sampler2D(u_picture, u_how), v_position.xy).rgb;
    o_color = vec4(picture * pow(veins, 1.7) * v_normal * u_tint[1], veins);
}
