"""Make the vectors that move Penrose points again, the table in the package; it takes minutes."""

from pathlib import Path

import numpy as np

from penrose_relaxation import relax_vectors

TARGET = Path(__file__).parents[1] / "src" / "tilewright" / "samplers" / "penrose_vectors.npy"


def main() -> None:
    """Relax and save."""
    np.save(TARGET, relax_vectors(progress=say).astype(np.float32))
    print(TARGET)


def say(done: int, total: int, what: str) -> None:
    """How far it is."""
    print(f"{what}: {done} of {total}", flush=True)


if __name__ == "__main__":
    main()
