"""Endless tilings by aperiodic sets, evaluated anywhere."""

from tilewright.tilings.aperiodic.endless import aperiodic_tiling
from tilewright.tilings.aperiodic.translated import TranslatedTiling, translated_tiling

__all__ = ["TranslatedTiling", "aperiodic_tiling", "translated_tiling"]
