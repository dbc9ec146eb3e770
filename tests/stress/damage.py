"""The input that comes by chance: real shaders that are damaged, and noise."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from pathlib import Path

from shadercache.front.preprocess import spellings
from shadercache.front.read_options import Dialect

from .cases import START, Case, Stage

Damage = Callable[[random.Random, list[str]], None]


def _delete(pick: random.Random, words: list[str]) -> None:
    del words[pick.randrange(len(words))]


def _double(pick: random.Random, words: list[str]) -> None:
    at = pick.randrange(len(words))
    words.insert(at, words[at])


def _swap(pick: random.Random, words: list[str]) -> None:
    one, other = pick.randrange(len(words)), pick.randrange(len(words))
    words[one], words[other] = words[other], words[one]


def _exchange(pick: random.Random, words: list[str]) -> None:
    words[pick.randrange(len(words))] = pick.choice(words)


def _cut(pick: random.Random, words: list[str]) -> None:
    del words[pick.randrange(len(words)) :]


DAMAGES: tuple[Damage, ...] = (_delete, _double, _swap, _exchange, _cut)


def random_bytes(pick: random.Random) -> Case:
    """Up to 4 KB of bytes, bare or behind a version."""
    data = pick.randbytes(pick.randrange(1, 4_000))
    text = data.decode(pick.choice(["latin-1", "utf-8"]), "replace")
    return Case("random bytes", pick.choice(["", START]) + text, "damaged")


def damaged(pick: random.Random, path: Path) -> Case:
    """A real shader with one to four words deleted, doubled, swapped or exchanged, or cut off.

    Its directives stay where they are, or most damage would end with the first one.
    """
    lines = path.read_text(encoding="utf-8", errors="replace").splitlines(keepends=True)
    words: list[str] = []
    for line in lines:
        if line.lstrip().startswith("#"):
            words.append("\n" + line.strip() + "\n")
        else:
            words += re.findall(r"//[^\n]*\n?|\w+|\s+|[^\w\s]", line)
    done = []
    for _ in range(pick.randint(1, 4)):
        if words:
            damage = pick.choice(DAMAGES)
            damage(pick, words)
            done.append(damage.__name__.strip("_"))
    text = "".join(words)
    stage: Stage = "vertex" if path.suffix == ".vert" else "fragment"
    dialect: Dialect = "auto" if "mainImage" in text else "glsl"
    return Case(f"{path.name}: {', '.join(done)}", text, "damaged", {}, stage, dialect)


def random_words(pick: random.Random, path: Path) -> Case:
    """Words of a real shader in any order."""
    words = list(spellings(path.read_text(encoding="utf-8", errors="replace"))) or ["x"]
    text = " ".join(pick.choices(words, k=pick.randrange(1, 200)))
    wrap = pick.choice(["{}", "void main() {{ {} }}", "float x = {};"])
    return Case(f"words of {path.name}", START + wrap.format(text), "damaged")
