mediump ivec3 sc_payload;
mediump vec4 sc_payload;
bvec3 sc_payload;
Mixed sc_payload;
