"""A runnable example of a variant: its code, and the data that it draws."""
