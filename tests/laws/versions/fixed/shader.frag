#version 120
uniform sampler2D texture;
varying vec3 normal;
varying vec3 eye;
float noise(vec3 p) { return fract(sin(dot(p, vec3(12.9898, 78.233, 37.719))) * 43758.5453); }
float round(float x) { return floor(x + 0.5); }
void main() {
    vec3 l = gl_LightSource[0].position.xyz;
    vec3 n = normalize(normal);
    float d = max(dot(n, normalize(l - eye)), 0.0);
    vec4 base = texture2D(texture, gl_TexCoord[0].xy);
    float k = 0.0;
    for (int i = 0; i < 8; i++) k += noise(eye * float(i) + round(base.x));
    vec4 c = base * (gl_LightSource[0].diffuse * d + gl_FrontMaterial.ambient) * gl_Color;
    c.rgb += n * k;
    gl_FragColor = mix(gl_Fog.color, c, clamp(gl_FogFragCoord, 0.0, 1.0));
}
