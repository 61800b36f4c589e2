// What the CPU says of the picture: the rows of the camera's homography, and where its cells lie.

layout(set = 0, binding = 0) uniform View {
  vec4 x, y, w;      // x.w: class of the lattice point of cell (0, 0)
  uvec4 west, east;  // start of the hash for x < 0 and x >= 0: two words for y >= 0, two for y < 0
  ivec4 origin;      // lattice point of cell (0, 0); that cell as variants are drawn for it
  uvec4 drawWest, drawEast;  // start of the hash that draws variants
  uvec4 toneWest, toneEast;  // start of the hash that lays tone
  ivec4 square;              // square of the tone's grid that holds cell (0, 0)
  vec4 rest;                 // tiles from that square's corner to the cell
} view;
layout(set = 0, binding = 1) uniform sampler filtering;
