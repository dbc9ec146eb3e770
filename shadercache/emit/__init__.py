"""From a module and a node to the programs of a variant, as text."""
