// No precisions: GLSL 1.10 has no such words, and these are names.
uniform vec2 resolution;
float mediump(float precision) { return exp(sin(precision)); }
float lowp = 0.5, highp;

void main() {
    vec2 uv = gl_FragCoord.xy / resolution;
    highp = mediump(uv.x) + lowp;
    gl_FragColor = vec4(mediump(highp), uv, 1.0);
}
