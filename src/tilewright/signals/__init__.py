"""What a tile holds."""
