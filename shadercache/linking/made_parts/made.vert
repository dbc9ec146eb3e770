attribute vec3 a_position;
attribute vec3 a_normal;
attribute vec4 a_tangent;
attribute vec2 a_uv;
attribute vec2 a_uv1;
attribute vec4 a_color;

uniform mat4 u_model;
uniform mat4 u_view;
uniform mat4 u_projection;
uniform vec3 u_eye;

vec3 made_object_position() { return a_position; }
vec3 made_world_position() { return (u_model * vec4(a_position, 1.0)).xyz; }
vec3 made_view_position() { return (u_view * vec4(made_world_position(), 1.0)).xyz; }
vec4 made_clip() { return u_projection * vec4(made_view_position(), 1.0); }
float made_depth() { return -made_view_position().z; }

vec3 made_object_normal() { return a_normal; }
vec3 made_world_normal() { return (u_model * vec4(a_normal, 0.0)).xyz; }
vec3 made_view_normal() { return (u_view * vec4(made_world_normal(), 0.0)).xyz; }

vec3 made_object_tangent() { return a_tangent.xyz; }
vec3 made_world_tangent() { return (u_model * vec4(a_tangent.xyz, 0.0)).xyz; }
vec3 made_view_tangent() { return (u_view * vec4(made_world_tangent(), 0.0)).xyz; }

vec3 made_object_bitangent() { return a_tangent.w * cross(a_normal, a_tangent.xyz); }
vec3 made_world_bitangent() { return (u_model * vec4(made_object_bitangent(), 0.0)).xyz; }
vec3 made_view_bitangent() { return (u_view * vec4(made_world_bitangent(), 0.0)).xyz; }

mat3 made_object_frame() { return mat3(made_object_tangent(), made_object_bitangent(), a_normal); }
mat3 made_world_frame() {
    return mat3(made_world_tangent(), made_world_bitangent(), made_world_normal());
}
mat3 made_view_frame() {
    return mat3(made_view_tangent(), made_view_bitangent(), made_view_normal());
}

vec3 made_world_to_eye() { return u_eye - made_world_position(); }
vec3 made_view_to_eye() { return -made_view_position(); }

vec2 made_uv() { return a_uv; }
vec2 made_uv1() { return a_uv1; }
vec4 made_color() { return a_color; }

// What the fragment shader reads is declared here.

void main() {
    gl_Position = made_clip();
    // And has its value here.
}
