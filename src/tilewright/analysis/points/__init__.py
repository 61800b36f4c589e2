"""Figures about points: spacing, spectra, comparisons (Lagae 2007, chapter 6)."""
