"""Scene files: cameras, motion, meshes and inputs as plain values. No OpenGL."""
