"""What a made object is made of: a mesh, pictures, a vertex shader where there is none."""
