"""The rules of the language that only reject: nothing else depends on them."""
