//// Without a version.
#version 110

void main() {
    gl_FragColor = vec4(1.0);
}
//// becomes
#version 330 core

out vec4 legacy_FragColor;

void main() {
    legacy_FragColor = vec4(1.0);
}
// gl_FragColor is legacy_FragColor

//// GLSL 1.20.
#version 120

void main() {
    gl_FragColor = vec4(1.0);
}
//// becomes
#version 330 core

out vec4 legacy_FragColor;

void main() {
    legacy_FragColor = vec4(1.0);
}
// gl_FragColor is legacy_FragColor

//// The compatibility profile is left.
#version 150 compatibility

void main() {
    gl_FragColor = vec4(1.0);
}
//// becomes
#version 330 core

out vec4 legacy_FragColor;

void main() {
    legacy_FragColor = vec4(1.0);
}
// gl_FragColor is legacy_FragColor

//// A later version with the compatibility profile.
#version 430 compatibility

void main() {
    gl_FragColor = vec4(1.0);
}
//// becomes
#version 430 core

out vec4 legacy_FragColor;

void main() {
    legacy_FragColor = vec4(1.0);
}
// gl_FragColor is legacy_FragColor

//// A second target cannot stand beside gl_FragColor.
#version 330

void main() {
    gl_FragColor = vec4(1.0);
}
//// becomes
#version 330

out vec4 legacy_FragColor;

void main() {
    legacy_FragColor = vec4(1.0);
}
// gl_FragColor is legacy_FragColor

//// GLSL ES 1.00.
#version 100

void main() {
    gl_FragColor = vec4(1.0);
}
//// becomes
#version 300 es

out mediump vec4 legacy_FragColor;

void main() {
    legacy_FragColor = vec4(1.0);
}
// gl_FragColor is legacy_FragColor

//// What can hold variants stays as it is.
#version 330

out vec4 c;

void main() {
    c = vec4(1.0);
}
//// becomes
#version 330

out vec4 c;

void main() {
    c = vec4(1.0);
}

//// Shadows keep their four components.
#version 120

uniform sampler2DShadow s;
varying vec4 p;

void main() {
    gl_FragColor = shadow2DProj(s, p);
}
//// becomes
#version 330 core

out vec4 legacy_FragColor;
uniform sampler2DShadow s;
in vec4 p;

void main() {
    legacy_FragColor = vec4(vec3(textureProj(s, p)), 1.0);
}
// gl_FragColor is legacy_FragColor

//// Elements of gl_FragData are outputs of their own.
#version 110

void main() {
    gl_FragData[0] = vec4(1.0);
    gl_FragData[2] = vec4(0.5);
}
//// becomes
#version 330 core

layout(location = 0) out vec4 legacy_FragColor;
layout(location = 2) out vec4 legacy_FragData_2;

void main() {
    legacy_FragColor = vec4(1.0);
    legacy_FragData_2 = vec4(0.5);
}
// gl_FragData[0] is legacy_FragColor
// gl_FragData[2] is legacy_FragData_2

//// An array of outputs that is indexed by a variable.
#version 110

uniform int i;

void main() {
    gl_FragData[i] = vec4(1.0);
}
//// becomes
#version 330 core

out vec4 legacy_FragData[8];
uniform int i;

void main() {
    legacy_FragData[i] = vec4(1.0);
}
// gl_FragData is legacy_FragData

//// Arrays of both stages are of one size.
#version 110

void main() {
    gl_FragColor = gl_TexCoord[1];
}
//// vertex
#version 110

varying vec4 gl_TexCoord[4];

void main() {
    gl_TexCoord[2] = gl_MultiTexCoord1;
    gl_Position = ftransform();
}
//// becomes
#version 330 core

out vec4 legacy_FragColor;
in vec4 legacy_TexCoord[4];

void main() {
    legacy_FragColor = legacy_TexCoord[1];
}
// gl_FragColor is legacy_FragColor
#version 330 core

out vec4 legacy_TexCoord[4];
in vec4 legacy_MultiTexCoord1;
uniform mat4 legacy_ModelViewProjectionMatrix;
in vec4 legacy_Vertex;

void main() {
    legacy_TexCoord[2] = legacy_MultiTexCoord1;
    gl_Position = legacy_ModelViewProjectionMatrix * legacy_Vertex;
}
// gl_MultiTexCoord1 is legacy_MultiTexCoord1
// gl_ModelViewProjectionMatrix is legacy_ModelViewProjectionMatrix
// gl_Vertex is legacy_Vertex

//// A declared array keeps its size.
#version 120

varying vec4 gl_TexCoord[2];
uniform int i;

vec4 sum(vec4 t[2]) {
    return t[0] + t[1];
}

void main() {
    gl_FragColor = sum(gl_TexCoord) + gl_TexCoord[i];
}
//// becomes
#version 330 core

out vec4 legacy_FragColor;
in vec4 legacy_TexCoord[2];
uniform int i;

vec4 sum(vec4 t[2]) {
    return t[0] + t[1];
}

void main() {
    legacy_FragColor = sum(legacy_TexCoord) + legacy_TexCoord[i];
}
// gl_FragColor is legacy_FragColor

//// An array that is indexed by a variable has room, and fields that nobody reads need no value.
#version 110

uniform int i;

void main() {
    gl_FragColor = gl_LightSource[i].diffuse;
}
//// becomes
#version 330 core

struct legacy_LightSourceParameters {
    vec4 diffuse;
};

out vec4 legacy_FragColor;
uniform legacy_LightSourceParameters legacy_LightSource[8];
uniform int i;

void main() {
    legacy_FragColor = legacy_LightSource[i].diffuse;
}
// gl_FragColor is legacy_FragColor
// gl_LightSource is legacy_LightSource

//// The colour goes from stage to stage.
#version 110

void main() {
    gl_FragColor = gl_Color + gl_SecondaryColor;
}
//// vertex
#version 110

void main() {
    gl_FrontColor = gl_Color;
    gl_FrontSecondaryColor = vec4(0.0);
    gl_BackColor = gl_Color;
    gl_Position = gl_Vertex;
}
//// becomes
#version 330 core

out vec4 legacy_FragColor;
in vec4 legacy_FrontColor;
in vec4 legacy_FrontSecondaryColor;

void main() {
    legacy_FragColor = legacy_FrontColor + legacy_FrontSecondaryColor;
}
// gl_FragColor is legacy_FragColor
#version 330 core

out vec4 legacy_FrontColor;
in vec4 legacy_Color;
out vec4 legacy_FrontSecondaryColor;
out vec4 legacy_BackColor;
in vec4 legacy_Vertex;

void main() {
    legacy_FrontColor = legacy_Color;
    legacy_FrontSecondaryColor = vec4(0.0);
    legacy_BackColor = legacy_Color;
    gl_Position = legacy_Vertex;
}
// gl_Color is legacy_Color
// gl_Vertex is legacy_Vertex

//// Names that the new version takes are renamed everywhere.
#version 110

varying vec2 smooth;
uniform float round;

struct flat {
    float uint;
};

float inverse(float x) {
    return x;
}

void main() {
    flat f;
    f.uint = inverse(round) + smooth.x;
    gl_FragColor = vec4(f.uint);
}
//// vertex
#version 110

varying vec2 smooth;
attribute vec2 uint;

void main() {
    smooth = uint;
    gl_Position = vec4(uint, 0.0, 1.0);
}
//// becomes
#version 330 core

out vec4 legacy_FragColor;
in vec2 legacy_smooth;
uniform float legacy_round;

struct legacy_flat {
    float legacy_uint;
};

float legacy_inverse(float x) {
    return x;
}

void main() {
    legacy_flat f;
    f.legacy_uint = legacy_inverse(legacy_round) + legacy_smooth.x;
    legacy_FragColor = vec4(f.legacy_uint);
}
// gl_FragColor is legacy_FragColor
// round is legacy_round
#version 330 core

out vec2 legacy_smooth;
in vec2 legacy_uint;

void main() {
    legacy_smooth = legacy_uint;
    gl_Position = vec4(legacy_uint, 0.0, 1.0);
}
// uint is legacy_uint

//// Functions and variables of 1.10 have names apart.
#version 110

float f;

float f(float x) {
    return x;
}

void main() {
    f = f(2.0);
    gl_FragColor = vec4(f);
}
//// becomes
#version 330 core

out vec4 legacy_FragColor;
float legacy_f;

float f(float x) {
    return x;
}

void main() {
    legacy_f = f(2.0);
    legacy_FragColor = vec4(legacy_f);
}
// gl_FragColor is legacy_FragColor

//// A function that hides a built-in one.
#version 130

float round(float x) {
    return x;
}

void main() {
    round(1.0);
}
//// becomes
#version 330 core

float legacy_round(float x) {
    return x;
}

void main() {
    legacy_round(1.0);
}

//// A variable goes on hiding a function.
#version 130

uniform float round;
out vec4 c;

void main() {
    c.x = round;
}
//// becomes
#version 330 core

uniform float round;
out vec4 c;

void main() {
    c.x = round;
}

//// A struct of which only the name is used has all its fields.
#version 120

void main() {
    gl_FogParameters f = gl_Fog;
}
//// becomes
#version 330 core

struct legacy_FogParameters {
    vec4 color;
    float density;
    float start;
    float end;
    float scale;
};

uniform legacy_FogParameters legacy_Fog;

void main() {
    legacy_FogParameters f = legacy_Fog;
}
// gl_Fog is legacy_Fog

//// Extensions that are part of the new version go.
#version 120
#extension GL_ARB_texture_rectangle : require
#extension GL_ARB_gpu_shader5 : enable

void main() {
    gl_FragColor = vec4(1.0);
}
//// becomes
#version 330 core
#extension GL_ARB_gpu_shader5 : enable

out vec4 legacy_FragColor;

void main() {
    legacy_FragColor = vec4(1.0);
}
// gl_FragColor is legacy_FragColor

//// GLSL ES 3.00 has no invariant inputs.
#version 100

precision mediump float;
invariant varying vec2 v;

void main() {
    gl_FragColor = vec4(v, v);
}
//// becomes
#version 300 es

out mediump vec4 legacy_FragColor;
precision mediump float;
in vec2 v;

void main() {
    legacy_FragColor = vec4(v, v);
}
// gl_FragColor is legacy_FragColor

//// An invariant output stays.
#version 100

invariant gl_FragCoord;
invariant gl_FragColor;

void main() {
    gl_FragColor = gl_FragCoord;
}
//// becomes
#version 300 es

out mediump vec4 legacy_FragColor;
invariant legacy_FragColor;

void main() {
    legacy_FragColor = gl_FragCoord;
}
// gl_FragColor is legacy_FragColor

//// Constants of the fixed-function pipeline.
#version 120

void main() {
    gl_FragColor = vec4(float(gl_MaxLights));
}
//// becomes
#version 330 core

out vec4 legacy_FragColor;

void main() {
    legacy_FragColor = vec4(float(8));
}
// gl_FragColor is legacy_FragColor

//// A parameter that GLSL ES 1.00 lets its function hide.
#version 100

precision mediump float;

float f(float x) {
    float x = x;
    return x;
}

void main() {
    gl_FragColor = vec4(f(1.0));
}
//// becomes
#version 300 es

out mediump vec4 legacy_FragColor;
precision mediump float;

float f(float x) {
    float x_1 = x;
    return x_1;
}

void main() {
    legacy_FragColor = vec4(f(1.0));
}
// gl_FragColor is legacy_FragColor

//// Textures of cameras.
#version 100
#extension GL_OES_EGL_image_external : require

precision mediump float;
uniform samplerExternalOES s;

void main() {
    gl_FragColor = texture2D(s, vec2(0.5));
}
//// becomes
#version 300 es
#extension GL_OES_EGL_image_external_essl3 : require

out mediump vec4 legacy_FragColor;
precision mediump float;
uniform samplerExternalOES s;

void main() {
    legacy_FragColor = texture(s, vec2(0.5));
}
// gl_FragColor is legacy_FragColor

//// Structs with the names of types of later versions.
#version 330 core
struct int64_t {
    float dmat2;
};
struct dmat2 {
    int64_t at;
    float more;
};

in float v;
out vec4 color;

void main() {
    dmat2 a = dmat2(int64_t(v), 1.0);
    color = vec4(a.at.dmat2, a.more, v, 1.0);
}
//// becomes
#version 330 core

struct legacy_int64_t {
    float dmat2;
};

struct legacy_dmat2 {
    legacy_int64_t at;
    float more;
};

in float v;
out vec4 color;

void main() {
    legacy_dmat2 a = legacy_dmat2(legacy_int64_t(v), 1.0);
    color = vec4(a.at.dmat2, a.more, v, 1.0);
}
