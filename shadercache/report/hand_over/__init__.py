"""A chosen variant as a folder that an engine programmer can work from: shaders and manifests,
INTEGRATION.md written for that very variant, and a runnable example of it."""
