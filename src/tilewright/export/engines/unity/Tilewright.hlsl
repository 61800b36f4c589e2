{{include}}
// Shader Graph: Custom Function nodes of type File, with precision Single. Position is in tiles, x right and
// y up as UV coordinates are; Origin is a cell, another one for each object.
// {{#array}}
#define TW_MAP UnityTexture2DArray
#define TW_SAMPLE(map, at) SAMPLE_TEXTURE2D_ARRAY_GRAD(map.tex, map.samplerstate, at.uv.xy, at.uv.z, at.dx, at.dy)
// {{/array}}
// {{^array}}
#define TW_MAP UnityTexture2D
#define TW_SAMPLE(map, at) SAMPLE_TEXTURE2D_GRAD(map.tex, map.samplerstate, at.uv, at.dx, at.dy)
// {{/array}}

TwPlace TwFindUp(float2 position, float2 origin) {
  return TwFind(float2(position.x, -position.y), (int2)round(origin));
}

// {{#toned}}
float3 TwToneUp(Texture2D tone, SamplerState filtering, float2 position, float2 origin) {
  return TwTone(tone, filtering, float2(position.x, -position.y), (int2)round(origin));
}

// Function name: TilewrightTone; what a map holds with its tone. Mean is the map's in sRGB, {{mean}} of the map of
// color and for others in tilewright.json; -1 for numbers such as roughness.
void TilewrightTone_float(
    UnityTexture2D Tone, float4 Color, float3 Mean, float2 Position, float2 Origin, out float4 Toned) {
  float3 tone = TwToneUp(Tone.tex, Tone.samplerstate, Position, Origin);
  Toned = float4(Mean.x < 0.0 ? saturate(Color.rgb + tone) : TwLay(Color.rgb, tone, Mean), Color.a);
}

// {{/toned}}
// Function name: Tilewright
void Tilewright_float(TW_MAP Map, float2 Position, float2 Origin, out float4 Color) {
  TwPlace at = TwFindUp(Position, Origin);
  Color = TW_SAMPLE(Map, at);
}

// Function name: TilewrightNormal; Normal is in tangent space
void TilewrightNormal_float(TW_MAP Map, float2 Position, float2 Origin, out float3 Normal) {
  TwPlace at = TwFindUp(Position, Origin);
  Normal = TwNormal(TW_SAMPLE(Map, at));
}
