"""Read ``.npz`` files of plain arrays."""

from __future__ import annotations

import zipfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from shadercache.diagnostics import input_error


def load_npz(path: Path, code: str, what: str) -> dict[str, NDArray[np.generic]]:
    """All arrays of an ``.npz`` file; ``what`` and ``code`` go into the error if it is not one."""
    reason = "it is not an .npz file of plain arrays"
    try:
        with path.open("rb") as stream:
            stored = np.load(stream, allow_pickle=False)
            if isinstance(stored, np.lib.npyio.NpzFile):
                return {name: stored[name] for name in stored.files}
    except OSError as error:
        reason = error.strerror or str(error)
    except (ValueError, EOFError, zipfile.BadZipFile):
        pass
    raise input_error(code, f"cannot read {what} {path}: {reason}")
