"""Make docs/images/surfaces.png: points of tiles as they are, evened out, and with more chance."""

import sys
from pathlib import Path

import numpy as np

import tilewright as tw

TARGET = Path(__file__).parents[1] / "docs" / "images" / "surfaces.png"
COUNT = 2500


def knot(around: int = 160, across: int = 12) -> tw.Mesh:
    """A tube of quads along a trefoil knot."""
    t = 2 * np.pi * np.arange(around) / around
    middle = np.stack([np.sin(t) + 2 * np.sin(2 * t), np.cos(t) - 2 * np.cos(2 * t), -np.sin(3 * t)], axis=1)
    along = np.roll(middle, -1, axis=0) - np.roll(middle, 1, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    # The frame is carried along, and what it lacks of a whole turn at the end is spread over the way.
    side = np.zeros_like(middle)
    side[0] = np.cross(along[0], (0, 0, 1))
    for i in range(1, around):
        side[i] = side[i - 1] - along[i] * (side[i - 1] @ along[i])
    side /= np.linalg.norm(side, axis=1, keepdims=True)
    last = side[-1] - along[0] * (side[-1] @ along[0])
    up = np.cross(along[0], side[0])
    lack = np.arctan2(last @ up, last @ side[0])
    other = np.cross(along, side)
    angle = 2 * np.pi * np.arange(across) / across - lack * np.arange(around)[:, np.newaxis] / around
    ring = (
        np.cos(angle)[..., np.newaxis] * side[:, np.newaxis]
        + np.sin(angle)[..., np.newaxis] * other[:, np.newaxis]
    )
    vertices = (middle[:, np.newaxis] + 0.55 * ring).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(around), np.arange(across), indexing="ij")
    corners = [
        ((i + a) % around * across + (j + b) % across).ravel() for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))
    ]
    return tw.Mesh.of(vertices, np.stack(corners, axis=1))


def main() -> None:
    """Draw the kinds side by side."""
    mesh = knot()
    parts = []
    for kind in ("tiles", "even", "poisson"):
        points = tw.surface_points(mesh, COUNT, kind=kind, seed=1)
        parts.append(tw.draw_surface(points.surface, points.spots, width=640, height=640, view=(0, 89)))
    parts = [part[160:480] for part in parts]
    tw.write_image(sys.argv[1] if len(sys.argv) > 1 else TARGET, np.concatenate(parts, axis=1))


if __name__ == "__main__":
    main()
