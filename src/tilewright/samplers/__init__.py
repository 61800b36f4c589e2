"""Point-set methods without tiles; empty until the points come."""
