// What a WebGL 1 engine hands to its driver: precisions stand at the declarations.
#extension GL_OES_standard_derivatives : enable
varying mediump vec2 v_uv;
varying highp vec3 v_position;
uniform lowp sampler2D u_map;
uniform mediump float u_time;

highp float wave(highp vec3 p) {
    return sin(p.x * 3.1 + u_time) * exp(sin(p.y * 2.7)) * exp(cos(p.z));
}

void main() {
    lowp vec4 texel = texture2D(u_map, v_uv);
    gl_FragColor = vec4(texel.rgb * wave(v_position), 1.0);
}
