"""A plane from a photograph without tiles, and five methods side by side."""
