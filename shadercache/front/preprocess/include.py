"""Files that ``#include`` names, and the folders that they must not leave.

``#include "x"`` looks beside the including file first, then in the given folders; ``<x>`` only in
those. What a path leads to once all links are followed must lie in one of the folders looked at.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path, PureWindowsPath

from shadercache.diagnostics import shortened
from shadercache.front.preprocess.directive_errors import DirectiveError, RunawayError

MAX_DEPTH = 50
"""Files that may be open inside one another."""

MAX_TEXT = 1 << 24
"""Characters that all included files may have together."""

MIN_TEXT = 1 << 12
"""Characters that a file counts for at the least, lest empty ones are read for ever."""

_NAME = re.compile(r'(?:#\s*include\s*)?(?:"([^"\n]+)"|<([^>\n]+)>)\s*(?:/[/*].*)?')


def name_of(rest: str, line: str) -> tuple[str, bool]:
    """The name that an ``#include`` asks for, and whether it stands in quotes.

    ``rest`` is what follows the word, without comments; ``line`` the line as it was written.
    """
    match = _NAME.fullmatch(rest) or _NAME.fullmatch(line)
    if match is None:
        raise DirectiveError("SC123", '#include is followed by "name" or <name>')
    return match[1] or match[2], bool(match[1])


def find(name: str, beside: Path | None, folders: tuple[Path, ...]) -> Path:
    """The file that is meant, as the user would name it."""
    looked_at = folders if beside is None else (beside, *folders)
    shown = shortened(name)
    if not looked_at:
        message = f"cannot include '{shown}': there is no folder to look in"
        raise DirectiveError("SC123", message, "name folders with -I")
    inside = False
    for path in _candidates(name, looked_at):
        try:
            # Links first: one inside a folder may lead out of it.
            real = path.resolve()
            if any(real.is_relative_to(folder.resolve()) for folder in looked_at):
                inside = True
                if real.is_file():
                    return path
        except (OSError, RuntimeError):  # A name too long, a circle of links.
            inside = True
    if not inside:
        message = f"cannot include '{shown}': it leads out of the folders for included files"
        raise DirectiveError("SC123", message, "a folder more can be named with -I")
    places = ", ".join(f"'{folder}'" for folder in looked_at)
    hint = "other folders to look in can be named with -I"
    if "\\" in name:
        hint = "write / between folders: every system takes that"
    raise DirectiveError("SC123", f"cannot include '{shown}': it is not in {places}", hint)


def _candidates(name: str, folders: tuple[Path, ...]) -> Iterator[Path]:
    # A drive is no folder's on any system, and Windows would leave the folder for it.
    if "\0" not in name and not Path(name).is_absolute() and not PureWindowsPath(name).drive:
        for folder in folders:
            yield folder / name


def read(path: Path, room: int) -> str:
    """The text of a file that may have ``room`` characters."""
    try:
        # Before it is read. A file has at least as many bytes as characters.
        if path.stat().st_size > room:
            message = f"included files have more than {MAX_TEXT >> 20} million characters"
            raise RunawayError("SC123", message)
        return path.read_bytes().decode("utf-8-sig")
    except OSError as error:
        raise DirectiveError("SC123", f"cannot include '{path}': {error.strerror}") from None
    except UnicodeDecodeError:
        raise DirectiveError("SC123", f"cannot include '{path}': it is not UTF-8 text") from None
