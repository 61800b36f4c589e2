"""Figures and pictures of points on surfaces: spacing in space and on the surface, holes, evenness."""
