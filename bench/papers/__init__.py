"""The papers' experiments on this machine: one file each, and a verdict for every claim."""
