"""Experiments and measurements beside the package; each is started by a verb of ``./dev``."""
