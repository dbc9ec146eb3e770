"""What the variants take for granted, in sentences: the manifest's ``relies_on``."""

from __future__ import annotations

from shadercache.analysis.mapping import PREVIOUS_CLIP
from shadercache.caching.algorithms import algorithm
from shadercache.caching.configuration import Configuration
from shadercache.emit.program_set import ProgramSet
from shadercache.manifest.setting import Setting

WHOLE_TARGET = "a viewport that covers the whole target and begins at (0, 0), as large as the cache"
PART_OF_TARGET = "a viewport inside of the target, which is as large as the cache"

ONE_VIEW = "one view: each view or target has caches and last values of its own"

RELIES_ON = (
    "opaque geometry, drawn without blending, alpha to coverage or multisampling",
    "the depth function 'less' in the application, with depth cleared to 1; for any other, "
    "depth_functions says what the passes' are and what depth is cleared to",
    "one colour output; colours are written as the shader computes them, with no conversion to "
    "sRGB between the passes",
    WHOLE_TARGET,
    "the same geometry, in the same order, in every pass of a frame",
    ONE_VIEW,
)

RELIES_ON_FULL_SCREEN = (
    "no blending, alpha to coverage or multisampling",
    "a depth buffer that nothing else is drawn into, which all passes of a frame share",
    *RELIES_ON[2:4],
    ONE_VIEW,
)

LARGEST_OF_HALF = (
    "payloads up to 65504 in size where cache.format is rgba16f: of larger ones three passes show "
    "what that holds, in the very frame"
)


def relies_on(configuration: Configuration, programs: ProgramSet, setting: Setting) -> list[str]:
    """What these programs rely on."""
    chosen = [algorithm(name) for name in programs.variants]
    relies = list(RELIES_ON_FULL_SCREEN if setting.full_screen else RELIES_ON)
    if configuration.hit_test.viewport:
        relies[relies.index(WHOLE_TARGET)] = PART_OF_TARGET
    if configuration.storage.depth != "ndc" and not setting.full_screen:
        relies.append("a perspective projection: in an orthographic one w tells no depth")
    if configuration.storage.format == "rgba16f" and any(item.reads_back for item in chosen):
        relies.append(LARGEST_OF_HALF)
    if programs.unchanging:
        names = ", ".join(programs.unchanging)
        relies.append(f"these decide the position and do not change between frames: {names}")
    relies += programs.numbers
    if configuration.fetches == "level" and any(item.branches for item in chosen):
        relies.append(
            "isotropic texture filtering: one pass asks for levels of detail, then fetches at these"
        )
    return [*relies, *_of_mapping(setting)]


def _of_mapping(setting: Setting) -> list[str]:
    if setting.mapping == "user":
        return [f"{PREVIOUS_CLIP}() says where the last frame showed what a pixel shows now"]
    if setting.unchanged:
        names = ", ".join(setting.unchanged)
        return [f"reuse is exact while these do not change: {names}"]
    return []
