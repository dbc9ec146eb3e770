#version 100
varying highp vec3 v_position;
varying highp vec3 v_normal;
varying highp vec2 v_uv;
uniform highp float u_a;
uniform highp vec3 u_b;
uniform int u_n;
uniform sampler2D u_mipmapped;
uniform sampler2D u_plain;
struct Pair { highp float first; highp vec3 second; };
int f0(inout highp vec3 a, out highp vec4 b, highp float c) {
    b = vec4(0.5, 0.5, 0.5, 0.5);
    bool d = true, e = (!d);
    a.y += 0.5;
    return int(8.0 * fract(0.5));
}
highp vec3 f1(highp vec3 a, inout highp vec2 b) {
    highp mat2 c = mat2(1.0), d = c;
    highp float e = sin(v_position.x);
    (sin(vec4(0.5, 0.5, 0.5, 0.5))).x;
    b.y = 1.0;
    return vec3(0.5, 0.5, 0.5);
}
void main() {
    gl_FragColor = vec4(0.0);
    highp vec3 s = v_position + sin(3.0 * v_position);
    highp vec4 t = texture2D(u_mipmapped, (0.125 * vec2(ivec2(3)))).xzwx * 0.5;
    int k = u_n;
    highp vec3 e = f1((vec4(3.0, 3.0, 1.7, 1.7)).zyx, t.zx);
    highp vec3 h = u_b, a = v_normal;
    {
        highp vec3 g = texture2DProj(u_plain, vec3(cos(t.gb), 1.25)).wwy;
        Pair e = Pair(0.5, vec3(0.25)), a = Pair(v_normal.g, v_position);
    }
    int c = (k = --k);
    gl_FragColor += (pow(fract(t) + 0.5, faceforward(vec4(2.0, 3.0, 0.25, 0.5), t, vec4(0.25, 3.0, 0.0, 0.5)) * 0.0 + 1.5)).xzwz;
    gl_FragColor.x += 0.2 * fract(s.y);
    gl_FragColor.x += 0.2 * fract(t.y);
    gl_FragColor.x += 0.2 * fract(0.37 * float(k));
    gl_FragColor.z += 0.2 * fract(e.y);
    gl_FragColor.w += 0.2 * fract(h.y);
    gl_FragColor.y += 0.2 * fract(a.y);
    gl_FragColor.w += 0.2 * fract(0.37 * float(c));
}
