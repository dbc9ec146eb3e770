#version 450
// Objects of an engine: what changes with the frame in a set, what changes with the draw pushed.
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec2 a_uv;
layout(location = 0) out Surface {
    vec3 position;
    vec3 normal;
    vec2 uv;
} surface;
layout(location = 3) flat out uint v_material;

layout(set = 0, binding = 0, std140) uniform Frame {
    mat4 view_projection;
    vec4 eye;
    vec4 light;
} frame;

struct Instance {
    mat4 model;
    uint material;
};
layout(set = 1, binding = 0, std140) uniform Instances {
    Instance instances[64];
};
layout(push_constant) uniform Draw {
    uint first;
    float time;
} draw;

void main() {
    Instance instance = instances[draw.first + gl_InstanceIndex];
    surface.position = (instance.model * vec4(a_position, 1.0)).xyz;
    surface.normal = mat3(instance.model) * a_normal;
    surface.uv = a_uv + 0.001 * float(gl_VertexIndex & 1);
    v_material = instance.material;
    gl_Position = frame.view_projection * vec4(surface.position, 1.0);
}
