"""Older versions of the language, in words of the first that has what it takes."""
