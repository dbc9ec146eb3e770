#version 330 core
in vec3 vPos;
in vec3 vNormal;
in vec3 vWorld;

uniform vec3 uCameraPos;
uniform vec3 uLightDir;
uniform vec4 uBaseColor;
uniform float uWarp;

out vec4 FragColor;

float waves(vec3 p) {
    float sum = 0.0;
    for (int i = 1; i < 6; ++i) {
        float k = float(i) * 3.1;
        sum += sin(k * p.x + sin(k * p.y + uWarp)) * cos(k * p.z) / float(i);
    }
    return sum;
}

void main() {
    float veins = smoothstep(-0.3, 0.8, waves(vPos));
    vec3 n = normalize(vNormal);
    if (!gl_FrontFacing) n = -n;
    vec3 toEye = normalize(uCameraPos - vWorld);
    vec3 middle = normalize(toEye + normalize(uLightDir));
    float light = 0.2 + max(dot(n, normalize(uLightDir)), 0.0);
    vec3 color = uBaseColor.rgb * mix(0.3, 1.0, veins) * light;
    FragColor = vec4(color + 0.3 * pow(max(dot(n, middle), 0.0), 40.0), 1.0);
}
