"""How nodes are shown: in one look, and as JSON."""
