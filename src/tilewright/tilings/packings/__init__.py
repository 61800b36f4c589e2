"""Tile packings: every tile of a complete set once, on a torus, neighbors matching."""
