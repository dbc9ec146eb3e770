"""Immutable side tables about a checked module: effects, dependence, cost, nodes."""
