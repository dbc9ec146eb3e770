"""Fetch packages by name with the ordinary tools, and unpack them.

Nothing says here where packages come from: that is what npm and apt are configured for.
"""

from __future__ import annotations

import shutil
import subprocess
import tarfile
from pathlib import Path


class FetchError(Exception):
    """A package cannot be had; the message says what to do."""


def npm_package(name: str, folder: Path) -> Path:
    """The unpacked folder of an npm package, fetched where it is missing."""
    target = folder / name
    if not target.is_dir():
        _need("npm", f"to fetch the npm package {name}")
        folder.mkdir(parents=True, exist_ok=True)
        archive = folder / _run(["npm", "pack", "--silent", name], folder).split()[-1]
        with tarfile.open(archive) as tar:
            tar.extractall(folder / f"{name}.new", filter="data")
        (folder / f"{name}.new" / "package").rename(target)
        (folder / f"{name}.new").rmdir()
    return target


def debian_package(name: str, folder: Path) -> Path:
    """The unpacked files of a Debian package, fetched where they are missing."""
    target = folder / name
    if not target.is_dir():
        for tool in ("apt-get", "dpkg-deb"):
            _need(tool, f"to fetch the Debian package {name}")
        folder.mkdir(parents=True, exist_ok=True)
        _run(["apt-get", "download", name], folder)
        archives = sorted(folder.glob(f"{name}_*.deb"))
        _run(["dpkg-deb", "-x", str(archives[-1]), f"{name}.new"], folder)
        (folder / f"{name}.new").rename(target)
    return target


def _need(tool: str, purpose: str) -> None:
    if shutil.which(tool) is None:
        raise FetchError(f"{tool} is needed {purpose}, and it is not installed")


def _run(command: list[str], folder: Path) -> str:
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    if done.returncode:
        said = (done.stderr or done.stdout).strip() or f"exit status {done.returncode}"
        raise FetchError(f"'{' '.join(command)}' failed: {said}")
    return done.stdout
