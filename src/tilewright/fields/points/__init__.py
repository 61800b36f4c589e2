"""Points over a tiling."""
