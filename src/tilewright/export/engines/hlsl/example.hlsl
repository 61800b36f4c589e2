// How to use tilewright.hlsl.
#include "tilewright.hlsl"

{{texture}} colorMap : register(t0);
// {{#color_toned}}
Texture2D colorTone : register(t1);
// {{/color_toned}}
SamplerState filtering : register(s0);  // MIN_MAG_MIP_LINEAR or ANISOTROPIC, {{edge}}

float4 main(float4 position : SV_Position, float2 uv : TEXCOORD0) : SV_Target {
  const float tiles = 8.0;  // across one unit of uv; turn y over where v points up
  TwPlace at = TwFind(uv * tiles, int2(0, 0));
// {{^color_toned}}
  return TwSample(colorMap, filtering, at);
// {{/color_toned}}
// {{#color_toned}}
  float4 color = TwSample(colorMap, filtering, at);
  float3 tone = TwTone(colorTone, filtering, uv * tiles, int2(0, 0));
  return float4(TwLay(color.rgb, tone, float3({{mean}})), color.a);
// {{/color_toned}}
}
