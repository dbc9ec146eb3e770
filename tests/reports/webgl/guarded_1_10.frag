// The idiom of files that are both: GLSL 1.10 here, for nothing but WebGL sees the precision.
#ifdef GL_ES
precision mediump float;
#endif
uniform float time;
uniform vec2 resolution;

void main() {
    vec2 uv = gl_FragCoord.xy / resolution;
    float highp = 2.0;
    gl_FragColor = vec4(exp(sin(uv.xyx * 9.0 * highp + time)), 1.0);
}
