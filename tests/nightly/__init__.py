"""The tests that draw what they try, with another seed each day."""
