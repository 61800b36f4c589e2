// Endless plane of corner tiles over {{colors}} colors, seed {{seed}}; made by tilewright {{version}}.
// HLSL, shader model 4 and up. Positions p are in tiles, x east, y south.
// {{#array}}
// {{^several}}
// Textures are arrays with a layer for each tile. Filter them trilinear or anisotropic; clamp.
// {{/several}}
// {{#several}}
// Textures are arrays with a layer for each of {{variants}} variants of each tile. Filter them trilinear or
// anisotropic; clamp.
// {{/several}}
// {{/array}}
// {{#grid}}
// Textures hold each picture in a square of a grid, with a gutter around it. Filter them trilinear or anisotropic;
// clamp.
// {{/grid}}
// {{#atlas}}
// {{^several}}
// Textures are atlases that hold each tile once. Filter them trilinear or anisotropic; repeat.
// {{/several}}
// {{#several}}
// Textures are atlases that hold each of {{variants}} variants of each tile once. Filter them trilinear or
// anisotropic; repeat.
// {{/several}}
// {{/atlas}}
#ifndef TILEWRIGHT_INCLUDED
#define TILEWRIGHT_INCLUDED

{{functions}}
// {{#array}}
// Where p is sampled: place and layer, and gradients of the place taken before p was split into tiles.
struct TwPlace { float3 uv; float2 dx; float2 dy; };

// p is counted from the cell origin; move it to have another part of the plane.
TwPlace TwFind(float2 p, int2 origin) {
  float2 cell = floor(p);
  TwPlace at;
  int2 here = (int2)cell + origin;
  uint layer = TwTile(TwCorners(here));
// {{#classed}}
  layer += TwClass(here) * {{tiles}}u;
// {{/classed}}
// {{#several}}
  layer = layer * {{variants}}u + TwVariant(here);
// {{/several}}
  at.uv = float3((p - cell) * {{scale}} + {{gutter}}, (float)layer);
  at.dx = ddx(p) * {{scale}};
  at.dy = ddy(p) * {{scale}};
  return at;
}

float4 TwSample(Texture2DArray map, SamplerState filtering, TwPlace at) {
  return map.SampleGrad(filtering, at.uv, at.dx, at.dy);
}
// {{/array}}
// {{#atlas}}
// Where p is sampled, and gradients of that taken before p was split into tiles.
struct TwPlace { float2 uv; float2 dx; float2 dy; };

// p is counted from the cell origin; move it to have another part of the plane.
TwPlace TwFind(float2 p, int2 origin) {
  float2 cell = floor(p);
  TwPlace at;
// {{^several}}
  at.uv = ((float2)TwPlaceOf(TwCorners((int2)cell + origin)) + (p - cell)) * {{scale}};
// {{/several}}
// {{#several}}
  int2 here = (int2)cell + origin;
  uint2 place = TwPlaceOf(TwCorners(here)) + uint2(TwVariant(here) * {{side}}u, 0u);
  at.uv = ((float2)place + (p - cell)) * {{scale}};
// {{/several}}
  at.dx = ddx(p) * {{scale}};
  at.dy = ddy(p) * {{scale}};
  return at;
}

float4 TwSample(Texture2D map, SamplerState filtering, TwPlace at) {
  return map.SampleGrad(filtering, at.uv, at.dx, at.dy);
}
// {{/atlas}}
// {{#grid}}
// Where p is sampled, and gradients of that taken before p was split into tiles.
struct TwPlace { float2 uv; float2 dx; float2 dy; };

// p is counted from the cell origin; move it to have another part of the plane.
TwPlace TwFind(float2 p, int2 origin) {
  float2 cell = floor(p);
  TwPlace at;
  int2 here = (int2)cell + origin;
  uint picture = TwTile(TwCorners(here));
// {{#classed}}
  picture += TwClass(here) * {{tiles}}u;
// {{/classed}}
// {{#several}}
  picture = picture * {{variants}}u + TwVariant(here);
// {{/several}}
  float2 square = float2(picture % {{columns}}u, picture / {{columns}}u) * {{square}};
  at.uv = square + (p - cell) * {{scale}} + {{gutter}};
  at.dx = ddx(p) * {{scale}};
  at.dy = ddy(p) * {{scale}};
  return at;
}

float4 TwSample(Texture2D map, SamplerState filtering, TwPlace at) {
  return map.SampleGrad(filtering, at.uv, at.dx, at.dy);
}
// {{/grid}}

// Normal of a normal map, green up (OpenGL): x east, y north, z out of the picture.
float3 TwNormal(float4 texel) {
  float2 n = texel.xy * 2.0 - 1.0;
  return float3(n, sqrt(max(0.0, 1.0 - dot(n, n))));
}
// {{#toned}}
{{tone}}
// {{/toned}}

#endif
