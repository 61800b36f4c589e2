"""Figures about results: seams, repetition, structure."""

from tilewright.analysis.report import MEANING, Report, analyze
from tilewright.analysis.sample import Sample, lay_sample

__all__ = ["MEANING", "Report", "Sample", "analyze", "lay_sample"]
