"""What can be chosen about a cache: one value names one configuration."""
