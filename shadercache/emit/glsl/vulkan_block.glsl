// The uniforms of the passes where none may stand outside of a block: the same one in every pass, so
// that one buffer, written for each draw, does for all.
layout(std140) uniform sc_uniforms {
    highp ivec4 sc_viewport;
    highp ivec4 sc_previous_viewport;
    highp vec4 sc_scale;
    highp int sc_clock;
    highp int sc_period;
    highp int sc_block;
    highp int sc_reset;
    highp int sc_object;
    highp int sc_mask;
    highp int sc_group;
    highp float sc_epsilon;
    highp float sc_unit;
    highp float sc_magnification;
    highp float sc_change;
    highp float sc_resolution;
    highp float sc_limit;
    highp float sc_least;
};
