"""The syntax tree: node classes, walking, rewriting."""
