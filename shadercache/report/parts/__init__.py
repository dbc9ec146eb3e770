"""What the pages have in common: their style, scripts for plots, pictures and code, one file."""
