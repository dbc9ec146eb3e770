#version 330
uniform float u_a;
in vec2 v_uv;
out vec4 color;

//// A loop that continue goes on with becomes another, one inside it too; the rest stay.
void main() {
    float t = 0.0;
    do {
        t += 0.25;
        if (t < v_uv.x) continue;
        do {
            t += v_uv.y;
            switch (int(t)) {
            case 0: continue;
            }
        } while (t < 1.0);
    } while (t < u_a && v_uv.y > 0.5);
    do {
        t += 0.5;
        if (t > v_uv.y) break;
    } while (t < 4.0);
    do {
        for (int i = 0; i < 2; i++) {
            if (v_uv.x > t) continue;
            t += 0.1;
        }
    } while (t < 5.0);
    color = vec4(t);
}
//// becomes
#version 330

uniform float u_a;
in vec2 v_uv;
out vec4 color;

void main() {
    float t = 0.0;
    for (bool sc_again_1 = true; sc_again_1; sc_again_1 = t < u_a && v_uv.y > 0.5) {
        t += 0.25;
        if (t < v_uv.x)
            continue;
        for (bool sc_again = true; sc_again; sc_again = t < 1.0) {
            t += v_uv.y;
            switch (int(t)) {
                case 0:
                    continue;
            }
        }
    }
    do {
        t += 0.5;
        if (t > v_uv.y)
            break;
    } while (t < 4.0);
    do {
        for (int i = 0; i < 2; i++) {
            if (v_uv.x > t)
                continue;
            t += 0.1;
        }
    } while (t < 5.0);
    color = vec4(t);
}
