#version 330
uniform vec4 sc_scale;
uniform vec2 u_resolution;
out vec4 color;

//// Wherever it stands, and whatever is taken of it.
float depth() {
    return gl_FragCoord.z;
}
void main() {
    vec2 uv = gl_FragCoord.xy / u_resolution;
    color = vec4(uv, depth(), gl_FragCoord[3]) + gl_FragCoord;
}
//// becomes
#version 330

uniform vec4 sc_scale;
uniform vec2 u_resolution;
out vec4 color;

float depth() {
    return vec4((gl_FragCoord.xy - sc_scale.zw) / sc_scale.xy, gl_FragCoord.zw).z;
}

void main() {
    vec2 uv = vec4((gl_FragCoord.xy - sc_scale.zw) / sc_scale.xy, gl_FragCoord.zw).xy / u_resolution;
    color = vec4(uv, depth(), vec4((gl_FragCoord.xy - sc_scale.zw) / sc_scale.xy, gl_FragCoord.zw)[3]) + vec4((gl_FragCoord.xy - sc_scale.zw) / sc_scale.xy, gl_FragCoord.zw);
}
