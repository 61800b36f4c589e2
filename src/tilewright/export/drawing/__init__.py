"""Line drawings of tile sets, tilings, walls and puzzles, as SVG."""
