// Tiles laid by a tiling: what lies at a position, and the lines between tiles.

uniform sampler2DArray uTiles;
uniform usampler2D uTable;       // baked cells, or the tile of each code of an incomplete set
uniform uvec2 uFirst, uMarks;    // hash states: edges or corners; marks of corner-coded sets
uniform uvec4 uRadices;          // colors of horizontal edges, vertical edges, unused, corners
uniform uvec2 uOriginX, uOriginY;
uniform bool uBaked;             // cells lie in uTable and end there
uniform int uRepeat;             // the picture to repeat everywhere, or -1
uniform int uAcross;             // tiles along a layer
#ifdef HAS_VARIANTS
uniform usampler2D uVariants;    // first row of each tile and of none more, then the threshold of each row
uniform int uTileCount;
uniform uvec2 uDraw;             // hash state
#endif
#ifdef HAS_TONE
uniform sampler2D uTone;         // tone as a share of white
uniform bool uToned;             // the map has any
uniform vec3 uToneMean;          // below which tone is a factor
uniform int uSpan;               // tiles from point to point of the tone's grid
uniform float uTexel;            // texels of the map along one of tone
uniform uvec2 uSquareX, uSquareY, uToneState;  // square of the grid with the origin, hash state
uniform vec2 uSquareRest;        // texels from that square's corner to the origin
#endif

// --- Which tile: the direct tilings, bit for bit as in tilings/direct.py

uint finish(uvec2 state, uint xLow, uint count) { return (finish(state, xLow) * count) >> 24; }

// Colors of two lattice points (x0, y) and (x1, y) of one row.
uvec2 twoColors(uvec2 start, uvec2 x0, uvec2 x1, uvec2 y, uint count) {
  uvec2 state = startRow(start, x0.y, y);
  uint first = finish(state, x0.x, count);
  if (x1.y != x0.y) state = startRow(start, x1.y, y);
  return uvec2(first, finish(state, x1.x, count));
}

uint oneColor(uvec2 start, uvec2 x, uvec2 y, uint count) {
  return finish(startRow(start, x.y, y), x.x, count);
}

#ifdef ALGORITHM_CLASSED
// A 64-bit integer in two's complement modulo the number of classes.
uint classOf(uvec2 a) {
  const uint word = (0xffffffffu % CLASSES + 1u) % CLASSES, all = word * word % CLASSES;
  return ((a.y % CLASSES) * word + a.x % CLASSES + (a.y >> 31) * (CLASSES - all)) % CLASSES;
}

// NE, SE, SW, NW of the cell: colors of the class of each lattice point.
uvec4 cornerColors(uvec2 start, uvec2 x, uvec2 y, uint count) {
  uvec2 north = twoColors(start, x, plus(x, 1), y, COLORS);
  uvec2 south = twoColors(start, x, plus(x, 1), plus(y, 1), COLORS);
  uvec4 classes = classOf(x) + STEP * classOf(y) + uvec4(1u, 1u + STEP, STEP, 0u);
  return classes % CLASSES * COLORS + uvec4(north.y, south.y, south.x, north.x);
}
#else
// NE, SE, SW, NW of the cell, from the lattice points around it.
uvec4 cornerColors(uvec2 start, uvec2 x, uvec2 y, uint count) {
  uvec2 north = twoColors(start, x, plus(x, 1), y, count);
  uvec2 south = twoColors(start, x, plus(x, 1), plus(y, 1), count);
  return uvec4(north.y, south.y, south.x, north.x);
}
#endif

#if defined(ALGORITHM_EDGES) || defined(ALGORITHM_MARKED_EDGES)
// N, E, S, W: one hash on a lattice twice as dense.
uvec4 edgeColors(uvec2 x, uvec2 y) {
  uvec2 x2 = twice(x), y2 = twice(y);
  uvec2 vertical = twoColors(uFirst, x2, plus(x2, 2), plus(y2, 1), uRadices.y);
  return uvec4(
    oneColor(uFirst, plus(x2, 1), y2, uRadices.x), vertical.y,
    oneColor(uFirst, plus(x2, 1), plus(y2, 2), uRadices.x), vertical.x);
}
#elif defined(ALGORITHM_SUMS) || defined(ALGORITHM_MARKED_SUMS)
// N, E, S, W: sums of the colors at their ends.
uvec4 edgeColors(uvec2 x, uvec2 y) {
  uvec4 c = cornerColors(uFirst, x, y, uRadices.x);
  return (c.wxyz + c.xyzw) % uRadices.x;
}
#elif defined(ALGORITHM_BITS)
// N, E, S, W: the bits of the tiles before, on either axis.
uvec4 edgeColors(uvec2 x, uvec2 y) {
  uvec4 edges = uvec4(0u);
  for (int back = 1; (1u << back) <= uRadices.x; back++) {
    uint shift = uint(back - 1);
    edges.x |= oneColor(uFirst, x, plus(y, -back), 2u) << shift;
    edges.y |= oneColor(uFirst, plus(x, 1 - back), y, 2u) << shift;
    edges.z |= oneColor(uFirst, x, plus(y, 1 - back), 2u) << shift;
    edges.w |= oneColor(uFirst, plus(x, -back), y, 2u) << shift;
  }
  return edges;
}
#endif

struct Slots { uvec4 edges; uvec4 corners; };

Slots slotsAt(uvec2 x, uvec2 y) {
  Slots s = Slots(uvec4(0u), uvec4(0u));
#ifdef HAS_EDGES
  s.edges = edgeColors(x, y);
#endif
#ifdef HAS_CORNERS
  s.corners = cornerColors(CORNER_STREAM, x, y, uRadices.w);
#endif
  return s;
}

#ifdef HAS_VARIANTS
int variantEntry(int at) {
  int wide = textureSize(uVariants, 0).x;
  return int(texelFetch(uVariants, ivec2(at % wide, at / wide), 0).r);
}

// The picture of a tile that lies at a cell, as in tiles/variants.py.
int drawRow(int tile, uvec2 x, uvec2 y) {
  int number = int(finish(startRow(uDraw, x.y, y), x.x));
  int row = variantEntry(tile), last = variantEntry(tile + 1) - 1;
  while (row < last && number >= variantEntry(uTileCount + 2 + row)) row++;
  return row;
}
#else
int drawRow(int tile, uvec2 x, uvec2 y) { return tile; }
#endif

// Number of the picture at a cell counted from the origin, -1 where there is none.
int rowAt(ivec2 cell) {
  if (uRepeat >= 0) return uRepeat;
  uvec2 x = plus(uOriginX, cell.x), y = plus(uOriginY, cell.y);
#ifdef ALGORITHM_BAKED
  if ((x.y | y.y) != 0u || any(greaterThanEqual(uvec2(x.x, y.x), uvec2(textureSize(uTable, 0))))) return -1;
  return int(texelFetch(uTable, ivec2(x.x, y.x), 0).r);
#else
  Slots s = slotsAt(x, y);
  uint code = 0u;
#ifdef HAS_EDGES
  code = ((s.edges.x * uRadices.y + s.edges.y) * uRadices.x + s.edges.z) * uRadices.y + s.edges.w;
#endif
#ifdef HAS_CORNERS
  for (int i = 0; i < 4; i++) code = code * uRadices.w + s.corners[i];
#endif
#ifdef COMPLETE
  return drawRow(int(code), x, y);
#else
  uint wide = uint(textureSize(uTable, 0).x);
  return drawRow(int(texelFetch(uTable, ivec2(code % wide, code / wide), 0).r), x, y);
#endif
#endif
}

// --- Its texels

vec4 texel(int row, ivec2 at, int level, int n) {
  if (row < 0) return vec4(0.0);
  int perLayer = uAcross * uAcross, place = row % perLayer;
  ivec2 corner = ivec2(place % uAcross, place / uAcross) * n;
  vec4 t = texelFetch(uTiles, ivec3(corner + at, row / perLayer), level);
  return vec4(t.rgb * t.a, t.a);
}

// The cell a position is in, and the rest of it, 0 up to the tile's size.
void divide(vec2 p, out ivec2 cell, out vec2 rest) {
  float size = float(uSide);
  vec2 c = floor(p / size);
  rest = p - c * size;
  vec2 over = step(size, rest) - step(rest, vec2(-1e-9));
  cell = ivec2(c + over);
  rest -= over * size;
}

// One level, bilinear between the four nearest texels, whichever tiles they belong to. Enlarged
// texels keep crisp edges `sharp` pixels to the texel apart.
vec4 sampleLevel(vec2 p, int level, float sharp) {
  int n = uSide >> level;
  ivec2 cell;
  vec2 rest;
  divide(p, cell, rest);
  vec2 q = rest * (float(n) / float(uSide)) - 0.5;
  vec2 base = floor(q);
  vec2 w = clamp((q - base - 0.5) * sharp + 0.5, 0.0, 1.0);
  vec4 weights = vec4((1.0 - w.x) * (1.0 - w.y), w.x * (1.0 - w.y), (1.0 - w.x) * w.y, w.x * w.y);
  vec4 sum = vec4(0.0);
  ivec2 known = ivec2(0x7fffffff);
  int row = -1;
  for (int k = 0; k < 4; k++) {
    if (weights[k] > 0.0) {
      ivec2 at = ivec2(base) + ivec2(k & 1, k >> 1);
      ivec2 over = ivec2(greaterThanEqual(at, ivec2(n))) - ivec2(lessThan(at, ivec2(0)));
      if (cell + over != known) row = rowAt(known = cell + over);
      sum += weights[k] * texel(row, at - over * n, level, n);
    }
  }
  return sum;
}

#ifdef HAS_TONE
// Colors that vary over more than a tile: patches of a small picture around the corners of a triangle of their
// grid, blended so that their variance stays.
vec3 toneAt(vec2 p, Footprint f) {
  float square = float(uSpan * uSide);
  vec2 q = (p + uSquareRest) / square, cell = floor(q), at = q - cell;
  bool far = at.x + at.y > 1.0;
  vec3 weights = far ? vec3(at.x + at.y - 1.0, 1.0 - at.y, 1.0 - at.x) : vec3(1.0 - at.x - at.y, at);
  ivec2 corners[3] = ivec2[3](far ? ivec2(1) : ivec2(0), ivec2(1, 0), ivec2(0, 1));
  vec2 size = vec2(textureSize(uTone, 0));
  float lod = max(0.0, f.lod - log2(uTexel));
  vec3 sum = vec3(0.0);
  for (int k = 0; k < 3; k++) {
    ivec2 point = ivec2(cell) + corners[k];
    uvec2 x = plus(uSquareX, point.x), y = plus(uSquareY, point.y);
    uint place = finish(startRow(uToneState, x.y, y), x.x);
    vec2 middle = vec2((place & 4095u) * uint(size.x) >> 12, (place >> 12) * uint(size.y) >> 12);
    vec2 texel = (at - vec2(corners[k])) * square / uTexel + middle;
    sum += weights[k] * textureLod(uTone, texel / size, lod).rgb;
  }
  return sum / length(weights);
}
#endif

// Beyond the level of one texel per tile many tiles average out towards the mean of the set, half as far for
// each doubling.
vec4 planeColor(vec2 p, Footprint f) {
  vec4 mean = uMean;
  if (uRepeat >= 0) mean = texel(uRepeat, ivec2(0), uTopLevel, 1);
  float keep = uBaked ? 1.0 : f.keep;
  vec4 light = keep < 0.01 ? mean : mix(mean, integrate(p, f), keep);
  vec4 shown = toShown(light);
#ifdef HAS_TONE
  if (uRepeat < 0 && uToned) {
    vec3 mean = shown.a * uToneMean, share = mix(shown.rgb / max(mean, vec3(1e-6)), vec3(1.0), step(mean, shown.rgb));
    shown.rgb = clamp(shown.rgb + share * shown.a * toneAt(p, f), 0.0, shown.a);
  }
#endif
  return shown;
}

vec3 palette(uint c) {
  return 0.55 + 0.45 * cos(6.2832 * (float(c) * 0.618 + vec3(0.02, 0.36, 0.64)));
}

// Lines between tiles, in screen pixels; edges and corners wear the colors that made them meet.
vec3 drawBorders(vec3 shown, vec2 p, vec2 dx, vec2 dy) {
  ivec2 cell;
  vec2 rest;
  divide(p, cell, rest);
  float size = float(uSide);
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
