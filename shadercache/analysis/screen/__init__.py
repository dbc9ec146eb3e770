"""What binds a value to its place on the screen."""
