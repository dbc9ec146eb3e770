#version 120
// GLSL 1.20: gl_FragColor, texture2D, names that later versions took.
varying vec3 v_position;
varying vec3 v_normal;
varying vec2 v_uv;
uniform sampler2D u_map;
uniform float u_time;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


vec3 sample(vec2 smooth) { return texture2D(u_map, smooth, 0.5).rgb; }

void main() {
    float switch_ = wave(v_position);
    vec3 texture = sample(v_uv) + texture2DProj(u_map, vec3(v_uv, 2.0)).rgb;
    gl_FragColor = vec4(texture * switch_, 1);
    gl_FragColor.rb *= wave(v_normal) + float(2) * 0.25;
    mat2 m = mat2(1.0, v_uv.x, v_uv.y, 1.0);
    gl_FragColor.xy = m * gl_FragColor.yx;
}
