"""Rewrites of the syntax tree, one per file. Each takes a tree and returns a new one."""
