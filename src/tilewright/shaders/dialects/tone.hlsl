
// What varies over more than a tile: patches of a small picture of it (half floats, filtered as the maps
// are; clamp) around the corners of a triangle of their grid, blended so that their variance stays.

// Square of the grid that holds a cell, along one axis.
int TwSquare(int cell) { return cell < 0 ? -1 - (-1 - cell) / {{span}} : cell / {{span}}; }

// Texel that lies at a corner of a square.
float2 TwMiddle(int2 square, int2 corner, uint2 size) {
  uint x = (uint)square.x + (uint)corner.x, y = (uint)square.y + (uint)corner.y;
  bool west = square.x < -corner.x, north = square.y < -corner.y;
  uint2 east = north ? uint2({{ta2}}u, {{tb2}}u) : uint2({{ta0}}u, {{tb0}}u);
  uint2 start = west ? (north ? uint2({{ta3}}u, {{tb3}}u) : uint2({{ta1}}u, {{tb1}}u)) : east;
  uint a = TwMix(start.x ^ y), h = a ^ x;
  h ^= h >> 16; h = h * {{m0}}u + TwMix((start.y ^ a) + y);
  h ^= h >> 15; h *= {{m1}}u;
  h = (h ^ (h >> 15)) >> 8;
  return float2(((h & 4095u) * size.x) >> 12, ((h >> 12) * size.y) >> 12);
}

// A patch, mirrored at the borders of the picture.
float3 TwPatch(Texture2D tone, SamplerState filtering, float2 at, float2 dx, float2 dy) {
  float2 folded = at - 2.0 * floor(0.5 * at);
  return tone.SampleGrad(filtering, min(folded, 2.0 - folded), dx, dy).rgb;
}

// Tone at p, around 0, of colors in sRGB.
float3 TwTone(Texture2D tone, SamplerState filtering, float2 p, int2 origin) {
  uint2 texels;
  tone.GetDimensions(texels.x, texels.y);
  float2 size = (float2)texels, scale = {{tone_texels}} / size, cell = floor(p);
  float2 dx = ddx(p) * scale, dy = ddy(p) * scale;
  int2 here = (int2)cell + origin, square = int2(TwSquare(here.x), TwSquare(here.y));
  float2 at = (float2)(here - square * {{span}}) + p - cell, share = at / {{span}}.0;
  int far = share.x + share.y > 1.0 ? 1 : 0;
  float3 weights = float3(1.0 - share.x - share.y, share.x, share.y);
  if (far > 0) weights = float3(share.x + share.y - 1.0, 1.0 - share.y, 1.0 - share.x);
  int2 corners[3] = { int2(far, far), int2(1, 0), int2(0, 1) };
  float3 sum = 0.0;
  for (int k = 0; k < 3; k++) {
    float2 middle = TwMiddle(square, corners[k], texels);
    float2 there = (at - (float2)(corners[k] * {{span}})) * scale + middle / size;
    sum += weights[k] * TwPatch(tone, filtering, there, dx, dy);
  }
  return sum / length(weights);
}

// A map's light with its tone, which is added to light as sRGB encodes it; what is darker than the map's mean takes
// less of it. Numbers, such as roughness, take tone as it is: saturate(number + TwTone(...).r).
float3 TwLay(float3 light, float3 tone, float3 mean) {
  float3 bent = 1.055 * pow(max(light, 0.0031308), 1.0 / 2.4) - 0.055;
  float3 bare = lerp(12.92 * light, bent, step(0.0031308, light));
  float3 share = lerp(bare / max(mean, 1e-6), 1.0, step(mean, bare));
  float3 shown = max(bare + share * tone, 0.0);
  float3 straight = pow((max(shown, 0.04045) + 0.055) / 1.055, 2.4);
  return lerp(shown / 12.92, straight, step(0.04045, shown));
}
