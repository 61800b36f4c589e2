"""Compiled loops: arrays in, arrays out; one file per family. The only room that imports numba."""
