"""What a shader needs of a lattice hash: start states or a table, and where a block's cells lie."""

import struct
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError
from tilewright.tilings import LatticeHash, MixerHash, PermutationHash
from tilewright.tilings.hashes import MULTIPLIERS
from tilewright.tilings.streams import COLORS, digits_of

_WORD = 2**32
_NEAR = 2**30
"""Lattice points from a block's own cell in which all that it sees lies."""
_NO_STATES = np.zeros((2, 4), np.uint32)


class ShaderHash(Protocol):
    """A hash as a shader evaluates it."""

    defines: dict[str, str]
    part: str

    def place(self, x: int, y: int, stream: int = 0) -> tuple[NDArray[np.uint32], tuple[int, int]]:
        """Start states (2, 4) and the lattice point in the shader's integers, for a block at (x, y)."""

    def table(self) -> NDArray[np.uint32]:
        """Entries of the permutation; none for the mixer."""


def shader_hash(
    hash: LatticeHash, counts: tuple[int, ...], variants: int = 1, *, tone: bool = False
) -> ShaderHash:
    """The shader's form of a hash that gives ``counts`` colors, draws among variants and lays tone."""
    if isinstance(hash, MixerHash):
        return _Mixer(hash)
    if variants > 1 or tone:
        what = "variants are drawn" if variants > 1 else "tone is laid"
        raise TilewrightValueError(
            f"the tiling's hash is {hash.name}; on a GPU {what} by the mixer",
            value=hash.name,
            advice="use direct(tiles, seed)",
        )
    if isinstance(hash, PermutationHash):
        return _Permutation(hash, counts)
    raise TilewrightValueError(
        f"the tiling's hash is {hash.name}; on a GPU there are mixer and permutation: direct(tiles, seed)"
    )


class _Mixer:
    part = "mixer.glsl"

    def __init__(self, hash: MixerHash) -> None:
        self.defines = {f"MULTIPLIER_{n}": f"{m}u" for n, m in enumerate(MULTIPLIERS, 1)}
        self._hash = hash

    def table(self) -> NDArray[np.uint32]:
        """Nothing: this hash has no table."""
        return np.empty(0, np.uint32)

    def place(self, x: int, y: int, stream: int = 0) -> tuple[NDArray[np.uint32], tuple[int, int]]:
        """Start states for both signs of x and y.

        Coordinates become 32-bit integers whose sign tells the high word: within a block it changes at most
        once along each axis, at a multiple of 2^32. Where none is near, both signs stand for one high word.
        """
        (low_x, high_x), (low_y, high_y) = _split(x), _split(y)
        states = [
            [word for y_high in high_y for word in self._hash.start(x_high, y_high, stream)]
            for x_high in reversed(high_x)
        ]
        return np.array(states, np.uint32), (low_x, low_y)


def _split(coordinate: int) -> tuple[int, tuple[int, int]]:
    """A signed low word, and the high words where that is 0 or more and where it is less."""
    low = (coordinate + _WORD // 2) % _WORD - _WORD // 2
    if abs(low) > _NEAR:
        return low, (coordinate // _WORD,) * 2
    high = (coordinate - low) // _WORD
    return low, (high, high - 1)


class _Permutation:
    part = "permutation.glsl"

    def __init__(self, hash: PermutationHash, counts: tuple[int, ...]) -> None:
        if not hash.nested:
            raise TilewrightValueError(
                "the tiling's hash has nested=False; on a GPU the table is looked up once more with what it "
                "gave: use PermutationHash(seed, size)"
            )
        self._hash = hash
        self._digits, spare = 1, 0
        if any(hash.size % count for count in counts):
            bits = hash.size.bit_length() - 1
            self._digits = -(-24 // bits)
            spare = self._digits * bits - 24
            if hash.size & (hash.size - 1) or spare > 8:
                most = max(counts)
                raise TilewrightValueError(
                    f"the tiling's permutation table has {hash.size} entries; for {most} colors on a GPU its "
                    f"size must be a multiple of {most} or a power of two other than 2048"
                )
        self.defines = {"SIZE": f"{hash.size}u", "DIGITS": f"{self._digits}u", "SPARE_BITS": f"{spare}u"}
        if self._digits > 1:
            self.defines["SEVERAL_WORDS"] = ""

    def table(self) -> NDArray[np.uint32]:
        """A permutation for each word that makes a color."""
        streams = digits_of(COLORS, self._digits)
        return np.concatenate([self._hash.table(stream) for stream in streams]).astype(np.uint32)

    def place(self, x: int, y: int, stream: int = 0) -> tuple[NDArray[np.uint32], tuple[int, int]]:
        """Coordinates modulo the table's size, moved so that a block has no negative ones."""
        size = self._hash.size
        ahead = _NEAR // size * size
        return np.zeros((2, 4), np.uint32), (x % size + ahead, y % size + ahead)


VIEW_BYTES = 192


class ToneView(NamedTuple):
    """Where a tone's grid lies: start states, the square that holds cell (0, 0), tiles from its corner."""

    states: NDArray[np.uint32] = _NO_STATES
    square: tuple[int, int] = (0, 0)
    rest: tuple[int, int] = (0, 0)


def view_bytes(
    rows: NDArray[Any],
    states: NDArray[np.uint32],
    origin: tuple[int, int],
    draws: NDArray[np.uint32] = _NO_STATES,
    cell: tuple[int, int] = (0, 0),
    place: int = 0,
    tone: ToneView = ToneView(),  # noqa: B008  # a tuple
) -> bytes:
    """The uniform block ``View`` of ``view.glsl``; ``draws`` and ``cell`` are for variants.

    ``place`` is the class of the lattice point of cell (0, 0), where points have classes.
    """
    packed = np.zeros((3, 4), np.float32)
    packed[:, :3] = rows
    packed[0, 3] = place
    # The shader's ``west`` is for x < 0.
    laid = tone.states.tobytes() + struct.pack("4i4f", *tone.square, 0, 0, *tone.rest, 0, 0)
    return packed.tobytes() + states.tobytes() + struct.pack("4i", *origin, *cell) + draws.tobytes() + laid
