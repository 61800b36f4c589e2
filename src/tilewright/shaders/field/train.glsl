// Where an ordered pair of colors stands in Wei's train (Wei 2004; Lagae 2007, section 5.5.1).

uint trainPosition(uint a, uint b) {
  if (b > a) return b * b + 2u * a;
  uint after = (a + 1u) * (a + 1u);
  if (a == b) return a == 0u ? 0u : after - 2u;
  return b > 0u ? a * a + 2u * b - 1u : after - 1u;
}
