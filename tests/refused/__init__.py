"""How much of a shader's cost cannot be cached, for which reasons."""
