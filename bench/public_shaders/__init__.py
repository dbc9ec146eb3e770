"""Acceptance of public shaders, measured by ``./dev corpus``."""
