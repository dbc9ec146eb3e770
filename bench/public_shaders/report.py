"""The figures of a collection, and what fails in it."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from bench.public_shaders.drawing import Picture
from bench.public_shaders.judge import Verdict
from bench.public_shaders.reading import Outcome
from bench.public_shaders.shaders import Shader
from shadercache.cli.tables import format_table

_NAME = re.compile(r"'[^']*'|\d+")

# Column of the table: what is counted, and out of what.
_SHARES = {
    "accepted": ("accepted", "valid"),
    "typed": ("typed", "valid"),
    "taken again": ("taken again", "valid"),
    "by glslang": ("taken again by glslang", "valid"),
    "stable": ("stable", "valid"),
    "all of it": ("all of it", "valid"),
    "same image": ("same image", "drawn"),
    "rejected": ("rejected", "invalid"),
    "same line": ("same line", "rejected with a line"),
}
_COUNTS = ("shaders", "valid", "drawn", "invalid")


@dataclass(frozen=True, slots=True)
class Row:
    """One shader with all that is known of it.

    ``typing`` tells where glslang has other types, ``reread`` is its word on our print, and
    ``picture`` what became of drawing both texts.
    """

    shader: Shader
    verdict: Verdict
    outcome: Outcome
    typing: str = ""
    reread: Verdict | None = None
    picture: Picture | None = None

    @property
    def failure(self) -> tuple[str, str] | None:
        """What is wrong with what we did, and the words for it; ``None`` if nothing is."""
        verdict, outcome = self.verdict, self.outcome
        if not outcome.accepted and not outcome.code.startswith("SC"):
            return f"TRACEBACK {outcome.code}", outcome.message
        if not verdict.accepted:
            return ("we take what glslang rejects", verdict.message) if outcome.accepted else None
        if not outcome.accepted:
            return outcome.code, outcome.message
        if self.typing:
            return "types", self.typing
        if outcome.again:
            return "our print is rejected by us", outcome.again
        if self.reread is not None and not self.reread.accepted:
            return "our print is rejected by glslang", self.reread.message
        if self.picture is not None and self.picture.same is False:
            return "our print renders another image", self.picture.why
        return None if outcome.stable else ("printed again, the text is another", "")


def figures(rows: Sequence[Row]) -> dict[str, int]:
    """Counts: of valid shaders those from ``accepted`` to ``not drawn``, then of the others.

    ``drawn`` are the fragment shaders that the driver takes with a plain vertex shader; ``varied``
    those of them whose image has more than one colour.
    """
    valid = [row for row in rows if row.verdict.accepted]
    invalid = [row for row in rows if not row.verdict.accepted]
    accepted = [row for row in valid if row.outcome.accepted]
    rejected = [row for row in invalid if not row.outcome.accepted]
    pictures = [row.picture for row in valid if row.picture is not None]
    located = [row for row in rejected if row.verdict.line]
    return {
        "shaders": len(rows),
        "valid": len(valid),
        "accepted": len(accepted),
        "typed": sum(not row.typing for row in accepted),
        "taken again": sum(not row.outcome.again for row in accepted),
        "taken again by glslang": sum(row.reread is not None and row.reread[0] for row in accepted),
        "stable": sum(row.outcome.stable for row in accepted),
        "all of it": sum(row.failure is None for row in valid),
        "drawn": sum(picture.same is not None for picture in pictures),
        "same image": sum(picture.same is True for picture in pictures),
        "varied": sum(picture.varied for picture in pictures),
        "not drawn": sum(picture.same is None for picture in pictures),
        "invalid": len(invalid),
        "rejected": len(rejected),
        "rejected with a line": len(located),
        "same line": sum(row.verdict.line == row.outcome.line for row in located),
    }


def table(collections: Mapping[str, Mapping[str, int]]) -> str:
    """The figures as text, one line for each collection."""
    head = ("collection", *_COUNTS, *_SHARES)
    rows = [
        (
            name,
            *(str(counts[key]) for key in _COUNTS),
            *(_share(counts[part], counts[whole]) for part, whole in _SHARES.values()),
        )
        for name, counts in collections.items()
    ]
    return format_table(head, rows, right=" ".join(_COUNTS))


def _share(part: int, whole: int) -> str:
    return f"{100 * part / whole:.2f} %" if whole else "-"


def failures(rows: Sequence[Row]) -> dict[str, list[Row]]:
    """The rows where something is wrong, by what it is, the largest group first."""
    groups: dict[str, list[Row]] = {}
    for row in rows:
        if row.failure is not None:
            title = ": ".join(row.failure)
            groups.setdefault(_NAME.sub("…", title).removesuffix(": "), []).append(row)
        elif not row.verdict.accepted and row.verdict.line not in (0, row.outcome.line):
            groups.setdefault("rejected by both, but at another line", []).append(row)
    return dict(sorted(groups.items(), key=lambda item: -len(item[1])))


def to_json(rows: Sequence[Row]) -> dict[str, Any]:
    """All figures, why shaders were not drawn, and the failures with their places and words."""
    pictures = [row.picture for row in rows if row.picture is not None]
    reasons = [_NAME.sub("…", picture.why) for picture in pictures if picture.same is None]
    return {
        "figures": figures(rows),
        "not drawn": dict(Counter(reasons).most_common()),
        "failures": {title: list(map(_example, group)) for title, group in failures(rows).items()},
    }


def _example(row: Row) -> str:
    return " | ".join((f"{row.shader.file}:{row.outcome.line or row.verdict.line}", *_words(row)))


def _words(row: Row) -> Iterator[str]:
    if row.failure is not None:
        yield row.failure[1]
    if row.outcome.code:
        yield f"{row.outcome.code} {row.outcome.message}"
    if not row.verdict.accepted:
        yield f"glslang {row.verdict.line}: {row.verdict.message}"
