"""Tables of the language: types, built-in functions and variables, operators, words."""
