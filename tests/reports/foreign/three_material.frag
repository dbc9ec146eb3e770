// A ShaderMaterial: three.js puts uniforms and precisions before it.
uniform float uTime;
varying vec2 vUv;

void main() {
  vec3 view = normalize(cameraPosition - vec3(vUv, 0.0));
  gl_FragColor = vec4(abs(sin(view * uTime)), 1.0);
}
