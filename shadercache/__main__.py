"""``python -m shadercache``: the command line without the console script."""

from __future__ import annotations

from shadercache.cli.app import run

if __name__ == "__main__":
    run()
