"""Where data lies: the folders beside the code, and the user's cache folder.

``grammars/`` and ``corpus/`` stand at the top of the source tree. A wheel holds them inside the
package as ``shadercache/_data/grammars`` and ``shadercache/_data/corpus``.
"""

from __future__ import annotations

import os
import stat
import sys
from pathlib import Path

_PACKAGE = Path(__file__).resolve().parent


def data_path(*parts: str) -> Path:
    """The path of a data file or folder, such as ``data_path("grammars", "glsl.lark")``.

    A wheel's copy is preferred, so that an installed package never reads a folder that merely
    lies beside it. The path is returned even where nothing exists there.
    """
    packed = _PACKAGE / "_data"
    root = packed if packed.is_dir() else _PACKAGE.parent
    return root.joinpath(*parts)


def user_cache_folder() -> Path | None:
    """The user's own cache folder, made with mode 0700 where it is missing.

    It lies where ``XDG_CACHE_HOME`` says, and else where the system has such folders.

    ``None`` where there is none to be had: the folder cannot be made or written, it belongs to
    somebody else, or others may write in it. What is read from there is trusted, so a folder that
    another user could have filled is never used.
    """
    try:
        folder = _cache_root() / "shadercache"
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        return folder if _is_private(folder) else None
    # `Path.home` raises RuntimeError for a user without a home.
    except (OSError, RuntimeError):
        return None


def _cache_root() -> Path:
    """Where programs keep caches. Raises :class:`RuntimeError` for a user without a home."""
    given = Path(os.environ.get("XDG_CACHE_HOME", ""))
    # The XDG base directory specification tells to ignore a relative path.
    if given.is_absolute():
        return given
    system: str = sys.platform
    if system == "win32":
        local = Path(os.environ.get("LOCALAPPDATA", ""))
        return local if local.is_absolute() else Path.home() / "AppData" / "Local"
    return Path.home() / ("Library/Caches" if system == "darwin" else ".cache")


def _is_private(folder: Path) -> bool:
    # Not `stat`: a link could lead to a folder that somebody else fills.
    info = folder.lstat()
    if not stat.S_ISDIR(info.st_mode) or not os.access(folder, os.W_OK | os.X_OK):
        return False
    # Windows has no owners and modes of this kind.
    if hasattr(os, "getuid"):
        if info.st_uid != os.getuid():
            return False
        mode = stat.S_IMODE(info.st_mode)
        # Whoever may write may have written already; against mere reading a chmod helps.
        if mode & (stat.S_IWGRP | stat.S_IWOTH):
            return False
        if mode != 0o700:
            folder.chmod(0o700)
    return True
