#version 330
uniform sampler2D u_map;
uniform float u_a;
in vec2 v_uv;
out vec4 color;
vec4 wave(vec2 p) { return sin(texture(u_map, p)) * exp(texture(u_map, p * 2.0)); }
float g;
float writes() { g = 1.0; return g; }

//// Costly choices become statements.
void main() {
    vec4 a = u_a > 0.0 ? wave(v_uv) : vec4(1.0);
    a *= u_a > 1.0 ? vec4(2.0) : wave(a.xy);
    color = a;
}
//// becomes
#version 330

uniform sampler2D u_map;
uniform float u_a;
in vec2 v_uv;
out vec4 color;

vec4 wave(vec2 p) {
    return sin(texture(u_map, p)) * exp(texture(u_map, p * 2.0));
}

float g;

float writes() {
    g = 1.0;
    return g;
}

void main() {
    vec4 choice;
    if (u_a > 0.0) {
        choice = wave(v_uv);
    } else {
        choice = vec4(1.0);
    }
    vec4 a = choice;
    vec4 choice_1;
    if (u_a > 1.0) {
        choice_1 = vec4(2.0);
    } else {
        choice_1 = wave(a.xy);
    }
    a *= choice_1;
    color = a;
}

//// Costly operands that may be skipped.
void main() {
    bool b = u_a > 0.0 && wave(v_uv).x > 0.5;
    if (b || wave(v_uv).y > 0.5)
        color = vec4(1.0);
    else
        color = vec4(0.0);
}
//// becomes
#version 330

uniform sampler2D u_map;
uniform float u_a;
in vec2 v_uv;
out vec4 color;

vec4 wave(vec2 p) {
    return sin(texture(u_map, p)) * exp(texture(u_map, p * 2.0));
}

float g;

float writes() {
    g = 1.0;
    return g;
}

void main() {
    bool choice = u_a > 0.0;
    if (choice) {
        choice = wave(v_uv).x > 0.5;
    }
    bool b = choice;
    bool choice_1 = b;
    if (!choice_1) {
        choice_1 = wave(v_uv).y > 0.5;
    }
    if (choice_1)
        color = vec4(1.0);
    else
        color = vec4(0.0);
}

//// Choices in choices.
void main() {
    color = u_a > 0.0 ? u_a > 1.0 ? wave(v_uv) : vec4(1.0) : wave(v_uv.yx);
    switch (u_a > 0.0 ? int(wave(v_uv).x) : 1) {
        case 1:
            color *= u_a > 2.0 ? wave(v_uv) : color;
    }
}
//// becomes
#version 330

uniform sampler2D u_map;
uniform float u_a;
in vec2 v_uv;
out vec4 color;

vec4 wave(vec2 p) {
    return sin(texture(u_map, p)) * exp(texture(u_map, p * 2.0));
}

float g;

float writes() {
    g = 1.0;
    return g;
}

void main() {
    vec4 choice;
    if (u_a > 0.0) {
        vec4 choice_1;
        if (u_a > 1.0) {
            choice_1 = wave(v_uv);
        } else {
            choice_1 = vec4(1.0);
        }
        choice = choice_1;
    } else {
        choice = wave(v_uv.yx);
    }
    color = choice;
    int choice_2;
    if (u_a > 0.0) {
        choice_2 = int(wave(v_uv).x);
    } else {
        choice_2 = 1;
    }
    switch (choice_2) {
        case 1:
            vec4 choice_3;
            if (u_a > 2.0) {
                choice_3 = wave(v_uv);
            } else {
                choice_3 = color;
            }
            color *= choice_3;
    }
}

//// What is cheap stays, and so do loops and what has a side effect.
void main() {
    float a = u_a > 0.0 ? 1.0 : 2.0;
    for (int i = 0; i < 2; i++)
        a += u_a > 0.0 ? wave(v_uv).x : 1.0;
    color = a > 0.0 ? wave(v_uv) * writes() : vec4(a);
}
//// becomes
#version 330

uniform sampler2D u_map;
uniform float u_a;
in vec2 v_uv;
out vec4 color;

vec4 wave(vec2 p) {
    return sin(texture(u_map, p)) * exp(texture(u_map, p * 2.0));
}

float g;

float writes() {
    g = 1.0;
    return g;
}

void main() {
    float a = u_a > 0.0 ? 1.0 : 2.0;
    for (int i = 0; i < 2; i++)
        a += u_a > 0.0 ? wave(v_uv).x : 1.0;
    color = a > 0.0 ? wave(v_uv) * writes() : vec4(a);
}
