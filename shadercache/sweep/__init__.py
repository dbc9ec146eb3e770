"""Sweeps: plans of trials, carried out by workers, kept in a result store."""
