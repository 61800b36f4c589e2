"""Figures about textures: seams, repetition, structure."""
