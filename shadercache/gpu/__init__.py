"""moderngl: context, programs, textures, targets, clock."""
