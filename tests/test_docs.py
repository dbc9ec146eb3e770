"""The documents: links lead somewhere, anchors are there, README is a front page."""

from __future__ import annotations

import re
import unicodedata
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
PAGES = sorted(
    [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"), *(ROOT / "corpus").rglob("*.md")]
)
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
CODE = re.compile(r"^```.*?^```$|`[^`\n]*`", re.DOTALL | re.MULTILINE)
HEADING = re.compile(r"^#{1,6} +(.+)$", re.MULTILINE)
MENTION = re.compile(r"\bdocs/[\w/.-]+\.md\b")
CITATION = re.compile(
    r"\b([A-Z][\w-]+)(?: et al\.| and [A-Z][\w-]+|, [A-Z]\w+ and [A-Z]\w+),? (\d{4})\b"
)


def anchors(page: Path) -> set[str]:
    """The anchors of a page's headings, as GitHub makes them."""
    text = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.S | re.M)
    found: set[str] = set()
    for heading in HEADING.findall(text):
        words = LINK.sub(lambda link: link[0][1:].partition("]")[0], heading).lower()
        kept = (
            letter for letter in words if letter in " -_" or unicodedata.category(letter)[0] in "LN"
        )
        anchor = "".join(kept).replace(" ", "-")
        number = sum(known == anchor or known.startswith(f"{anchor}-") for known in found)
        found.add(f"{anchor}-{number}" if anchor in found else anchor)
    return found


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_every_relative_link_leads_somewhere(page: Path) -> None:
    broken = []
    for link in LINK.findall(CODE.sub("", page.read_text(encoding="utf-8"))):
        target, _, anchor = link.partition("#")
        if re.match(r"[a-z]+:", target):
            continue
        file = (page.parent / target).resolve() if target else page
        if not file.exists() or (anchor and anchor not in anchors(file)):
            broken.append(link)
    assert not broken


def test_every_page_is_listed() -> None:
    listed = (ROOT / "docs" / "README.md").read_text(encoding="utf-8")
    pages = {str(page.relative_to(ROOT / "docs")) for page in (ROOT / "docs").rglob("*.md")}
    assert {page for page in pages - {"README.md"} if f"({page})" not in listed} == set()


@pytest.mark.parametrize("folder", ["shadercache", "tests", "bench", "corpus", "grammars"])
def test_pages_that_code_names_exist(folder: str) -> None:
    wrong = {
        f"{path.relative_to(ROOT)}: {page}"
        for path in (ROOT / folder).rglob("*")
        if path.suffix in {".py", ".glsl", ".frag", ".vert", ".md", ".toml"}
        for page in MENTION.findall(path.read_text(encoding="utf-8", errors="replace"))
        if not (ROOT / page).exists()
    }
    assert wrong == set()


def test_what_is_cited_is_in_the_references() -> None:
    known = (ROOT / "docs" / "REFERENCES.md").read_text(encoding="utf-8")
    cited = {
        found.groups()
        for page in PAGES
        for found in CITATION.finditer(page.read_text(encoding="utf-8").replace("\n", " "))
    }
    assert {f"{name} {year}" for name, year in cited if not _listed(known, name, year)} == set()
    assert len(cited) >= 6


def _listed(known: str, name: str, year: str) -> bool:
    return re.search(rf"^\* \*\*{re.escape(name)}\b.* {year}", known, re.MULTILINE) is not None


def test_no_document_names_a_file_that_is_not_here() -> None:
    private = re.compile(r"\bseed \d{3}\b|\bseeds/")
    files = [*PAGES, *(ROOT / "shadercache").rglob("*.py"), *(ROOT / "shadercache").rglob("*.glsl")]
    assert [str(f) for f in files if private.search(f.read_text(encoding="utf-8"))] == []


def test_readme_is_a_front_page() -> None:
    lines = (ROOT / "README.md").read_text(encoding="utf-8").splitlines()
    assert len(lines) < 120
    assert all(len(line) <= 100 for line in lines if line.startswith("|"))
    assert sum("](docs/images/" in line for line in lines) == 1
