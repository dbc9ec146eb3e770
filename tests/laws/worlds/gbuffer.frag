layout(location = 2) out vec4 g_material;
layout(location = 0) out vec4 g_albedo;
layout(location = 1) out vec3 g_normal;

void main() {
    float rock = pitted(p);
    g_normal = normalize(n + 0.1 * rock);
    g_albedo = vec4(vec3(0.4, 0.35, 0.3) + 0.2 * rock, 1.0);
    g_material = vec4(0.5, rock, 0.0, 1.0);
}
