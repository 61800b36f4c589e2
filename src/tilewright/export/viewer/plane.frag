#version 300 es
// A pixel of the endless plane. Positions are texels counted from the origin cell, which is a 64-bit
// integer: the view never runs out of digits. The picture is that of one endless texture with box-filtered
// mip levels: every level is sampled across tile borders, from the tiles that really lie there.
precision highp float;
precision highp int;
precision highp sampler2DArray;
precision highp usampler2D;
// {{defines}}

uniform sampler2DArray uTiles;
uniform usampler2D uTable;       // baked cells, or the tile of each code of an incomplete set
uniform uvec2 uFirst, uMarks;    // hash states: edges or corners; marks of corner-coded sets
uniform uvec4 uRadices;          // colors of horizontal edges, vertical edges, unused, corners
uniform uvec2 uOriginX, uOriginY;
uniform bool uBaked;              // cells lie in uTable and end there
uniform int uRepeat;             // the tile to repeat everywhere, or -1
uniform int uSize, uAcross, uTopLevel;  // texels of a tile; tiles along a layer; level of one texel
uniform vec4 uMean;              // of all tiles, as stored in level uTopLevel
uniform bool uEncode;            // the map is light: filtered linearly, shown as sRGB

uniform vec2 uCenter;            // texel at the middle of the view
uniform float uScale;            // texels per pixel there
uniform vec2 uViewport;          // pixels
uniform float uFocal;            // pixels from the eye to the middle of the view
uniform vec2 uTilt, uTurn;       // (cos, sin)
uniform bool uBorders;
uniform float uPixelRatio;
uniform vec3 uSky, uBackdrop;

out vec4 color;

// {{lattice}}

vec4 texel(int tile, ivec2 at, int level, int n) {
  if (tile < 0) return vec4(0.0);
  int perLayer = uAcross * uAcross, place = tile % perLayer;
  ivec2 corner = ivec2(place % uAcross, place / uAcross) * n;
  vec4 t = texelFetch(uTiles, ivec3(corner + at, tile / perLayer), level);
  return vec4(t.rgb * t.a, t.a);
}

// The cell a position is in, and the rest of it, 0 up to the tile's size.
void divide(vec2 p, out ivec2 cell, out vec2 rest) {
  float size = float(uSize);
  vec2 c = floor(p / size);
  rest = p - c * size;
  vec2 over = step(size, rest) - step(rest, vec2(-1e-9));
  cell = ivec2(c + over);
  rest -= over * size;
}

// One level, bilinear between the four nearest texels, whichever tiles they belong to. Enlarged
// texels keep crisp edges `sharp` pixels to the texel apart.
vec4 sampleLevel(vec2 p, int level, float sharp) {
  int n = uSize >> level;
  ivec2 cell;
  vec2 rest;
  divide(p, cell, rest);
  vec2 q = rest * (float(n) / float(uSize)) - 0.5;
  vec2 base = floor(q);
  vec2 w = clamp((q - base - 0.5) * sharp + 0.5, 0.0, 1.0);
  vec4 weights = vec4((1.0 - w.x) * (1.0 - w.y), w.x * (1.0 - w.y), (1.0 - w.x) * w.y, w.x * w.y);
  vec4 sum = vec4(0.0);
  ivec2 known = ivec2(0x7fffffff);
  int tile = -1;
  for (int k = 0; k < 4; k++) {
    if (weights[k] > 0.0) {
      ivec2 at = ivec2(base) + ivec2(k & 1, k >> 1);
      ivec2 over = ivec2(greaterThanEqual(at, ivec2(n))) - ivec2(lessThan(at, ivec2(0)));
      if (cell + over != known) tile = tileAt(known = cell + over);
      sum += weights[k] * texel(tile, at - over * n, level, n);
    }
  }
  return sum;
}

// log2 of a level's texel size; tiles that are no power of two have odd steps.
float levelSize(int level) { return log2(float(uSize) / float(uSize >> level)); }

// A pixel whose footprint is spanned by dx and dy: up to 16 samples along its longer axis, each from the
// two levels around its size. Beyond the level of one texel per tile many tiles average out towards the
// mean of the set, half as far for each doubling.
vec4 samplePixel(vec2 p, vec2 dx, vec2 dy) {
  float a = dot(dx, dx), b = dot(dy, dy), c = dx.x * dy.y - dx.y * dy.x;
  float root = sqrt(max((a + b) * (a + b) - 4.0 * c * c, 0.0));
  float major = sqrt(0.5 * (a + b + root)), minor = max(abs(c) / major, 1.0);
  int count = clamp(int(ceil(major / minor - 0.02)), 1, 16);
  float lod = max(0.0, log2(major / float(count)));
  float sharp = mix(1.0, 1.0 / major, smoothstep(2.0, 6.0, 1.0 / major));

  // The two levels, the share of the second, and what is left of the tiles' differences.
  float last = levelSize(uTopLevel);
  float keep = uBaked ? 1.0 : exp2(min(0.0, last - lod));
  lod = min(lod, last);
  int level = max(0, min(int(lod), uTopLevel - 1));
  if (levelSize(level) > lod) level--;
  float low = levelSize(level), high = levelSize(level + 1);
  float blend = (lod - low) / (high - low);

  vec4 mean = uMean;
  if (uRepeat >= 0) mean = texel(uRepeat, ivec2(0), uTopLevel, 1);
  if (keep < 0.01) return mean;

  // The longer axis of the ellipse: eigenvector of dx dx' + dy dy'.
  vec2 axis = vec2(0.0);
  if (count > 1) {
    float xx = dx.x * dx.x + dy.x * dy.x, xy = dx.x * dx.y + dy.x * dy.y;
    axis = vec2(major * major - (a + b - xx), xy);
    float size = length(axis);
    axis = size < 1e-6 * major * major ? vec2(0.0, major) : axis * (major / size);
  }
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 2 * count; i++) {
    bool second = i >= count;
    float share = second ? blend : 1.0 - blend;
    if (share > 0.0) {
      float along = (float(second ? i - count : i) + 0.5) / float(count) - 0.5;
      sum += share * sampleLevel(p + axis * along, second ? level + 1 : level, sharp);
    }
  }
  return mix(mean, sum / float(count), keep);
}

vec3 toShown(vec3 c) {
  return mix(12.92 * c, 1.055 * pow(max(c, 0.0031308), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

vec3 palette(uint c) {
  return 0.55 + 0.45 * cos(6.2832 * (float(c) * 0.618 + vec3(0.02, 0.36, 0.64)));
}

float cover(float distance, float halfWidth) { return clamp(halfWidth + 0.5 - distance, 0.0, 1.0); }

// Lines between tiles, in screen pixels; edges and corners wear the colors that made them meet.
vec3 drawBorders(vec3 shown, vec2 p, vec2 dx, vec2 dy) {
  ivec2 cell;
  vec2 rest;
  divide(p, cell, rest);
  float size = float(uSize);
  vec2 perTexel = 1.0 / max(vec2(length(vec2(dx.x, dy.x)), length(vec2(dx.y, dy.y))), 1e-6);
  vec2 strength = smoothstep(6.0, 24.0, size * perTexel / uPixelRatio);
  vec2 gap = min(rest, size - rest) * perTexel / uPixelRatio;
  vec2 dark = strength * vec2(cover(gap.x, 1.5), cover(gap.y, 1.5));
  vec2 line = strength * vec2(cover(gap.x, 0.5), cover(gap.y, 0.5));
  vec3 vertical = vec3(1.0), horizontal = vec3(1.0), corner = vec3(1.0);
#ifndef ALGORITHM_BAKED
  if (uRepeat < 0) {
    Slots s = slotsAt(plus(uOriginX, cell.x), plus(uOriginY, cell.y));
    bvec2 far = greaterThan(rest, vec2(0.5 * size));
#ifdef HAS_EDGES
    vertical = palette(far.x ? s.edges.y : s.edges.w);
    horizontal = palette(far.y ? s.edges.z : s.edges.x);
    line = strength * vec2(cover(gap.x, 1.0), cover(gap.y, 1.0));
    dark = strength * vec2(cover(gap.x, 2.0), cover(gap.y, 2.0));
#endif
#ifdef HAS_CORNERS
    corner = palette(far.x ? (far.y ? s.corners.y : s.corners.x) : (far.y ? s.corners.z : s.corners.w));
#endif
  }
#endif
  shown = mix(shown, vec3(0.0), 0.4 * max(dark.x, dark.y));
  shown = mix(shown, horizontal, 0.8 * line.y);
  shown = mix(shown, vertical, 0.8 * line.x);
#ifdef HAS_CORNERS
  float det = dx.x * dy.y - dx.y * dy.x;
  vec2 d = rest - size * step(0.5 * size, rest);
  vec2 onScreen = vec2(dy.y * d.x - dy.x * d.y, dx.x * d.y - dx.y * d.x) / det / uPixelRatio;
  float visible = uRepeat < 0 ? min(strength.x, strength.y) : 0.0;
  shown = mix(shown, vec3(0.08), visible * cover(length(onScreen), 5.5));
  shown = mix(shown, corner, visible * cover(length(onScreen), 4.0));
#endif
  return shown;
}

void main() {
  // The ray of this pixel meets the plane: s is the pixel from the middle, y down.
  vec2 s = vec2(gl_FragCoord.x, uViewport.y - gl_FragCoord.y) - 0.5 * uViewport;
  float depth = uTilt.x + s.y * uTilt.y / uFocal;
  float ground = clamp(depth * uFocal / max(uTilt.y, 1e-6) + 0.5, 0.0, 1.0);  // 0 above the horizon
  depth = max(depth, 1e-4);
  float y = uScale * s.y / depth;
  float across = uScale - y * uTilt.y / uFocal;
  vec2 there = vec2(s.x * across, y);
  vec2 dx = vec2(across, 0.0);
  float dyds = uScale * uTilt.x / (depth * depth);
  vec2 dy = vec2(-s.x * dyds * uTilt.y / uFocal, dyds);
  mat2 turn = mat2(uTurn.x, uTurn.y, -uTurn.y, uTurn.x);
  vec2 p = uCenter + turn * there;
  dx = turn * dx;
  dy = turn * dy;

  vec4 light = samplePixel(p, dx, dy);
  vec3 shown = uEncode ? toShown(light.rgb / max(light.a, 1e-6)) : light.rgb / max(light.a, 1e-6);
  shown = mix(uBackdrop, shown, light.a);
  if (uBorders) shown = drawBorders(shown, p, dx, dy);
  color = vec4(mix(uSky, shown, ground), 1.0);
}
