// Small tables: permutations for the hash, then places of tiles in the packing.

layout(std430, set = 0, binding = 2) readonly buffer Table { uint entries[]; } table;
