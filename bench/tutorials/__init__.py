"""How many programs of a tutorial have a value that can be cached, and is exact."""
