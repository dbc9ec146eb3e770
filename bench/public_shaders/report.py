"""The figures of a collection, and its failures in groups."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from bench.public_shaders.acceptance import Outcome
from bench.public_shaders.collection import Shader
from bench.public_shaders.glslang import Verdict
from bench.public_shaders.rendering import Picture

_NAME = re.compile(r"'[^']*'|\d+")
_EXTENSION = re.compile(r"^\s*#\s*extension\s+(GL_\w+)\s*:\s*(?:enable|require)", re.MULTILINE)
_VERSION = re.compile(r"^\s*#\s*version\s+(\d+(?:[ \t]+\w+)?)", re.MULTILINE)


HEAD = (
    *("collection", "shaders", "valid", "accepted", "typed", "taken again", "by glslang", "stable"),
    *("all of it", "drawn", "same image", "invalid", "rejected", "same line"),
)


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
    def failure(self) -> str | None:
        """What is wrong with what we did, as the heading of a group; ``None`` if nothing is."""
        verdict, outcome = self.verdict, self.outcome
        if not outcome.accepted and not outcome.code.startswith("SC"):
            return f"TRACEBACK {outcome.code}: {outcome.message}"
        if not verdict.accepted:
            shown = _NAME.sub("'…'", verdict.message)
            return f"we take what glslang rejects: {shown}" if outcome.accepted else None
        if not outcome.accepted:
            return f"{outcome.code} {_NAME.sub('…', outcome.message)}"
        if self.typing:
            return f"types: {_NAME.sub('…', self.typing)}"
        if outcome.again:
            return f"our print is rejected by us: {_NAME.sub('…', outcome.again)}"
        if self.reread is not None and not self.reread.accepted:
            return f"our print is rejected by glslang: {_NAME.sub('…', self.reread.message)}"
        if self.picture is not None and self.picture.same is False:
            return f"our print renders another image: {_NAME.sub('…', self.picture.why)}"
        return None if outcome.stable else "printed again, the text is another"


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


def table(collections: dict[str, dict[str, int]]) -> str:
    """The figures as text, one line for each collection."""
    lines = [HEAD, *(_line(name, counts) for name, counts in collections.items())]
    widths = [max(len(line[at]) for line in lines) for at in range(len(HEAD))]
    return "\n".join(
        "  ".join(cell.rjust(width) if at else cell.ljust(width) for at, (cell, width) in row)
        for row in (list(enumerate(zip(line, widths, strict=True))) for line in lines)
    )


def _line(name: str, counts: dict[str, int]) -> tuple[str, ...]:
    valid = counts["valid"]
    keys = ("accepted", "typed", "taken again", "taken again by glslang", "stable", "all of it")
    return (
        name,
        str(counts["shaders"]),
        str(valid),
        *(_share(counts[key], valid) for key in keys),
        str(counts["drawn"]),
        _share(counts["same image"], counts["drawn"]),
        str(counts["invalid"]),
        _share(counts["rejected"], counts["invalid"]),
        _share(counts["same line"], counts["rejected with a line"]),
    )


def _share(part: int, whole: int) -> str:
    return f"{100 * part / whole:.2f} %" if whole else "-"


def failures(rows: Iterable[Row]) -> dict[str, list[Row]]:
    """The rows where something is wrong, by what it is, the largest group first."""
    groups: dict[str, list[Row]] = defaultdict(list)
    for row in rows:
        if row.failure is not None:
            groups[row.failure].append(row)
        elif _elsewhere(row):
            groups["rejected by both, but at another line"].append(row)
    return dict(sorted(groups.items(), key=lambda item: -len(item[1])))


def _elsewhere(row: Row) -> bool:
    line = row.verdict.line
    return not row.verdict.accepted and line > 0 and row.outcome.line != line


def failures_text(name: str, groups: dict[str, list[Row]], folder: str, examples: int = 5) -> str:
    """The groups in Markdown: how many, in which versions and extensions, and examples."""
    lines = [f"# {name}", ""]
    for title, rows in groups.items():
        lines += [f"## {len(rows)} x {title}", "", *_common(rows), ""]
        shown = 40 if title.startswith("rejected by both") else examples
        lines += [_example(row, folder) for row in rows[:: -(-len(rows) // shown)]]
        lines.append("")
    return "\n".join(lines)


def _common(rows: Sequence[Row]) -> Iterator[str]:
    for label, pattern in (("versions", _VERSION), ("extensions", _EXTENSION)):
        counts: dict[str, int] = defaultdict(int)
        for row in rows:
            for found in set(pattern.findall(row.shader.text)) or {"none"}:
                counts[found] += 1
        most = sorted(counts.items(), key=lambda item: -item[1])[:8]
        yield f"{label}: {', '.join(f'{what} {count}' for what, count in most)}"


def _example(row: Row, folder: str) -> str:
    line = row.outcome.line or row.verdict.line
    texts = row.shader.text.split("\n")
    text = texts[line - 1].strip()[:160] if 0 < line <= len(texts) else ""
    theirs = "" if row.verdict.accepted else f" | glslang {row.verdict.line}: {row.verdict.message}"
    ours = f" | {row.outcome.code} {row.outcome.message}" if row.outcome.code else ""
    ours += f" | {row.typing}" if row.typing else ""
    ours += f" | {row.outcome.again}" if row.outcome.again else ""
    reread = row.reread
    ours += f" | print: {reread.line}: {reread.message}" if reread and not reread.accepted else ""
    return f"* `{folder}/{row.shader.file}:{line}`: `{text}`{ours}{theirs}"


def to_json(collections: dict[str, list[Row]]) -> dict[str, Any]:
    """Everything that the table and the list of failures say."""
    return {
        "schema_version": 1,
        "collections": {
            name: {
                "figures": figures(rows),
                "not drawn": _reasons(rows),
                "failures": {
                    title: [row.shader.file for row in group]
                    for title, group in failures(rows).items()
                },
            }
            for name, rows in collections.items()
        },
    }


def _reasons(rows: Sequence[Row]) -> dict[str, int]:
    """Why shaders were not drawn, and how many each; the most frequent first."""
    pictures = [row.picture for row in rows if row.picture is not None]
    reasons = [_NAME.sub("…", picture.why) for picture in pictures if picture.same is None]
    return dict(Counter(reasons).most_common())
