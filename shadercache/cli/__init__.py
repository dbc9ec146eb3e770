"""The command line, one file per subcommand. The only layer that prints."""
