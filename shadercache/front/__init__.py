"""From source text to syntax tree. One door: ``front.parse.parse(source)``."""
