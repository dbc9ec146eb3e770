#version 330
uniform float u_a;
in vec3 v_a;
out vec4 color;
float sc_payload;
float sc_payload_1;
float sc_payload_2;
bool sc_valid;
bool sc_valid_1;
bool sc_valid_2;
bool sc_reuse;
bool sc_lacks;

//// A variable stands for the expression.
//// use: outer(u_a) > inner(x + 1.0) > sin(x)
float inner(float x) {
    float y = x * 2.0;
    return y + sin(x);
}
float outer(float x) {
    return inner(x) + inner(x + 1.0);
}
void main() {
    color = vec4(outer(u_a));
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float sc_payload;
float sc_payload_1;
float sc_payload_2;
bool sc_valid;
bool sc_valid_1;
bool sc_valid_2;
bool sc_reuse;
bool sc_lacks;

float inner(float x) {
    float y = x * 2.0;
    return y + sin(x);
}

float sc_inner(float x) {
    float y = x * 2.0;
    return y + sc_payload;
}

float outer(float x) {
    return inner(x) + inner(x + 1.0);
}

float sc_outer(float x) {
    return inner(x) + sc_inner(x + 1.0);
}

void main() {
    color = vec4(outer(u_a));
}

void sc_main() {
    color = vec4(sc_outer(u_a));
}

//// The value goes to a variable first.
//// store: outer(u_a) > inner(x + 1.0) > sin(x)
float inner(float x) {
    float y = x * 2.0;
    return y + sin(x);
}
float outer(float x) {
    return inner(x) + inner(x + 1.0);
}
void main() {
    color = vec4(outer(u_a));
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float sc_payload;
float sc_payload_1;
float sc_payload_2;
bool sc_valid;
bool sc_valid_1;
bool sc_valid_2;
bool sc_reuse;
bool sc_lacks;

float inner(float x) {
    float y = x * 2.0;
    return y + sin(x);
}

float sc_inner(float x) {
    float y = x * 2.0;
    sc_payload = sin(x);
    return y + sc_payload;
}

float outer(float x) {
    return inner(x) + inner(x + 1.0);
}

float sc_outer(float x) {
    return inner(x) + sc_inner(x + 1.0);
}

void main() {
    color = vec4(outer(u_a));
}

void sc_main() {
    color = vec4(sc_outer(u_a));
}

//// Everything behind the goal is cut off.
//// goal: outer(u_a) > inner(x + 1.0) > sin(x)
float inner(float x) {
    float y = x * 2.0;
    return y + sin(x);
}
float outer(float x) {
    return inner(x) + inner(x + 1.0);
}
void main() {
    color = vec4(outer(u_a));
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float sc_payload;
float sc_payload_1;
float sc_payload_2;
bool sc_valid;
bool sc_valid_1;
bool sc_valid_2;
bool sc_reuse;
bool sc_lacks;

float inner(float x) {
    float y = x * 2.0;
    return y + sin(x);
}

void sc_inner(float x) {
    float y = x * 2.0;
    sc_payload = sin(x);
}

float outer(float x) {
    return inner(x) + inner(x + 1.0);
}

void sc_outer(float x) {
    sc_inner(x + 1.0);
}

void main() {
    color = vec4(outer(u_a));
}

void sc_main() {
    sc_outer(u_a);
}

//// That there is a value is noted.
//// keep: outer(u_a) > inner(x + 1.0) > sin(x)
float inner(float x) {
    float y = x * 2.0;
    return y + sin(x);
}
float outer(float x) {
    return inner(x) + inner(x + 1.0);
}
void main() {
    color = vec4(outer(u_a));
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float sc_payload;
float sc_payload_1;
float sc_payload_2;
bool sc_valid;
bool sc_valid_1;
bool sc_valid_2;
bool sc_reuse;
bool sc_lacks;

float inner(float x) {
    float y = x * 2.0;
    return y + sin(x);
}

float sc_inner(float x) {
    float y = x * 2.0;
    sc_payload = sin(x);
    sc_valid = true;
    return y + sc_payload;
}

float outer(float x) {
    return inner(x) + inner(x + 1.0);
}

float sc_outer(float x) {
    return inner(x) + sc_inner(x + 1.0);
}

void main() {
    color = vec4(outer(u_a));
}

void sc_main() {
    color = vec4(sc_outer(u_a));
}

//// A value from the cache is taken as it is.
//// fill: outer(u_a) > inner(x + 1.0) > sin(x)
float inner(float x) {
    float y = x * 2.0;
    return y + sin(x);
}
float outer(float x) {
    return inner(x) + inner(x + 1.0);
}
void main() {
    color = vec4(outer(u_a));
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float sc_payload;
float sc_payload_1;
float sc_payload_2;
bool sc_valid;
bool sc_valid_1;
bool sc_valid_2;
bool sc_reuse;
bool sc_lacks;

float inner(float x) {
    float y = x * 2.0;
    return y + sin(x);
}

float sc_inner(float x) {
    float y = x * 2.0;
    if (!sc_reuse) {
        sc_payload = sin(x);
    }
    sc_valid = true;
    return y + sc_payload;
}

float outer(float x) {
    return inner(x) + inner(x + 1.0);
}

float sc_outer(float x) {
    return inner(x) + sc_inner(x + 1.0);
}

void main() {
    color = vec4(outer(u_a));
}

void sc_main() {
    color = vec4(sc_outer(u_a));
}

//// A fragment without a value is discarded.
//// need: outer(u_a) > inner(x + 1.0) > sin(x)
float inner(float x) {
    float y = x * 2.0;
    return y + sin(x);
}
float outer(float x) {
    return inner(x) + inner(x + 1.0);
}
void main() {
    color = vec4(outer(u_a));
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float sc_payload;
float sc_payload_1;
float sc_payload_2;
bool sc_valid;
bool sc_valid_1;
bool sc_valid_2;
bool sc_reuse;
bool sc_lacks;

float inner(float x) {
    float y = x * 2.0;
    return y + sin(x);
}

float sc_inner(float x) {
    float y = x * 2.0;
    if (!sc_reuse) {
        discard;
    }
    return y + sc_payload;
}

float outer(float x) {
    return inner(x) + inner(x + 1.0);
}

float sc_outer(float x) {
    return inner(x) + sc_inner(x + 1.0);
}

void main() {
    color = vec4(outer(u_a));
}

void sc_main() {
    color = vec4(sc_outer(u_a));
}

//// A fragment without a value is noted.
//// lack: outer(u_a) > inner(x + 1.0) > sin(x)
float inner(float x) {
    float y = x * 2.0;
    return y + sin(x);
}
float outer(float x) {
    return inner(x) + inner(x + 1.0);
}
void main() {
    color = vec4(outer(u_a));
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float sc_payload;
float sc_payload_1;
float sc_payload_2;
bool sc_valid;
bool sc_valid_1;
bool sc_valid_2;
bool sc_reuse;
bool sc_lacks;

float inner(float x) {
    float y = x * 2.0;
    return y + sin(x);
}

float sc_inner(float x) {
    float y = x * 2.0;
    if (!sc_reuse) {
        sc_lacks = true;
    }
    return y + sc_payload;
}

float outer(float x) {
    return inner(x) + inner(x + 1.0);
}

float sc_outer(float x) {
    return inner(x) + sc_inner(x + 1.0);
}

void main() {
    color = vec4(outer(u_a));
}

void sc_main() {
    color = vec4(sc_outer(u_a));
}

//// What follows the last goal is cut off.
//// goal: u_a * 2.0
//// goal: g(c) > x * 4.0
float f(float x) {
    float a = x * 3.0;
    return a + 1.0;
}
float g(float x) {
    float b = x * 4.0;
    return b - 1.0;
}
void main() {
    float c = u_a * 2.0;
    c += f(c) + g(c);
    color = vec4(c * 5.0, g(f(c + 7.0)), c, 1.0);
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float sc_payload;
float sc_payload_1;
float sc_payload_2;
bool sc_valid;
bool sc_valid_1;
bool sc_valid_2;
bool sc_reuse;
bool sc_lacks;

float f(float x) {
    float a = x * 3.0;
    return a + 1.0;
}

float g(float x) {
    float b = x * 4.0;
    return b - 1.0;
}

void sc_g(float x) {
    sc_payload_2 = x * 4.0;
}

void main() {
    float c = u_a * 2.0;
    c += f(c) + g(c);
    color = vec4(c * 5.0, g(f(c + 7.0)), c, 1.0);
}

void sc_main() {
    sc_payload_1 = u_a * 2.0;
    float c = sc_payload_1;
    sc_g(c);
}

//// Calls to the last goals stand alone.
//// goal: f(c) > x * 3.0
//// goal: g(c) > x * 4.0
float f(float x) {
    float a = x * 3.0;
    return a + 1.0;
}
float g(float x) {
    float b = x * 4.0;
    return b - 1.0;
}
void main() {
    float c = u_a * 2.0;
    c += f(c) + g(c);
    color = vec4(c * 5.0, g(f(c + 7.0)), c, 1.0);
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float sc_payload;
float sc_payload_1;
float sc_payload_2;
bool sc_valid;
bool sc_valid_1;
bool sc_valid_2;
bool sc_reuse;
bool sc_lacks;

float f(float x) {
    float a = x * 3.0;
    return a + 1.0;
}

void sc_f(float x) {
    sc_payload_1 = x * 3.0;
}

float g(float x) {
    float b = x * 4.0;
    return b - 1.0;
}

void sc_g(float x) {
    sc_payload_2 = x * 4.0;
}

void main() {
    float c = u_a * 2.0;
    c += f(c) + g(c);
    color = vec4(c * 5.0, g(f(c + 7.0)), c, 1.0);
}

void sc_main() {
    float c = u_a * 2.0;
    sc_f(c);
    sc_g(c);
}

//// What comes later needs the value of a call.
//// goal: g(c) > x * 4.0
//// goal: c * 5.0
float f(float x) {
    float a = x * 3.0;
    return a + 1.0;
}
float g(float x) {
    float b = x * 4.0;
    return b - 1.0;
}
void main() {
    float c = u_a * 2.0;
    c += f(c) + g(c);
    color = vec4(c * 5.0, g(f(c + 7.0)), c, 1.0);
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float sc_payload;
float sc_payload_1;
float sc_payload_2;
bool sc_valid;
bool sc_valid_1;
bool sc_valid_2;
bool sc_reuse;
bool sc_lacks;

float f(float x) {
    float a = x * 3.0;
    return a + 1.0;
}

float g(float x) {
    float b = x * 4.0;
    return b - 1.0;
}

float sc_g(float x) {
    sc_payload_1 = x * 4.0;
    float b = sc_payload_1;
    return b - 1.0;
}

void main() {
    float c = u_a * 2.0;
    c += f(c) + g(c);
    color = vec4(c * 5.0, g(f(c + 7.0)), c, 1.0);
}

void sc_main() {
    float c = u_a * 2.0;
    c += f(c) + sc_g(c);
    sc_payload_2 = c * 5.0;
}

//// A goal in an argument comes first.
//// goal: g(f(c + 7.0)) > x * 4.0
//// goal: c + 7.0
float f(float x) {
    float a = x * 3.0;
    return a + 1.0;
}
float g(float x) {
    float b = x * 4.0;
    return b - 1.0;
}
void main() {
    float c = u_a * 2.0;
    color = vec4(c * 5.0, g(f(c + 7.0)), c, 1.0);
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float sc_payload;
float sc_payload_1;
float sc_payload_2;
bool sc_valid;
bool sc_valid_1;
bool sc_valid_2;
bool sc_reuse;
bool sc_lacks;

float f(float x) {
    float a = x * 3.0;
    return a + 1.0;
}

float g(float x) {
    float b = x * 4.0;
    return b - 1.0;
}

void sc_g(float x) {
    sc_payload_1 = x * 4.0;
}

void main() {
    float c = u_a * 2.0;
    color = vec4(c * 5.0, g(f(c + 7.0)), c, 1.0);
}

void sc_main() {
    float c = u_a * 2.0;
    sc_payload_2 = c + 7.0;
    sc_g(f(sc_payload_2));
}

//// A goal in an argument needs the value of the other call.
//// goal: g(f(c + 7.0)) > x * 4.0
//// goal: f(c + 7.0) > x * 3.0
float f(float x) {
    float a = x * 3.0;
    return a + 1.0;
}
float g(float x) {
    float b = x * 4.0;
    return b - 1.0;
}
void main() {
    float c = u_a * 2.0;
    color = vec4(c * 5.0, g(f(c + 7.0)), c, 1.0);
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float sc_payload;
float sc_payload_1;
float sc_payload_2;
bool sc_valid;
bool sc_valid_1;
bool sc_valid_2;
bool sc_reuse;
bool sc_lacks;

float f(float x) {
    float a = x * 3.0;
    return a + 1.0;
}

float sc_f(float x) {
    sc_payload_2 = x * 3.0;
    float a = sc_payload_2;
    return a + 1.0;
}

float g(float x) {
    float b = x * 4.0;
    return b - 1.0;
}

void sc_g(float x) {
    sc_payload_1 = x * 4.0;
}

void main() {
    float c = u_a * 2.0;
    color = vec4(c * 5.0, g(f(c + 7.0)), c, 1.0);
}

void sc_main() {
    float c = u_a * 2.0;
    sc_g(sc_f(c + 7.0));
}

//// What is stored under conditions.
//// keep: sin(u_a)
//// keep: cos(u_a)
void main() {
    float a = 1.0;
    if (u_a > 0.0)
        a = sin(u_a);
    else
        a = 2.0;
    switch (int(u_a)) {
        case 1:
            a += cos(u_a);
            break;
    }
    color = vec4(a);
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float sc_payload;
float sc_payload_1;
float sc_payload_2;
bool sc_valid;
bool sc_valid_1;
bool sc_valid_2;
bool sc_reuse;
bool sc_lacks;

void main() {
    float a = 1.0;
    if (u_a > 0.0)
        a = sin(u_a);
    else
        a = 2.0;
    switch (int(u_a)) {
        case 1:
            a += cos(u_a);
            break;
    }
    color = vec4(a);
}

void sc_main() {
    float a = 1.0;
    if (u_a > 0.0) {
        sc_payload_1 = sin(u_a);
        sc_valid_1 = true;
        a = sc_payload_1;
    } else {
        a = 2.0;
    }
    switch (int(u_a)) {
        case 1:
            sc_payload_2 = cos(u_a);
            sc_valid_2 = true;
            a += sc_payload_2;
            break;
    }
    color = vec4(a);
}

//// The last goal stands in a block.
//// goal: sin(u_a)
void main() {
    float a = 1.0;
    {
        float b = sin(u_a);
        a += b;
    }
    {
        a *= 2.0;
    }
    for (int i = 0; i < 2; i++)
        a += 1.0;
    color = vec4(a);
}
//// becomes
#version 330

uniform float u_a;
in vec3 v_a;
out vec4 color;
float sc_payload;
float sc_payload_1;
float sc_payload_2;
bool sc_valid;
bool sc_valid_1;
bool sc_valid_2;
bool sc_reuse;
bool sc_lacks;

void main() {
    float a = 1.0;
    {
        float b = sin(u_a);
        a += b;
    }
    {
        a *= 2.0;
    }
    for (int i = 0; i < 2; i++)
        a += 1.0;
    color = vec4(a);
}

void sc_main() {
    float a = 1.0;
    {
        sc_payload = sin(u_a);
    }
}
