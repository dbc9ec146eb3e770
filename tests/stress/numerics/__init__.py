"""The cache under numerical stress: one file for each test of ``./dev stress`` that is about it."""
