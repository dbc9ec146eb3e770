"""How payloads are cached: configurations, algorithms, and the slots with their ``.glsl`` files."""
