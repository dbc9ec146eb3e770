"""What values cost, alone and together."""
