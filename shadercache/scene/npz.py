"""Read ``.npz`` files of plain arrays.

What the headers claim is compared with the size of the file, and with a limit, before any memory is
taken: a header of a hundred bytes may claim twelve billion numbers.
"""

from __future__ import annotations

import math
import tokenize
import zipfile
import zlib
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from shadercache.diagnostics import input_error

MAX_NUMBERS = 1 << 28
"""Numbers in all arrays of a file: a texture of 8192 by 8192 texels, a mesh of ten million."""

MAX_BYTES = 1 << 30
"""Bytes in all arrays of a file."""

MAX_ARRAYS = 1_000

_RATIO = 1_100
"""Deflated data are at most 1,032 times as long once they are inflated."""

_ENDING = ".npy"

_NO_HEADER = (
    *(LookupError, MemoryError, OverflowError, RecursionError, SyntaxError, TypeError),
    *(AttributeError, tokenize.TokenError),
)
"""What numpy raises beside ``ValueError``: it evaluates a header as Python."""


class _UnusableError(Exception):
    """Why a file is not read."""


def load_npz(path: Path, code: str, what: str) -> dict[str, NDArray[np.generic]]:
    """All arrays of an ``.npz`` file; ``what`` and ``code`` go into the error if it is not one."""
    reason = "it is not an .npz file of plain arrays"
    try:
        with path.open("rb") as stream, zipfile.ZipFile(stream) as archive:
            return _arrays(archive)
    except _UnusableError as error:
        reason = str(error)
    except OSError as error:
        reason = error.strerror or str(error)
    except (ValueError, EOFError, zipfile.BadZipFile, zlib.error):
        pass
    except (NotImplementedError, RuntimeError):  # another compression, or a password
        reason = "its arrays are packed in a way that is not supported"
    raise input_error(code, f"cannot read {what} {path}: {reason}")


def _arrays(archive: zipfile.ZipFile) -> dict[str, NDArray[np.generic]]:
    members = [item for item in archive.infolist() if item.filename.endswith(_ENDING)]
    if len(members) > MAX_ARRAYS:
        raise _UnusableError(f"it holds {len(members):,} arrays; at most {MAX_ARRAYS:,} are read")
    whole = sum(item.file_size for item in members)
    if whole > MAX_BYTES:
        raise _UnusableError(f"its arrays have {whole:,} bytes; at most {MAX_BYTES:,} are read")
    found: dict[str, NDArray[np.generic]] = {}
    numbers = 0
    for item in members:
        if item.file_size > _RATIO * (item.compress_size + 1):
            raise _claims(item, f"{item.file_size:,} bytes")
        with archive.open(item) as stream:
            array = _array(stream, item)
        numbers += array.size
        if numbers > MAX_NUMBERS:
            raise _UnusableError(f"it holds more than {MAX_NUMBERS:,} numbers")
        found[item.filename.removesuffix(_ENDING)] = array
    return found


def _array(stream: IO[bytes], item: zipfile.ZipInfo) -> NDArray[np.generic]:
    shape, by_columns, dtype = _header(stream)
    count = math.prod(shape)
    if min(shape, default=0) < 0 or dtype.hasobject or dtype.itemsize == 0:
        raise ValueError
    if stream.tell() + count * dtype.itemsize != item.file_size or count > MAX_NUMBERS:
        raise _claims(item, f"{count:,} numbers")
    data = np.frombuffer(stream.read(), dtype, count)
    return data.reshape(shape, order="F" if by_columns else "C")


def _header(stream: IO[bytes]) -> tuple[tuple[int, ...], bool, np.dtype[Any]]:
    """Shape, order and type of the array that begins here."""
    readers = {
        (1, 0): np.lib.format.read_array_header_1_0,
        (2, 0): np.lib.format.read_array_header_2_0,
    }
    read = readers.get(np.lib.format.read_magic(stream))
    if read is None:
        raise ValueError
    try:
        return read(stream)
    except _NO_HEADER:
        raise ValueError from None


def _claims(item: zipfile.ZipInfo, what: str) -> _UnusableError:
    name = item.filename.removesuffix(_ENDING)
    return _UnusableError(f"its array {name!r} claims {what}, which the file does not hold")
