#version 120

// Desktop GLSL 1.20, as games of 2006 wrote it.

attribute vec3 tangent;
varying vec3 normal, eye;
centroid varying vec2 uv;
invariant varying float fog;
invariant gl_Position;
uniform mat4x3 bones[4];
const float steps[2] = float[2](0.5, 1.0f);

int uint, precision, lowp, layout, sample, round, smooth, buffer;

vec4 skin(vec4 vertex, float half_[2]) {
    return vec4(bones[0] * vertex, half_[1]);
}

void main(void) {
    vec4 p = skin(gl_Vertex, steps);
    eye = vec3(gl_ModelViewMatrix * p);
    normal = gl_NormalMatrix * gl_Normal + cross(tangent, eye) * float(steps.length());
    fog = clamp(-eye.z / 10., 0., 1.);
    uv = gl_MultiTexCoord0.st;
    gl_FrontColor = gl_Color;
    gl_Position = ftransform();
}
