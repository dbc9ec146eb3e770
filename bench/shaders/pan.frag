#version 330
// A picture that moves by u_velocity pixels a frame. Its red is the number of the frame, so that
// what is reused tells how old it is: the mean over all that a filter took it from.
uniform vec2 u_resolution;
uniform vec2 u_velocity;
uniform float u_frame;
out vec4 o_color;

vec4 scPreviousClip() {
    vec2 place = gl_FragCoord.xy - u_velocity;
    return vec4(2.0 * place / u_resolution - 1.0, 0.0, 1.0);
}

void main() {
    vec3 born = vec3(u_frame, gl_FragCoord.xy) * 1.0;
    o_color = vec4(born, 1.0);
}
