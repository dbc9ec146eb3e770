"""The manifest: everything an engine must know to run the variants; a typed model of it."""
