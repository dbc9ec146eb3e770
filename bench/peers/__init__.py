"""What a user would do in place of caching a value, drawn and timed beside it: ``./dev peers``."""
