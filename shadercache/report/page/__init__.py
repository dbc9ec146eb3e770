"""One page that shows a result store: a file that needs no network."""
