"""Threads of a process that has not parsed yet may all begin at once."""

from __future__ import annotations

import subprocess
import sys

PROGRAM = """
from concurrent.futures import ThreadPoolExecutor
from threading import Barrier
from shadercache.front.parse import parse
from shadercache.source import Source

together = Barrier(8)

def read(number):
    together.wait()
    return len(parse(Source("test", "#version 330\\nvoid main() { }")).decls)

with ThreadPoolExecutor(8) as threads:
    assert sum(threads.map(read, range(8))) == 8
"""


def test_the_first_parse_in_many_threads() -> None:
    subprocess.run([sys.executable, "-c", PROGRAM], check=True, timeout=60)
