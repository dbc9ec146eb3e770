#version 420
uniform float u_a;
uniform float u_b;
in vec3 v_a;
in vec3 v_b;
out vec4 color;
out vec4 store;

//// What no output needs goes.
void main() {
    float a = u_a;
    color = vec4(u_b);
}
//// becomes
#version 420

uniform float u_b;
out vec4 color;

void main() {
    color = vec4(u_b);
}

//// What an output needs stays.
void main() {
    float a = u_a;
    color = vec4(a);
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;

void main() {
    float a = u_a;
    color = vec4(a);
}

//// An overwritten value is dead.
void main() {
    vec4 a = vec4(u_a);
    a = vec4(u_b);
    color = a;
}
//// becomes
#version 420

uniform float u_b;
out vec4 color;

void main() {
    vec4 a;
    a = vec4(u_b);
    color = a;
}

//// A partly overwritten value is not.
void main() {
    vec4 a = vec4(u_a);
    a.x = u_b;
    color = a;
}
//// becomes
#version 420

uniform float u_a;
uniform float u_b;
out vec4 color;

void main() {
    vec4 a = vec4(u_a);
    a.x = u_b;
    color = a;
}

//// An overwritten output is dead.
void main() {
    color = vec4(u_a);
    color = vec4(u_b);
}
//// becomes
#version 420

uniform float u_b;
out vec4 color;

void main() {
    color = vec4(u_b);
}

//// A partly overwritten output is not.
void main() {
    color = vec4(u_a);
    color.x = u_b;
}
//// becomes
#version 420

uniform float u_a;
uniform float u_b;
out vec4 color;

void main() {
    color = vec4(u_a);
    color.x = u_b;
}

//// What is added to is read.
void main() {
    color = vec4(u_a);
    color += vec4(u_b);
}
//// becomes
#version 420

uniform float u_a;
uniform float u_b;
out vec4 color;

void main() {
    color = vec4(u_a);
    color += vec4(u_b);
}

//// What is written under a condition may survive it.
void main() {
    float a = u_a;
    if (u_b > 0.0)
        a = 1.0;
    color = vec4(a);
}
//// becomes
#version 420

uniform float u_a;
uniform float u_b;
out vec4 color;

void main() {
    float a = u_a;
    if (u_b > 0.0)
        a = 1.0;
    color = vec4(a);
}

//// A condition under which nothing is left goes.
void main() {
    float a = u_a;
    if (u_b > 0.0)
        a = 1.0;
    color = vec4(u_a);
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;

void main() {
    color = vec4(u_a);
}

//// Of a conditional only the else branch is left.
void main() {
    if (u_b > 0.0) {
        float a = u_a;
    } else {
        color = vec4(u_a);
    }
    color.x = 1.0;
}
//// becomes
#version 420

uniform float u_a;
uniform float u_b;
out vec4 color;

void main() {
    if (!(u_b > 0.0)) {
        color = vec4(u_a);
    }
    color.x = 1.0;
}

//// A return decides what comes after it.
void main() {
    color = vec4(0.0);
    float a = u_a;
    if (a > 0.0)
        return;
    color = vec4(u_b);
}
//// becomes
#version 420

uniform float u_a;
uniform float u_b;
out vec4 color;

void main() {
    color = vec4(0.0);
    float a = u_a;
    if (a > 0.0)
        return;
    color = vec4(u_b);
}

//// A loop from which nothing comes goes.
void main() {
    float a = 0.0;
    for (int i = 0; i < 3; i++) {
        float b = u_b;
    }
    color = vec4(a);
}
//// becomes
#version 420

out vec4 color;

void main() {
    float a = 0.0;
    color = vec4(a);
}

//// The header of a loop stays, for it counts.
void main() {
    int i = 0;
    for (; i < 3; i++) {
        float b = u_b;
    }
    color = vec4(i);
}
//// becomes
#version 420

out vec4 color;

void main() {
    int i = 0;
    for (; i < 3; i++) {
    }
    color = vec4(i);
}

//// An unused loop goes.
void main() {
    float s = 0.0;
    for (int i = 0; i < 3; i++) {
        s += u_a;
    }
    color = vec4(u_b);
}
//// becomes
#version 420

uniform float u_b;
out vec4 color;

void main() {
    color = vec4(u_b);
}

//// Of a loop what is carried on is left.
void main() {
    float s = 0.0;
    float t = 0.0;
    for (int i = 0; i < 3; i++) {
        t += u_b;
        s += u_a;
    }
    color = vec4(s);
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;

void main() {
    float s = 0.0;
    for (int i = 0; i < 3; i++) {
        s += u_a;
    }
    color = vec4(s);
}

//// A value that goes round in a loop is live.
void main() {
    float a = 0.0;
    float b = u_b;
    while (a < 3.0) {
        a = a + b;
        b = u_a;
    }
    color = vec4(a);
}
//// becomes
#version 420

uniform float u_a;
uniform float u_b;
out vec4 color;

void main() {
    float a = 0.0;
    float b = u_b;
    while (a < 3.0) {
        a = a + b;
        b = u_a;
    }
    color = vec4(a);
}

//// A value that goes round is live behind a break, too.
void main() {
    float a = 0.0;
    float b = u_b;
    for (;;) {
        if (b > 3.0)
            break;
        a = b;
        b += u_a;
    }
    color = vec4(a);
}
//// becomes
#version 420

uniform float u_a;
uniform float u_b;
out vec4 color;

void main() {
    float a = 0.0;
    float b = u_b;
    for (;;) {
        if (b > 3.0)
            break;
        a = b;
        b += u_a;
    }
    color = vec4(a);
}

//// A discard is never removed, nor what decides it.
void main() {
    float a = u_a;
    if (a > 0.0)
        discard;
    color = vec4(u_b);
}
//// becomes
#version 420

uniform float u_a;
uniform float u_b;
out vec4 color;

void main() {
    float a = u_a;
    if (a > 0.0)
        discard;
    color = vec4(u_b);
}

//// A switch goes where nothing of it is left.
void main() {
    float a = 0.0;
    switch (1) {
        case 1:
            a = u_a;
    }
    color = vec4(u_b);
}
//// becomes
#version 420

uniform float u_b;
out vec4 color;

void main() {
    color = vec4(u_b);
}

//// Cases that end and that fall through.
void main() {
    float a = u_a;
    switch (1) {
        case 1:
            a = u_b;
            break;
        default:
            a += 1.0;
    }
    color = vec4(a);
}
//// becomes
#version 420

uniform float u_a;
uniform float u_b;
out vec4 color;

void main() {
    float a = u_a;
    switch (1) {
        case 1:
            a = u_b;
            break;
        default:
            a += 1.0;
    }
    color = vec4(a);
}

//// An array of which an element is written in a loop stays.
void main() {
    float a[3];
    for (int i = 0; i < 3; i++)
        a[i] = u_a;
    color = vec4(a[1]);
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;

void main() {
    float a[3];
    for (int i = 0; i < 3; i++)
        a[i] = u_a;
    color = vec4(a[1]);
}

//// Calls stay for what they write.
float g;
float dead;
void set(float x) {
    g = x;
}
void ignore(float x) {
    dead = x;
}
void give(float x, out float y) {
    y = x;
}
void main() {
    set(u_a);
    ignore(u_b);
    float a;
    give(u_a, a);
    float b;
    give(u_b, b);
    color = vec4(g + a);
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;
float g;

void set(float x) {
    g = x;
}

void give(float x, out float y) {
    y = x;
}

void main() {
    set(u_a);
    float a;
    give(u_a, a);
    color = vec4(g + a);
}

//// Of a product only the call is left.
float g;
float h;
float set(float x) {
    g = x;
    return x * 2.0;
}
float count(float x) {
    h += 1.0;
    return x;
}
float last(float x) {
    h = x;
    return x;
}
void main() {
    float a = 2.0 * set(u_a) + u_b;
    color = vec4(g);
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;
float g;

float set(float x) {
    g = x;
    return x * 2.0;
}

void main() {
    set(u_a);
    color = vec4(g);
}

//// Of a dead target only the call is left.
float g;
float h;
float set(float x) {
    g = x;
    return x * 2.0;
}
float count(float x) {
    h += 1.0;
    return x;
}
float last(float x) {
    h = x;
    return x;
}
void main() {
    float a;
    a = -set(u_a);
    a *= u_b;
    color = vec4(g);
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;
float g;

float set(float x) {
    g = x;
    return x * 2.0;
}

void main() {
    set(u_a);
    color = vec4(g);
}

//// Of a constructor only the call is left that matters.
float g;
float h;
float set(float x) {
    g = x;
    return x * 2.0;
}
float count(float x) {
    h += 1.0;
    return x;
}
float last(float x) {
    h = x;
    return x;
}
void main() {
    vec2 a;
    a.x = vec2(count(u_a), set(u_b)).y;
    color = vec4(g);
}
//// becomes
#version 420

uniform float u_b;
out vec4 color;
float g;

float set(float x) {
    g = x;
    return x * 2.0;
}

void main() {
    set(u_b);
    color = vec4(g);
}

//// Of a condition only the call is left.
float g;
float h;
float set(float x) {
    g = x;
    return x * 2.0;
}
float count(float x) {
    h += 1.0;
    return x;
}
float last(float x) {
    h = x;
    return x;
}
void main() {
    if (set(u_a) > u_b)
        h = 1.0;
    color = vec4(g);
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;
float g;

float set(float x) {
    g = x;
    return x * 2.0;
}

void main() {
    set(u_a);
    color = vec4(g);
}

//// Whether it is called at all depends on the left side.
float g;
float h;
float set(float x) {
    g = x;
    return x * 2.0;
}
float count(float x) {
    h += 1.0;
    return x;
}
float last(float x) {
    h = x;
    return x;
}
void main() {
    bool a = u_a > 0.0 && set(u_a) > u_b;
    color = vec4(g);
}
//// becomes
#version 420

uniform float u_a;
uniform float u_b;
out vec4 color;
float g;

float set(float x) {
    g = x;
    return x * 2.0;
}

void main() {
    u_a > 0.0 && set(u_a) > u_b;
    color = vec4(g);
}

//// A counter that only counts itself is dead.
float g;
float h;
float set(float x) {
    g = x;
    return x * 2.0;
}
float count(float x) {
    h += 1.0;
    return x;
}
float last(float x) {
    h = x;
    return x;
}
void main() {
    count(u_a);
    color = vec4(u_b);
}
//// becomes
#version 420

uniform float u_b;
out vec4 color;

void main() {
    color = vec4(u_b);
}

//// What is written behind the last reader is dead.
float g;
float h;
float set(float x) {
    g = x;
    return x * 2.0;
}
float count(float x) {
    h += 1.0;
    return x;
}
float last(float x) {
    h = x;
    return x;
}
void main() {
    color = vec4(h);
    last(u_a);
}
//// becomes
#version 420

out vec4 color;
float h;

void main() {
    color = vec4(h);
}

//// What is written before the last reader is not.
float g;
float h;
float set(float x) {
    g = x;
    return x * 2.0;
}
float count(float x) {
    h += 1.0;
    return x;
}
float last(float x) {
    h = x;
    return x;
}
void main() {
    last(u_a);
    color = vec4(h);
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;
float h;

float last(float x) {
    h = x;
    return x;
}

void main() {
    last(u_a);
    color = vec4(h);
}

//// The next round of a loop reads it.
float g;
float h;
float set(float x) {
    g = x;
    return x * 2.0;
}
float count(float x) {
    h += 1.0;
    return x;
}
float last(float x) {
    h = x;
    return x;
}
void main() {
    for (int i = 0; i < 3; i++) {
        color = vec4(h);
        last(u_a);
    }
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;
float h;

float last(float x) {
    h = x;
    return x;
}

void main() {
    for (int i = 0; i < 3; i++) {
        color = vec4(h);
        last(u_a);
    }
}

//// Another part of the statement may be evaluated after the call.
float g;
float h;
float set(float x) {
    g = x;
    return x * 2.0;
}
float count(float x) {
    h += 1.0;
    return x;
}
float last(float x) {
    h = x;
    return x;
}
void main() {
    color = vec4(last(u_a) + h);
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;
float h;

float last(float x) {
    h = x;
    return x;
}

void main() {
    color = vec4(last(u_a) + h);
}

//// Another part of the statement may be evaluated before the call.
float g;
float h;
float set(float x) {
    g = x;
    return x * 2.0;
}
float count(float x) {
    h += 1.0;
    return x;
}
float last(float x) {
    h = x;
    return x;
}
void main() {
    color = vec4(h + last(u_a));
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;
float h;

float last(float x) {
    h = x;
    return x;
}

void main() {
    color = vec4(h + last(u_a));
}

//// A call in the argument of a call.
float g;
float h;
float set(float x) {
    g = x;
    return x * 2.0;
}
float count(float x) {
    h += 1.0;
    return x;
}
float last(float x) {
    h = x;
    return x;
}
void main() {
    float a = last(last(u_a) + h);
    color = vec4(a);
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;
float h;

float last(float x) {
    h = x;
    return x;
}

void main() {
    float a = last(last(u_a) + h);
    color = vec4(a);
}

//// A switch is pruned inside, and its last label needs a statement.
void main() {
    float a = 0.0;
    float d = 0.0;
    switch (1) {
        case 1:
            a = u_a;
            d = u_b;
            break;
        case 2:
            d += 1.0;
        default:
            d += 2.0;
    }
    color = vec4(a);
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;

void main() {
    float a = 0.0;
    switch (1) {
        case 1:
            a = u_a;
            break;
        case 2:
        default:
            break;
    }
    color = vec4(a);
}

//// A group falls through to the next, so what that reads is wanted.
void main() {
    float a = 0.0;
    float d;
    switch (1) {
        case 1:
            d = u_b;
        case 2:
            a = d;
            break;
    }
    color = vec4(a);
}
//// becomes
#version 420

uniform float u_b;
out vec4 color;

void main() {
    float a = 0.0;
    float d;
    switch (1) {
        case 1:
            d = u_b;
        case 2:
            a = d;
            break;
    }
    color = vec4(a);
}

//// A discard inside a switch stays.
void main() {
    float a;
    switch (1) {
        case 1:
            if (u_a > 0.0)
                discard;
    }
    color = vec4(u_b);
}
//// becomes
#version 420

uniform float u_a;
uniform float u_b;
out vec4 color;

void main() {
    switch (1) {
        case 1:
            if (u_a > 0.0)
                discard;
    }
    color = vec4(u_b);
}

//// A return behind which nothing comes goes.
void main() {
    color = vec4(u_a);
    if (u_b > 0.0) {
        store = color;
        return;
    }
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;

void main() {
    color = vec4(u_a);
}

//// Two returns behind which nothing comes go.
void main() {
    color = vec4(u_a);
    if (u_b > 0.0)
        return;
    else {
        if (u_a > 0.0) {
            return;
        }
    }
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;

void main() {
    color = vec4(u_a);
}

//// A return at the beginning stays.
void main() {
    if (u_b > 0.0)
        return;
    color = vec4(u_a);
}
//// becomes
#version 420

uniform float u_a;
uniform float u_b;
out vec4 color;

void main() {
    if (u_b > 0.0)
        return;
    color = vec4(u_a);
}

//// A return behind an output stays.
void main() {
    if (u_b > 0.0) {
        color = vec4(u_b);
        return;
    }
    color = vec4(u_a);
}
//// becomes
#version 420

uniform float u_a;
uniform float u_b;
out vec4 color;

void main() {
    if (u_b > 0.0) {
        color = vec4(u_b);
        return;
    }
    color = vec4(u_a);
}

//// A return in a loop stays.
void main() {
    for (;;) {
        if (u_b > 0.0) {
            color = vec4(u_a);
            return;
        }
    }
}
//// becomes
#version 420

uniform float u_a;
uniform float u_b;
out vec4 color;

void main() {
    for (;;) {
        if (u_b > 0.0) {
            color = vec4(u_a);
            return;
        }
    }
}

//// Only the wanted outputs are left.
//// wanted: store
void main() {
    color = vec4(v_a, u_a);
    store = vec4(v_b, u_b);
}
//// becomes
#version 420

uniform float u_b;
in vec3 v_b;
out vec4 store;

void main() {
    store = vec4(v_b, u_b);
}

//// An output that is read becomes a variable.
//// wanted: store
void main() {
    color = vec4(u_a);
    store = color;
}
//// becomes
#version 420

uniform float u_a;
vec4 color;
out vec4 store;

void main() {
    color = vec4(u_a);
    store = color;
}

//// Functions, structs and constants stay while they are used.
struct Used {
    float x;
};
struct Unused {
    float x;
};
const int N = 2;
const int M = 3;
float helper(Used u[N]) {
    return u[1].x;
}
float unused() {
    return 1.0;
}
void main() {
    Used u[N];
    u[0].x = u_a;
    u[1].x = u_a;
    color = vec4(helper(u));
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;

struct Used {
    float x;
};

const int N = 2;

float helper(Used u[N]) {
    return u[1].x;
}

void main() {
    Used u[N];
    u[0].x = u_a;
    u[1].x = u_a;
    color = vec4(helper(u));
}

//// A uniform block is kept whole.
layout(std140) uniform Block {
    float x;
    float y;
};
void main() {
    color = vec4(x);
}
//// becomes
#version 420

out vec4 color;

layout(std140) uniform Block {
    float x;
    float y;
};

void main() {
    color = vec4(x);
}

//// A uniform block goes as a whole.
layout(std140) uniform Block {
    float x;
    float y;
};
void main() {
    color = vec4(u_a);
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;

void main() {
    color = vec4(u_a);
}

//// What a function leaves in its out parameters is needed.
void scale(inout vec2 v) {
    v = v.yx * u_a;
}
void split(float x, out float y, out float z) {
    y = x;
    z = x * u_b;
}
void main() {
    vec2 v = v_a.xy;
    scale(v);
    float y;
    float z;
    split(v.x, y, z);
    color = vec4(v, y, z);
}
//// becomes
#version 420

uniform float u_a;
uniform float u_b;
in vec3 v_a;
out vec4 color;

void scale(inout vec2 v) {
    v = v.yx * u_a;
}

void split(float x, out float y, out float z) {
    y = x;
    z = x * u_b;
}

void main() {
    vec2 v = v_a.xy;
    scale(v);
    float y;
    float z;
    split(v.x, y, z);
    color = vec4(v, y, z);
}

//// A continue inside a switch leads to the next round.
void main() {
    float x = u_a;
    float s = 0.0;
    for (int i = 0; i < 3; i++) {
        x = u_b;
        switch (i) {
            case 1:
                continue;
        }
        s += 1.0;
        x = 2.0;
    }
    color = vec4(x + s);
}
//// becomes
#version 420

uniform float u_a;
uniform float u_b;
out vec4 color;

void main() {
    float x = u_a;
    float s = 0.0;
    for (int i = 0; i < 3; i++) {
        x = u_b;
        switch (i) {
            case 1:
                continue;
        }
        s += 1.0;
        x = 2.0;
    }
    color = vec4(x + s);
}

//// Of a call for nothing the arguments are left that do something.
float g;
float f(float x) {
    g += x;
    return x;
}
float pure(float x, float y) {
    return x * y;
}
void give(out float x, float y) {
    x = y;
}
void main() {
    pure(u_a, max(f(u_b), 0.0));
    float a;
    give(a, f(2.0));
    float b;
    give(b, f(3.0));
    f(4.0) > 0.0 ? u_a : u_b;
    f(5.0) > 0.0 && f(6.0) > 0.0;
    color = vec4(g + b);
}
//// becomes
#version 420

uniform float u_b;
out vec4 color;
float g;

float f(float x) {
    g += x;
    return x;
}

void give(out float x, float y) {
    x = y;
}

void main() {
    f(u_b);
    f(2.0);
    float b;
    give(b, f(3.0));
    f(4.0);
    f(5.0) > 0.0 && f(6.0) > 0.0;
    color = vec4(g + b);
}

//// A constant that nobody reads may have a value with a side effect (GLSL 4.20 section 4.3.3).
float g;
float f(float x) {
    g = x;
    return 1.0;
}
void main() {
    const float a = f(u_a);
    const float b = 2.0;
    const float c = 3.0;
    color = vec4(g + c);
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;
float g;

float f(float x) {
    g = x;
    return 1.0;
}

void main() {
    f(u_a);
    const float c = 3.0;
    color = vec4(g + c);
}

//// Behind a comma its left side is read.
//// wanted: color
void main() {
    float a, b;
    a = u_a, b = u_b, color = vec4(a);
}
//// becomes
#version 420

uniform float u_a;
out vec4 color;

void main() {
    float a, b;
    {
        a = u_a;
        color = vec4(a);
    }
}

//// In a value that nobody wants, too.
//// wanted: color
float g;
float bump(float x) {
    color = vec4(g);
    return x;
}
void main() {
    float dead = (g = u_a, bump(u_b));
}
//// becomes
#version 420

uniform float u_a;
uniform float u_b;
out vec4 color;
float g;

float bump(float x) {
    color = vec4(g);
    return x;
}

void main() {
    {
        g = u_a;
        bump(u_b);
    }
}
