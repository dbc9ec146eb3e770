"""Where compiler and renderer meet: the shaders of a scene become bundles."""
