#version 450
#extension GL_EXT_fragment_shader_barycentric : require
// Edges of triangles by barycentric coordinates, and a colour that is not interpolated by hand.
layout(location = 0) in vec3 v_position;
layout(location = 1) pervertexEXT in vec3 v_tint[];
layout(location = 0) out vec4 o_color;

void main() {
    vec3 steps = gl_BaryCoordEXT;
    float edge = smoothstep(0.0, 0.03, min(steps.x, min(steps.y, steps.z)));
    vec3 tint = v_tint[0] * gl_BaryCoordEXT.x + v_tint[1] * gl_BaryCoordEXT.y
        + v_tint[2] * gl_BaryCoordEXT.z;
    vec3 corner = exp(sin(v_tint[0] * 7.0) * cos(v_tint[1] * 5.0));
    float veins = exp(sin(v_position.x * 7.0) * sin(v_position.y * 5.0) * cos(v_position.z * 9.0));
    o_color = vec4(mix(vec3(1.0), tint, edge) * veins + corner, 1.0);
}
