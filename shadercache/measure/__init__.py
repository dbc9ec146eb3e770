"""What is drawn in turns: times, hit rates and image errors."""
