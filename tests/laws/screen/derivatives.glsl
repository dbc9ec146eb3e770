// Frames from derivatives of varyings: in functions, globals, structs, arrays and out-parameters.
struct Frame { vec3 along; vec3 across; };
vec3 g_face;

vec3 face(vec3 p) { return normalize(cross(dFdx(p), dFdy(p))); }

Frame frame(vec3 p, vec2 at) {
    vec3 x = dFdx(p), y = dFdy(p);
    vec2 s = dFdx(at), t = dFdy(at);
    return Frame(normalize(x * t.y - y * s.y), normalize(y * s.x - x * t.x));
}

void slopes(vec3 p, out vec3 x, inout float width) {
    x = dFdx(p);
    width += fwidth(p.y);
}

void main() {
    Frame made = frame(v_position, v_uv);
    vec3 through = vec3(wave(face(v_position)));
    vec3 fields = vec3(wave(made.along), wave(made.across), 0.0);
    g_face = face(v_position * u_gain);
    vec3 stored = g_face;
    vec3 rows[2] = vec3[](dFdxFine(v_position), dFdyCoarse(v_position));
    float elements = wave(rows[0] * 40.0) + wave(rows[1] * 40.0);
    vec3 x;
    float width = 0.5;
    slopes(v_position, x, width);
    float given = wave(x * 30.0) * width;
    float lines = smoothstep(0.5 - fwidth(v_uv.x * 20.0), 0.5, fract(v_uv.x * 20.0));
    float twice = wave(vec3(dFdx(v_uv * dFdy(v_position.y)), 0.0) * 900.0);
    vec4 fetched = textureGrad(u_map, v_uv, dFdx(v_uv) * 4.0, dFdy(v_uv) * 4.0);
    float coarse = wave(vec3(fwidthCoarse(texture(u_map, v_uv * 2.0).xy), 1.0));
    o_color = vec4(through + fields * 0.3, elements) + vec4(given, lines, twice, coarse) * 0.2;
    o_color += sqrt(fetched) * 0.3 + vec4(wave(stored));
}
