"""The first scene file for a model and a pair of shaders: what can be told by names and types."""
