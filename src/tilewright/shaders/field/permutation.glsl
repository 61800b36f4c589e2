// A permutation table, looked up with x, then with the sum of what it gave and y (Lagae 2007, eq. 3.3).

uint firstWord(int x, uint digit) { return table.entries[digit * SIZE + uint(x) % SIZE]; }

// A word modulo count where that comes out even, else a number of 24 bits out of several words.
uint lastColor(uint first, int x, int y, uint count) {
  uint row = uint(y) % SIZE;
  uint number = table.entries[(first + row) % SIZE];
#ifdef SEVERAL_WORDS
  if (SIZE % count != 0u) {
    for (uint digit = 1u; digit < DIGITS; digit++) {
      number = number * SIZE + table.entries[digit * SIZE + (firstWord(x, digit) + row) % SIZE];
    }
    return ((number >> SPARE_BITS) * count) >> 24;
  }
#endif
  return number % count;
}

uvec2 rowColors(int first, int last, int y, uint count) {
  return uvec2(lastColor(firstWord(first, 0u), first, y, count), lastColor(firstWord(last, 0u), last, y, count));
}

uvec2 columnColors(int x, int first, int last, uint count) {
  uint word = firstWord(x, 0u);
  return uvec2(lastColor(word, x, first, count), lastColor(word, x, last, count));
}

// Corners NE, SE, SW, NW of the cell whose NW lattice point is given.
uvec4 cornerColors(ivec2 at, uint count) {
  uint west = firstWord(at.x, 0u), east = firstWord(at.x + 1, 0u);
  return uvec4(
    lastColor(east, at.x + 1, at.y, count), lastColor(east, at.x + 1, at.y + 1, count),
    lastColor(west, at.x, at.y + 1, count), lastColor(west, at.x, at.y, count));
}
