precision mediump float;

varying vec2 v_texcoord;
varying vec3 v_normal;

uniform sampler2D u_texture;
uniform vec3 u_lightDirection;

void main() {
    float light = 0.2 + max(dot(normalize(v_normal), u_lightDirection), 0.0);
    float waves = 0.7 + 0.3 * sin(20.0 * v_texcoord.x) * cos(9.0 * v_texcoord.y);
    gl_FragColor = vec4(texture2D(u_texture, v_texcoord).rgb * light * waves, 1.0);
}
