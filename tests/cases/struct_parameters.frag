#version 330
// Structs as parameters, results, out arguments and array elements.
in vec3 v_position;
in vec3 v_normal;
in vec2 v_uv;
uniform vec3 u_light;
uniform float u_time;
out vec4 o_color;

float wave(vec3 p) {
    return sin(p.x * 3.1) * cos(p.y * 2.3) + sin(p.z * 4.7 + cos(p.x));
}


struct Point { vec3 place; float weight; };
struct Pair { Point one; Point other[2]; };

Point moved(Point p, vec3 by) { p.place += by; p.weight *= wave(p.place); return p; }

void swap(inout Point a, out Point b) { b = a; a.weight = wave(b.place) + 0.5; }

float total(Pair pair) { return pair.one.weight + pair.other[1].weight * wave(pair.other[0].place); }

void main() {
    Point p = Point(v_position, 0.75);
    Point q = moved(p, v_normal);
    Point r;
    swap(q, r);
    Pair pair = Pair(p, Point[2](q, r));
    pair.other[1].place.y = wave(r.place);
    bool same = p == r;
    o_color = vec4(total(pair), q.weight, wave(pair.other[1].place), same ? 1.0 : 0.5);
}
