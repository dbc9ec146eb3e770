"""The laws on this machine's driver."""
