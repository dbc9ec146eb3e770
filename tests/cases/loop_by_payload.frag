#version 330 core
// How long loops run hangs on values that are worth caching, and on what a miss finds in the cache
// instead they would run for ever.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform float u_time;
out vec4 color;

float wave(vec3 p) {
    return sin(p.x * 5.0) * cos(p.y * 3.0) + sin(p.z * 7.0 + sin(p.x) * 2.0 + cos(p.y * 1.5));
}

float march(float pace) {
    float sum = 0.0;
    for (float t = 0.0; t < 2.0; t += pace)
        sum += t * u_time;
    return sum;
}

void main() {
    float pace = 0.5 + 0.1 * sin(wave(v_position) + wave(v_normal.zxy));
    int count = 2 + int(abs(2.0 * wave(v_position * 2.0) + wave(v_normal)));
    float left = 1.5 + sin(wave(v_normal * 3.0) + wave(v_position.yxz));
    float sum = march(pace);
    int i = 0;
    do {
        sum += 0.125 * float(i++);
    } while (i != count);
    while (true) {
        if (left > 4.0)
            break;
        left *= 1.0 + 0.5 * pace * pace;
    }
    color = vec4(sum, left, float(count), 1.0) + fwidth(v_position.x);
}
