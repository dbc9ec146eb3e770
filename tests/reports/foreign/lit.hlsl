cbuffer PerFrame : register(b0)
{
    float4x4 ViewProjection;
    float3 Eye;
    float Time;
};

Texture2D Albedo : register(t0);
SamplerState Linear : register(s0);

struct Input
{
    float4 position : SV_POSITION;
    float3 normal : NORMAL;
    float2 uv : TEXCOORD0;
};

float4 main(Input input) : SV_Target
{
    float3 light = normalize(float3(0.3, 0.8, 0.5));
    float lit = saturate(dot(normalize(input.normal), light));
    return float4(Albedo.Sample(Linear, input.uv).rgb * lit, 1.0);
}
