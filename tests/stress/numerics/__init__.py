"""The numerical stress tests S1 to S20, one file for each: ``test_sNN_what.py``.

Each test takes the fixture ``stress`` and says through it what it measured and what it demands, so
that ``./dev stress`` can print a table. ``stress.deep`` is true there; ``./dev test`` runs the
short form.
"""
