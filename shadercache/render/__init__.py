"""Draws the objects of a scene, whole frames of the original or of a variant. Compiles nothing."""
