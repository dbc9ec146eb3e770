"""The page of a tuning: errors and times of all values, with a slider for the bound."""
