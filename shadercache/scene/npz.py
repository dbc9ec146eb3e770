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
from typing import IO

import numpy as np
from numpy.typing import NDArray

from shadercache.diagnostics import input_error

MAX_NUMBERS = 1 << 28
"""Numbers in all arrays of a file: a texture of 8192 by 8192 texels, a mesh of ten million."""

MAX_BYTES = 1 << 30
"""Bytes in all arrays of a file."""

MAX_ARRAYS = 1_000

INFLATION = 1_100
"""Deflated data are at most 1,032 times as long once they are inflated."""

_ENDING = ".npy"

# What numpy raises beside ValueError: it evaluates a header as Python.
_NO_HEADER = (
    *(LookupError, MemoryError, OverflowError, RecursionError, SyntaxError, TypeError),
    *(AttributeError, tokenize.TokenError),
)


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
    members = [entry for entry in archive.infolist() if entry.filename.endswith(_ENDING)]
    if len(members) > MAX_ARRAYS:
        raise _UnusableError(f"it holds {len(members):,} arrays; at most {MAX_ARRAYS:,} are read")
    whole = sum(entry.file_size for entry in members)
    if whole > MAX_BYTES:
        raise _UnusableError(f"its arrays have {whole:,} bytes; at most {MAX_BYTES:,} are read")
    arrays: dict[str, NDArray[np.generic]] = {}
    numbers = 0
    for entry in members:
        # Before a byte is inflated: `file_size` is what the archive claims.
        if entry.file_size > INFLATION * (entry.compress_size + 1):
            raise _claims(entry, f"{entry.file_size:,} bytes")
        with archive.open(entry) as stream:
            array = _array(stream, entry)
        numbers += array.size
        if numbers > MAX_NUMBERS:
            raise _UnusableError(f"it holds more than {MAX_NUMBERS:,} numbers")
        arrays[entry.filename.removesuffix(_ENDING)] = array
    return arrays


def _array(stream: IO[bytes], entry: zipfile.ZipInfo) -> NDArray[np.generic]:
    # `np.load` takes all the memory that a header claims before it reads. Version 3.0 of the format
    # differs in the names of fields alone, and a plain array has none.
    readers = {
        (1, 0): np.lib.format.read_array_header_1_0,
        (2, 0): np.lib.format.read_array_header_2_0,
    }
    read = readers.get(np.lib.format.read_magic(stream))
    if read is None:
        raise ValueError
    try:
        shape, by_columns, dtype = read(stream)
    except _NO_HEADER:
        raise ValueError from None
    # Python's integers do not wrap around, as the product of a forged shape would in 64 bits.
    count = math.prod(shape)
    # Objects would have to be unpickled, which runs whatever the file says.
    if min(shape, default=0) < 0 or dtype.hasobject or dtype.itemsize == 0:
        raise ValueError
    if stream.tell() + count * dtype.itemsize != entry.file_size or count > MAX_NUMBERS:
        raise _claims(entry, f"{count:,} numbers")
    data = np.frombuffer(stream.read(), dtype, count)
    return data.reshape(shape, order="F" if by_columns else "C")


def _claims(entry: zipfile.ZipInfo, what: str) -> _UnusableError:
    name = entry.filename.removesuffix(_ENDING)
    return _UnusableError(f"its array {name!r} claims {what}, which the file does not hold")
