"""The manifest: everything an engine must know to run the variants, as plain JSON data."""

from shadercache.manifest.build import (
    DEPTH_FUNCTIONS,
    build_manifest,
    needed_manifest,
    original_manifest,
)
from shadercache.manifest.setting import Setting

__all__ = [
    "DEPTH_FUNCTIONS",
    "Setting",
    "build_manifest",
    "needed_manifest",
    "original_manifest",
]
