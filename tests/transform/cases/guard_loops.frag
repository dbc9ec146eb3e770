#version 330
uniform float u_a;
bool sc_lacks;
out vec4 color;

//// Every sort of loop.
void main() {
    float a = u_a;
    for (int i = 0; i < 3; i++)
        a += 1.0;
    while (a < 2.0) {
        a += u_a;
    }
    do
        a *= 2.0;
    while (a < 9.0);
    color = vec4(a);
}
//// becomes
#version 330

uniform float u_a;
bool sc_lacks;
out vec4 color;

void main() {
    float a = u_a;
    for (int i = 0; i < 3; i++) {
        if (sc_lacks) {
            break;
        }
        a += 1.0;
    }
    while (a < 2.0) {
        if (sc_lacks) {
            break;
        }
        a += u_a;
    }
    do {
        if (sc_lacks) {
            break;
        }
        a *= 2.0;
    } while (a < 9.0);
    color = vec4(a);
}
