Shader "Custom/Waves"
{
    Properties
    {
        _MainTex ("Texture", 2D) = "white" {}
        _Amount ("Amount", Range(0, 1)) = 0.5
    }
    SubShader
    {
        Tags { "RenderType" = "Opaque" }
        Pass
        {
            CGPROGRAM
            #pragma vertex vert
            #pragma fragment frag
            #include "UnityCG.cginc"
            sampler2D _MainTex;
            float _Amount;
            fixed4 frag (v2f_img i) : SV_Target { return tex2D(_MainTex, i.uv) * _Amount; }
            ENDCG
        }
    }
}
