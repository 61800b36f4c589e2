"""The default lattice hash written out word by word, as docs/hashes.md states it."""

MASK = 0xFFFFFFFF


def mix(h):
    h ^= h >> 16
    h = h * 0x21F0AAAD & MASK
    h ^= h >> 15
    h = h * 0xD35A2D97 & MASK
    return h ^ h >> 15


def mixer(stream, seed, x, y=0, z=0):
    a, b = 0x243F6A88, 0x85A308D3
    words = (stream, seed, seed >> 32, z, z >> 32, x >> 32, y >> 32, y)
    for word in words:
        a = mix(a ^ word & MASK)
        b = mix((b ^ a) + word & MASK)
    h = x & MASK ^ a
    h ^= h >> 16
    h = (h * 0x21F0AAAD + b) & MASK
    h ^= h >> 15
    h = h * 0xD35A2D97 & MASK
    return h ^ h >> 15
