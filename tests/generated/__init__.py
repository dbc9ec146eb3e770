"""Shaders written at random, and the laws on them."""
