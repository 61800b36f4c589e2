"""What any GPU must know of a tiling: lookup, hash states, layouts, mip levels, templates."""
