"""The parser: made from the grammar once per process, and saved for the next.

Making it takes some 200 ms, loading it some 20. The saved one is a pickle, so it is read only
from the user's private cache folder (:func:`shadercache.paths.user_cache_folder`).
"""

from __future__ import annotations

import hashlib
import io
import os
import pickle
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, cast

from shadercache.paths import data_path, user_cache_folder

if TYPE_CHECKING:
    from lark import Lark

    from shadercache.front.tree_builder import TreeBuilder


class Parser(NamedTuple):
    """Lark's parser and the builder whose methods it calls; they serve one file at a time."""

    lark: Lark
    builder: TreeBuilder


@cache
def load_parser() -> Parser:
    """The parser of ``grammars/glsl.lark``. Lark is imported here, not with the package."""
    from shadercache.front.tree_builder import TreeBuilder

    text = data_path("grammars", "glsl.lark").read_text(encoding="utf-8")
    builder = TreeBuilder()
    folder = user_cache_folder()
    path = folder and folder / f"glsl-{_key(text)}.grammar"
    lark = None if path is None else _load(path, builder)
    if lark is None:
        lark = _make(text, builder)
        if path is not None:
            _save(path, lark)
    return Parser(lark, builder)


def _key(text: str) -> str:
    """What a saved parser depends on: the grammar, Lark, Python, and the lexer it names."""
    import lark

    from shadercache.front.tokens import TokenLexer

    lexer = f"{TokenLexer.__module__}.{TokenLexer.__qualname__}"
    parts = (text, lark.__version__, sys.version, lexer)
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:32]


def _make(text: str, builder: TreeBuilder) -> Lark:
    from lark import Lark

    from shadercache.front.tokens import TokenLexer

    return Lark(
        text,
        parser="lalr",
        lexer=TokenLexer,
        transformer=builder.callbacks,
        # Spans are made from the tokens, which takes half the time of Lark's own positions.
        keep_all_tokens=True,
        # None for what is left out, so that callbacks can unpack their parts by position.
        maybe_placeholders=True,
        propagate_positions=False,
    )


def _load(path: Path, builder: TreeBuilder) -> Lark | None:
    """The saved parser; ``None`` where there is none that can be read."""
    from lark import Lark

    # `Lark.load` takes no transformer; this is how Lark's generated parsers come to theirs.
    load: Callable[..., Lark] = cast(Any, Lark)._load_from_dict
    try:
        saved = pickle.loads(path.read_bytes())
        return load(saved["data"], saved["memo"], transformer=builder.callbacks)
    except Exception:  # A damaged pickle can raise anything; the parser is then made anew.
        return None


def _save(path: Path, lark: Lark) -> None:
    """Write the parser under its name at one stroke, so that nobody reads half of it."""
    import tempfile

    buffer = io.BytesIO()
    lark.save(buffer, {"transformer"})
    try:
        handle, name = tempfile.mkstemp(dir=path.parent, prefix=".glsl-")
        try:
            with os.fdopen(handle, "wb") as file:
                file.write(buffer.getvalue())
            os.replace(name, path)
        except OSError:
            os.unlink(name)
    except OSError:
        return  # A full or read-only disk costs time, not the result.
