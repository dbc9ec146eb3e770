// Where a fragment of a smaller picture lies in one of the full size.
uniform vec4 sc_scale;  // from pixels to texels of a smaller cache: times .xy, plus .zw

vec4 sc_WHOLE() {
    return vec4((gl_FragCoord.xy - sc_scale.zw) / sc_scale.xy, gl_FragCoord.zw);
}
