"""Image errors as libraries have them, and what an RMSE hides: one family a file."""
