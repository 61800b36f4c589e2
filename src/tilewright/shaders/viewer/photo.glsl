// The plane from one photograph without tiles: repeated, or blended from patches on a triangle grid, as
// tilewright.fields.RepeatField, HexField and NoiseField.

uniform sampler2DArray uPhoto;   // one layer: the photograph, or its Gaussian values
uniform sampler2D uInverse;      // color along each axis of a Gaussian value (x), for each mip level (y)
uniform ivec2 uPhotoSize;
uniform vec2 uStart;             // of the origin, from the corner of its photograph or vertex
uniform uvec2 uVertexX, uVertexY;  // that vertex
uniform uvec2 uPatchX, uPatchY;  // hash states of the middles of patches
uniform ivec4 uPatchRange;       // first column, columns, first row, rows that a middle may have
uniform ivec2 uGrid;             // texels along an edge of the triangle grid, and between its rows
uniform mat3 uAxes;              // color = uAverage + uAxes * value
uniform vec3 uAverage;

int fold(int i, int n) {
#ifdef PHOTO_REPEAT
  return i - n * int(floor(float(i) / float(n)));
#else
  i -= 2 * n * int(floor(float(i) / float(2 * n)));
  return i < n ? i : 2 * n - 1 - i;
#endif
}

vec4 sampleLevel(vec2 p, int level, float sharp) {
  ivec2 n = max(uPhotoSize >> level, 1);
  vec2 q = p * vec2(n) / vec2(uPhotoSize) - 0.5;
  vec2 base = floor(q);
  vec2 w = clamp((q - base - 0.5) * sharp + 0.5, 0.0, 1.0);
  vec4 weights = vec4((1.0 - w.x) * (1.0 - w.y), w.x * (1.0 - w.y), (1.0 - w.x) * w.y, w.x * w.y);
  vec4 sum = vec4(0.0);
  for (int k = 0; k < 4; k++) {
    if (weights[k] > 0.0) {
      ivec2 at = ivec2(base) + ivec2(k & 1, k >> 1);
      sum += weights[k] * texelFetch(uPhoto, ivec3(fold(at.x, n.x), fold(at.y, n.y), 0), level);
    }
  }
  return sum;
}

#ifdef PHOTO_REPEAT
vec4 planeColor(vec2 p, Footprint f) {
  return toShown(f.keep < 0.01 ? uMean : mix(uMean, integrate(p + uStart, f), f.keep));
}

vec3 drawBorders(vec3 shown, vec2 p, vec2 dx, vec2 dy) {
  vec2 size = vec2(uPhotoSize), rest = mod(p + uStart, size), gap = min(rest, size - rest);
  gap /= max(vec2(length(vec2(dx.x, dy.x)), length(vec2(dx.y, dy.y))), 1e-6) * uPixelRatio;
  float edge = min(gap.x, gap.y);
  return mix(mix(shown, vec3(0.0), 0.4 * cover(edge, 1.5)), vec3(1.0), 0.8 * cover(edge, 0.5));
}
#else
// A point in a triangle of the grid: its weight at each vertex, and where each vertex's patch has it.
struct Blend { vec3 weights; vec2 places[3]; };

// floor(number * count / 2^24) of a number of 24 bits, in 32-bit steps.
int scale(uint number, int count) {
  uint c = uint(count);
  return int(((number >> 12) * c + (((number & 4095u) * c) >> 12)) >> 12);
}

vec2 patchMiddle(ivec2 vertex) {
  uvec2 x = plus(uVertexX, vertex.x), y = plus(uVertexY, vertex.y);
  return vec2(
    uPatchRange.x + scale(finish(startRow(uPatchX, x.y, y), x.x), uPatchRange.y),
    uPatchRange.z + scale(finish(startRow(uPatchY, x.y, y), x.x), uPatchRange.w));
}

vec3 barycentric(vec2 local, out ivec2 cell, out bool upper) {
  vec2 grid = vec2(uGrid);
  float v = local.y / grid.y, u = local.x / grid.x - 0.5 * v;
  cell = ivec2(floor(vec2(u, v)));
  u -= float(cell.x);
  v -= float(cell.y);
  upper = u + v > 1.0;
  return upper ? vec3(u + v - 1.0, 1.0 - v, 1.0 - u) : vec3(1.0 - u - v, u, v);
}

Blend blendAt(vec2 p) {
  Blend b;
  vec2 local = p + uStart;
  ivec2 cell;
  bool upper;
  b.weights = max(barycentric(local, cell, upper), 0.0);
  for (int k = 0; k < 3; k++) {
    ivec2 vertex = cell + (k == 0 ? ivec2(upper) : ivec2(k == 1, k == 2));
    vec2 at = vec2(vertex.x * uGrid.x + vertex.y * (uGrid.x / 2), vertex.y * uGrid.y);
    b.places[k] = local - at + patchMiddle(vertex);
  }
  return b;
}

#ifdef PHOTO_HEX
// Mikkelsen 2022: the seventh power of the weight, times the patch's luminance mixed with 1.
vec4 planeColor(vec2 p, Footprint f) {
  if (f.keep < 0.01) return toShown(uMean);
  Blend b = blendAt(p);
  vec3 w = pow(b.weights, vec3(7.0));
  vec4 patches[3];
  for (int k = 0; k < 3; k++) {
    patches[k] = integrate(b.places[k], f);
    w[k] *= mix(1.0, dot(patches[k].rgb, vec3(0.299, 0.587, 0.114)), 0.6);
  }
  w /= w.x + w.y + w.z;
  return toShown(mix(uMean, w.x * patches[0] + w.y * patches[1] + w.z * patches[2], f.keep));
}
#else
vec3 restore(vec3 gauss, int level) {
  vec3 at = clamp(gauss, 0.0, 1.0) * float(textureSize(uInverse, 0).x - 1), value;
  for (int c = 0; c < 3; c++) {
    int low = min(int(at[c]), textureSize(uInverse, 0).x - 2);
    float here = texelFetch(uInverse, ivec2(low, level), 0)[c];
    value[c] = mix(here, texelFetch(uInverse, ivec2(low + 1, level), 0)[c], at[c] - float(low));
  }
  return value;
}

// Heitz & Neyret 2018 after Deliot & Heitz 2019: Gaussian values blended so that their variance stays, and the
// way back to colors from the table of the pixel's mip level.
vec4 planeColor(vec2 p, Footprint f) {
  vec3 average = clamp(uAverage + uAxes * restore(vec3(0.5), uTopLevel), 0.0, 1.0);
  if (f.keep < 0.01) return vec4(average, 1.0);
  Blend b = blendAt(p);
  vec3 sum = vec3(0.0);
  for (int k = 0; k < 3; k++) sum += b.weights[k] * (integrate(b.places[k], f).rgb - 0.5);
  vec3 gauss = sum / length(b.weights) + 0.5;
  int level = min(int(f.lod), uTopLevel - 1);
  vec3 value = mix(restore(gauss, level), restore(gauss, level + 1), f.lod - float(level));
  vec3 shown = clamp(uAverage + uAxes * value, 0.0, 1.0);
  return vec4(mix(average, shown, f.keep), 1.0);
}
#endif

// The triangle grid.
vec3 drawBorders(vec3 shown, vec2 p, vec2 dx, vec2 dy) {
  ivec2 cell;
  bool upper;
  vec3 weights = barycentric(p + uStart, cell, upper);
  float texels = min(weights.x, min(weights.y, weights.z)) * float(uGrid.y);
  float edge = texels / max(sqrt(abs(dx.x * dy.y - dx.y * dy.x)), 1e-6) / uPixelRatio;
  return mix(mix(shown, vec3(0.0), 0.4 * cover(edge, 1.5)), vec3(1.0), 0.8 * cover(edge, 0.5));
}
#endif
