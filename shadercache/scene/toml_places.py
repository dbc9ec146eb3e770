"""Where keys stand in the text of a TOML file: tomllib keeps no places."""

from __future__ import annotations

import re

from shadercache.source import Source, Span

_NUMBER = re.compile(r"\[\d+\]")
_HEADER = re.compile(r"^[ \t]*\[+([^\[\]\n]*)\]+", re.MULTILINE)

# The stems of a name are quadratic in its parts, and a file may hold a million dots.
_MOST_PARTS = 20
"""Parts of the name of a table; those behind are taken for one."""


def locate(source: Source, table: str, key: str) -> Span | None:
    """Where ``key`` of ``table`` ("" is the top level) stands in the text, as far as can be seen.

    Tables of an array are called ``name[0]``, ``name[1]``, ... A missing key is at its table.
    """
    # Found are [table] and below it key = ..., and tables in braces on one line or more.
    headers = list(_HEADER.finditer(source.text))
    starts = [("", 0), *zip(_full_names(headers), (m.end() for m in headers), strict=True)]
    ends = [start for _, start in starts[1:]] + [len(source.text)]
    for (name, start), stop in zip(starts, ends, strict=True):
        if name != table:
            continue
        found = _key(source, key, start, stop) or _header(headers, starts, table, key)
        if found is not None:
            return found
        if table:
            end = start - (2 if source.text.startswith("]]", start - 2) else 1)
            return Span(end - len(_NUMBER.sub("", name)), end)
    return _in_braces(source, table, key) if table else None


def _key(source: Source, key: str, start: int, end: int) -> Span | None:
    """A key at the beginning of a line, in quotes or before a dot, too."""
    pattern = rf"^[ \t]*[\"']?({re.escape(key)})[\"']?[ \t]*[.=]"
    match = re.search(pattern, source.text[start:end], re.MULTILINE)
    return match and Span(start + match.start(1), start + match.end(1))


def _header(
    headers: list[re.Match[str]], starts: list[tuple[str, int]], table: str, key: str
) -> Span | None:
    """A key that is a table, or an array of tables, with a header."""
    full = f"{table}.{key}" if table else key
    for header, (name, _) in zip(headers, starts[1:], strict=True):
        if name == full or name.startswith((f"{full}[", f"{full}.")):
            return Span(header.start(1), header.end(1))
    return None


def _in_braces(source: Source, table: str, key: str) -> Span | None:
    """A key of a table that is the value of another key."""
    outer, _, last = table.rpartition(".")
    name, _, number = last.partition("[")
    held = locate(source, outer, name)
    if held is None or source.text[held.start : held.end] != name:
        return held
    dotted = re.match(rf"[\"']?[ \t]*\.[ \t]*[\"']?({re.escape(key)})\b", source.text[held.end :])
    if dotted is not None:
        return Span(held.end + dotted.start(1), held.end + dotted.end(1))
    at = held.end
    for _ in range(int(number[:-1]) + 1 if number else 1):
        brace = source.text.find("{", at)
        if brace < 0:
            return held
        at = brace + 1
    end = source.text.find("}", at)
    match = re.search(rf"[\s,{{][\"']?({re.escape(key)})[\"']?[ \t]*=", source.text[at - 1 : end])
    if match is None:
        return Span(at - 1, at) if number else held
    return Span(at - 1 + match.start(1), at - 1 + match.end(1))


def _full_names(headers: list[re.Match[str]]) -> list[str]:
    """The names of tables, those of arrays with their number: ``objects[1].motion``."""
    counts: dict[str, int] = {}
    names: list[str] = []
    for header in headers:
        name = header[1].strip()
        if "[[" in header[0]:
            counts[name] = counts.get(name, -1) + 1
        parts = name.split(".", _MOST_PARTS)
        stems = [".".join(parts[: end + 1]) for end in range(len(parts))]
        marks = [f"[{counts[stem]}]" if stem in counts else "" for stem in stems]
        names.append(".".join(map("".join, zip(parts, marks, strict=True))))
    return names
