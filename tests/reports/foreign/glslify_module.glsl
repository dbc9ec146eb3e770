float halve(vec3 p) {
  return 0.5 * (p.x + p.y + p.z);
}

#pragma glslify: export(halve)
