"""``python -m bench.papers``: see :mod:`bench.papers.suite`."""

from bench.papers.suite import main

raise SystemExit(main())
