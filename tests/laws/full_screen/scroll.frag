#version 300 es
precision mediump float;
// A flat pattern that scrolls to the left: only where it was is said, not where the pixel is.
uniform highp vec2 u_resolution;
uniform highp float u_time;
uniform highp float u_time_delta;
out vec4 o_color;

const highp float SPEED = 0.7;

highp vec2 place(highp float time) {
    return 2.0 * gl_FragCoord.xy / u_resolution - 1.0 + vec2(SPEED * time, 0.0);
}

highp vec4 scPreviousClip() {
    return vec4(place(u_time) - vec2(SPEED * (u_time - u_time_delta), 0.0), 0.0, 1.0);
}

highp float pattern(highp vec2 p) {
    return sin(9.0 * p.x + 2.0 * sin(5.0 * p.y)) * cos(7.0 * p.y + sin(3.0 * p.x));
}

void main() {
    highp float rings = pattern(place(u_time)) + 0.3 * pattern(2.3 * place(u_time).yx);
    o_color = vec4(vec3(0.5 + 0.3 * rings), 1.0);
}
