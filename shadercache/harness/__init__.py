"""Rendering and measuring. moderngl is imported here and nowhere else."""
