#version 330 core
// shadercache: original, unchanged

struct legacy_LightSourceParameters {
    vec4 diffuse;
    vec4 position;
};

struct legacy_MaterialParameters {
    vec4 ambient;
};

struct legacy_FogParameters {
    vec4 color;
};

uniform legacy_LightSourceParameters legacy_LightSource[1];
in vec4 legacy_TexCoord[1];
uniform legacy_MaterialParameters legacy_FrontMaterial;
in vec4 legacy_FrontColor;
out vec4 legacy_FragColor;
uniform legacy_FogParameters legacy_Fog;
in float legacy_FogFragCoord;
uniform sampler2D legacy_texture;
in vec3 normal;
in vec3 eye;

float noise(vec3 p) {
    return fract(sin(dot(p, vec3(12.9898, 78.233, 37.719))) * 43758.5453);
}

float legacy_round(float x) {
    return floor(x + 0.5);
}

void main() {
    vec3 l = legacy_LightSource[0].position.xyz;
    vec3 n = normalize(normal);
    float d = max(dot(n, normalize(l - eye)), 0.0);
    vec4 base = texture(legacy_texture, legacy_TexCoord[0].xy);
    float k = 0.0;
    for (int i = 0; i < 8; i++)
        k += noise(eye * float(i) + legacy_round(base.x));
    vec4 c = base * (legacy_LightSource[0].diffuse * d + legacy_FrontMaterial.ambient) * legacy_FrontColor;
    c.rgb += n * k;
    legacy_FragColor = mix(legacy_Fog.color, c, clamp(legacy_FogFragCoord, 0.0, 1.0));
}
