#version 300 es
// A pixel of the endless plane. Positions are texels counted from the origin cell, which is a 64-bit
// integer: the view never runs out of digits. The picture is that of one endless texture with box-filtered
// mip levels; what it shows is added below: tiles.glsl or photo.glsl.
precision highp float;
precision highp int;
precision highp sampler2DArray;
precision highp usampler2D;

uniform int uSide, uTopLevel;    // texels of a tile or along the photograph; level of one texel
uniform vec4 uMean;              // of all that is shown, as stored in level uTopLevel
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

// What a pixel covers: `count` samples along `axis`, the two mip levels around their size and the share of
// the second, and how much is seen beyond the level of one texel.
struct Footprint { int count; vec2 axis; int level; float blend; float lod; float keep; float sharp; };

// What is shown: color, multiplied by alpha, of a pixel; one mip level of it; lines where its parts meet.
vec4 planeColor(vec2 p, Footprint f);
vec4 sampleLevel(vec2 p, int level, float sharp);
vec3 drawBorders(vec3 shown, vec2 p, vec2 dx, vec2 dy);

// log2 of a level's texel size; tiles that are no power of two have odd steps.
float levelSize(int level) { return log2(float(uSide) / float(uSide >> level)); }

// The footprint spanned by dx and dy: up to 16 samples along its longer axis.
Footprint measure(vec2 dx, vec2 dy) {
  Footprint f;
  float a = dot(dx, dx), b = dot(dy, dy), c = dx.x * dy.y - dx.y * dy.x;
  float root = sqrt(max((a + b) * (a + b) - 4.0 * c * c, 0.0));
  float major = sqrt(0.5 * (a + b + root)), minor = max(abs(c) / major, 1.0);
  f.count = clamp(int(ceil(major / minor - 0.02)), 1, 16);
  f.sharp = mix(1.0, 1.0 / major, smoothstep(2.0, 6.0, 1.0 / major));

  // The two levels, the share of the second, and what is left beyond the last.
  float last = levelSize(uTopLevel), lod = max(0.0, log2(major / float(f.count)));
  f.keep = exp2(min(0.0, last - lod));
  lod = min(lod, last);
  f.level = max(0, min(int(lod), uTopLevel - 1));
  if (levelSize(f.level) > lod) f.level--;
  float low = levelSize(f.level), high = levelSize(f.level + 1);
  f.blend = (lod - low) / (high - low);
  f.lod = min(max(0.0, 0.5 * log2(major * minor)), last);

  // The longer axis of the ellipse: eigenvector of dx dx' + dy dy'.
  f.axis = vec2(0.0);
  if (f.count > 1) {
    float xx = dx.x * dx.x + dy.x * dy.x, xy = dx.x * dx.y + dy.x * dy.y;
    f.axis = vec2(major * major - (a + b - xx), xy);
    float size = length(f.axis);
    f.axis = size < 1e-6 * major * major ? vec2(0.0, major) : f.axis * (major / size);
  }
  return f;
}

// Mean over a footprint around p.
vec4 integrate(vec2 p, Footprint f) {
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 2 * f.count; i++) {
    bool second = i >= f.count;
    float share = second ? f.blend : 1.0 - f.blend;
    if (share > 0.0) {
      float along = (float(second ? i - f.count : i) + 0.5) / float(f.count) - 0.5;
      sum += share * sampleLevel(p + f.axis * along, second ? f.level + 1 : f.level, f.sharp);
    }
  }
  return sum / float(f.count);
}

// What is filtered (color multiplied by alpha, linear where light) as it is shown, multiplied by alpha.
vec4 toShown(vec4 light) {
  vec3 c = light.rgb / max(light.a, 1e-6);
  vec3 curve = mix(12.92 * c, 1.055 * pow(max(c, 0.0031308), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
  return vec4(light.a * (uEncode ? curve : c), light.a);
}

float cover(float distance, float halfWidth) { return clamp(halfWidth + 0.5 - distance, 0.0, 1.0); }

// SOURCE

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

  vec4 seen = planeColor(p, measure(dx, dy));
  vec3 shown = seen.rgb + (1.0 - seen.a) * uBackdrop;
  if (uBorders) shown = drawBorders(shown, p, dx, dy);
  color = vec4(mix(uSky, shown, ground), 1.0);
}
