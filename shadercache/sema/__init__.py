"""What names mean and which type every expression has."""
