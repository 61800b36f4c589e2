"""Walls of bricks, evaluated anywhere."""
