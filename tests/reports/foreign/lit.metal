#include <metal_stdlib>
using namespace metal;

struct VertexOut {
    float4 position [[position]];
    float3 normal;
    float2 uv;
};

fragment float4 lit_fragment(VertexOut in [[stage_in]],
                             constant float3 &light [[buffer(0)]],
                             texture2d<float> albedo [[texture(0)]])
{
    constexpr sampler linear(filter::linear);
    float lit = saturate(dot(normalize(in.normal), light));
    return float4(albedo.sample(linear, in.uv).rgb * lit, 1.0);
}
