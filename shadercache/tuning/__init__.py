"""Choosing for the user: models of time and error, search, and proof on frames not seen before."""
