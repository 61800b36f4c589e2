// A lit surface of an endless texture, for Unity's Universal Render Pipeline.
Shader "Tilewright/Lit" {
  Properties {
    _Tiles ("Tiles across one unit of UV", Vector) = (8, 8, 0, 0)
    _Origin ("Origin cell", Vector) = (0, 0, 0, 0)
{{properties}}
  }
  SubShader {
// {{^cut_out}}
    Tags { "RenderType" = "Opaque" "RenderPipeline" = "UniversalPipeline" }
// {{/cut_out}}
// {{#cut_out}}
    Tags { "RenderType" = "TransparentCutout" "Queue" = "AlphaTest" "RenderPipeline" = "UniversalPipeline" }
// {{/cut_out}}
    Pass {
      Name "ForwardLit"
      Tags { "LightMode" = "UniversalForward" }
      HLSLPROGRAM
      #pragma target 4.5
      #pragma vertex Vertex
      #pragma fragment Fragment
      #pragma multi_compile _ _MAIN_LIGHT_SHADOWS _MAIN_LIGHT_SHADOWS_CASCADE _MAIN_LIGHT_SHADOWS_SCREEN
      #pragma multi_compile _ _ADDITIONAL_LIGHTS
      #pragma multi_compile_fog
      #include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"
      #include "Tilewright.hlsl"

{{textures}}
      CBUFFER_START(UnityPerMaterial)
      float4 _Tiles, _Origin;
      CBUFFER_END

      struct Attributes {
        float4 position : POSITION;
        float3 normal : NORMAL;
        float4 tangent : TANGENT;
        float2 uv : TEXCOORD0;
      };

      struct Varyings {
        float4 position : SV_POSITION;
        float2 uv : TEXCOORD0;
        float3 world : TEXCOORD1;
        float3 normal : TEXCOORD2;
        float4 tangent : TEXCOORD3;
        float fog : TEXCOORD4;
      };

      Varyings Vertex(Attributes input) {
        Varyings output = (Varyings)0;
        VertexPositionInputs at = GetVertexPositionInputs(input.position.xyz);
        VertexNormalInputs frame = GetVertexNormalInputs(input.normal, input.tangent);
        output.position = at.positionCS;
        output.world = at.positionWS;
        output.normal = frame.normalWS;
        output.tangent = float4(frame.tangentWS, input.tangent.w * GetOddNegativeScale());
        output.fog = ComputeFogFactor(at.positionCS.z);
        output.uv = input.uv * _Tiles.xy;
        return output;
      }

      half4 Fragment(Varyings input) : SV_Target {
        TwPlace at = TwFindUp(input.uv, _Origin.xy);
        SurfaceData surface = (SurfaceData)0;
        surface.albedo = 0.5;
        surface.alpha = 1;
        surface.occlusion = 1;
        surface.normalTS = half3(0, 0, 1);
{{reads}}
        float3 bitangent = cross(input.normal, input.tangent.xyz) * input.tangent.w;
        float3x3 frame = float3x3(input.tangent.xyz, bitangent, input.normal);
        InputData lit = (InputData)0;
        lit.positionWS = input.world;
        lit.normalWS = normalize(mul(surface.normalTS, frame));
        lit.viewDirectionWS = GetWorldSpaceNormalizeViewDir(input.world);
        lit.shadowCoord = TransformWorldToShadowCoord(input.world);
        lit.fogCoord = input.fog;
        lit.bakedGI = SampleSH(lit.normalWS);
        lit.normalizedScreenSpaceUV = GetNormalizedScreenSpaceUV(input.position);
        half4 color = UniversalFragmentPBR(lit, surface);
        color.rgb = MixFog(color.rgb, input.fog);
        return color;
      }
      ENDHLSL
    }
    UsePass "Universal Render Pipeline/Lit/ShadowCaster"
// {{^cut_out}}
    UsePass "Universal Render Pipeline/Lit/DepthOnly"
// {{/cut_out}}
  }
}
