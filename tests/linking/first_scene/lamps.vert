#version 330 core
layout(location = 0) in vec3 aPos;
layout(location = 1) in vec3 aNormal;
layout(location = 2) in vec2 aTexCoords;
layout(location = 3) in mat4 aInstance;

out Surface {
    vec3 place;
    vec3 normal;
    vec2 uv;
} to_fragment;

uniform mat4 projection, view, model;

void main() {
    vec4 place = model * aInstance * vec4(aPos, 1.0);
    to_fragment.place = place.xyz;
    to_fragment.normal = mat3(model) * aNormal;
    to_fragment.uv = aTexCoords;
    gl_Position = projection * view * place;
}
