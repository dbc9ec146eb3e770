#version 120
uniform float u_a;
varying vec2 v_uv;

//// Every loop, of any kind, ends for a fragment that was discarded, wherever that was.
float sc_discarded = 1.0;
void hide() { if (v_uv.x < 0.1) discard; }
void main() {
    float t = sc_discarded;
    hide();
    if (t > u_a) { t += 1.0; discard; }
    for (int i = 0; i < 3; i++)
        t += 0.5;
    while (t < 4.0) {
        t += 0.5;
        if (t < v_uv.x) continue;
        do t += v_uv.y; while (t < 2.0);
    }
    gl_FragColor = vec4(t);
}
//// becomes
#version 120

uniform float u_a;
varying vec2 v_uv;
float sc_discarded = 1.0;
bool sc_discarded_1 = false;

void hide() {
    if (v_uv.x < 0.1) {
        sc_discarded_1 = true;
        discard;
    }
}

void main() {
    float t = sc_discarded;
    hide();
    if (t > u_a) {
        t += 1.0;
        sc_discarded_1 = true;
        discard;
    }
    for (int i = 0; i < 3; i++) {
        t += 0.5;
        if (sc_discarded_1)
            break;
    }
    while (t < 4.0) {
        t += 0.5;
        if (t < v_uv.x) {
            if (sc_discarded_1)
                break;
            continue;
        }
        do {
            t += v_uv.y;
            if (sc_discarded_1)
                break;
        } while (t < 2.0);
        if (sc_discarded_1)
            break;
    }
    gl_FragColor = vec4(t);
}

//// Nothing is to leave where nothing is discarded.
void main() {
    float t = 0.0;
    for (int i = 0; i < 3; i++) t += u_a;
    gl_FragColor = vec4(t);
}
//// becomes
#version 120

uniform float u_a;
varying vec2 v_uv;

void main() {
    float t = 0.0;
    for (int i = 0; i < 3; i++)
        t += u_a;
    gl_FragColor = vec4(t);
}

//// Nor where there is no loop.
void main() {
    if (v_uv.x < u_a) discard;
    gl_FragColor = vec4(1.0);
}
//// becomes
#version 120

uniform float u_a;
varying vec2 v_uv;

void main() {
    if (v_uv.x < u_a)
        discard;
    gl_FragColor = vec4(1.0);
}
