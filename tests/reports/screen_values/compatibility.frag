#version 120
float wave(vec3 p) { return sin(p.x * 5.0) * cos(p.y * 3.0) + sin(p.z * 7.0) * cos(p.x * 11.0); }
void main() {
    float s = 0.0;
    s += wave(gl_TexCoord[0].xyz); // surface
    s += wave(gl_TexCoord[1].xyz); // screen: TexCoord
    s += wave(gl_TexCoord[2].xyz); // surface
    gl_FragColor = vec4(s);
}
