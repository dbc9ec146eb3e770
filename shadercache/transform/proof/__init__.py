"""Proof mode: what keeps a driver from rearranging and foreseeing."""
