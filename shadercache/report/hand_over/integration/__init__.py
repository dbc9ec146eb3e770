"""INTEGRATION.md of a variant, section by section."""
