#version 330
// Early returns at every depth of nested calls, behind writes to out arguments.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}

bool inner(vec3 p, out float h) {
    h = wave(p);
    if (h > 0.8)
        return true;
    h -= wave(p.zxy) * 0.5;
    if (h < -0.6)
        return false;
    h *= 0.5;
    return h > 0.0;
}

float middle(vec3 p, inout vec3 q) {
    float h;
    if (inner(p, h)) {
        q += h;
        return wave(q) * h;
    }
    q.x -= 0.3;
    if (!inner(q, h))
        return h;
    return h * wave(q - h);
}

float outer(vec3 p) {
    vec3 q = p;
    float a = middle(p, q);
    if (a > 0.9)
        return a;
    float b = middle(q, q);
    {
        if (b < -0.9) {
            return wave(q);
        }
    }
    return a + b * wave(q);
}

void main() {
    float x = outer(v_position);
    vec3 q = v_normal;
    float y = middle(v_normal, q);
    if (y > 1.1) {
        o_color = vec4(x, y, wave(q), 1.0);
        return;
    }
    o_color = vec4(x * 0.2, y * 0.3, wave(q + x), 1.0);
}
