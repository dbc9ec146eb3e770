"""Models that others made: glTF with its skins, morphs and animations, and OBJ, PLY, STL."""
