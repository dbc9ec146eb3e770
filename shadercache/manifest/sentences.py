"""What an engine does each frame and on a reset, and what the variants take for granted."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from shadercache.analysis.mapping import PREVIOUS_CLIP, MappingKind
from shadercache.caching.algorithms import algorithm
from shadercache.caching.configuration import Configuration, Refresh
from shadercache.emit.program_set import ProgramSet
from shadercache.manifest.interface import InputEntry, UniformBlockInput
from shadercache.manifest.model import DependencyEntry
from shadercache.source import Source


@dataclass(frozen=True, slots=True)
class Setting:
    """The shaders' sources, where payloads are found, what is drawn, and what an engine gives.

    ``inputs`` are those of the user's shaders; ``depends_on`` those of the payload; ``unchanged``:
    while which inputs do not change is reuse exact? (``None``: not said.) ``renamed`` leads from
    the user's names to the variants'. ``approximate``: the values of the screen among the payload.
    """

    fragment: Source
    vertex: Source
    mapping: MappingKind
    full_screen: bool
    inputs: tuple[InputEntry, ...]
    depends_on: tuple[DependencyEntry, ...]
    unchanged: tuple[str, ...] | None
    renamed: Mapping[str, str]
    approximate: tuple[str, ...] = ()


FEWEST_ATTACHMENTS = 4
"""Colour attachments that OpenGL ES 3.0 and WebGL 2 promise (3.0.6 table 6.34)."""

FRAME = (
    "Swap the two caches: what was written in the last frame is the previous cache now.",
    "Clear the depth buffer to 1, the colour targets to the background, and the cache that is "
    "written in this frame to cache.clear.",
    "Set the uniforms. A name among the values of 'previous' gets what its key had in the last "
    "frame (of a jittered projection: with the jitter of this frame, which is no motion); the "
    "clock is the frame number modulo the period, reduced on the CPU.",
    "Draw the passes of the variant in order. All objects finish a pass before the next begins; "
    "those that are not cached come first, with no cache attached, so that nothing they hide is "
    "stored. Bind targets[i] at colour attachment i; do not blend.",
)

FRAME_FULL_SCREEN = (
    *FRAME[:2],
    "Set the uniforms; the clock is the frame number modulo the period, reduced on the CPU.",
    "Draw the triangle once in each pass of the variant, in order. Bind targets[i] at colour "
    "attachment i; do not blend.",
)

PLACES = (
    "The samplers among 'uniforms' have no binding: give each a texture unit that no other sampler "
    "of the program has; left alone they read unit 0.",
    "Where 'inputs' has no location, each program may have another one: ask each program, or bind "
    "attributes before it is linked.",
)

VULKAN_PLACES = (
    "What was added is in the descriptor set of 'uniform_block': that block, the same in all "
    "passes, with the offsets that 'uniforms' tells, and textures at their bindings. Twins have "
    "their places among 'inputs'. Write what differs between draws for each draw.",
    "Let an image be written before it is read: a barrier stands between the pass that writes a "
    "target and those that read it, and between two frames.",
)

FEWEST_SETS = 4
"""Descriptor sets that Vulkan promises (maxBoundDescriptorSets)."""

BLOCKS = (
    "Where 'inputs' has no binding for a block, the block reads binding point 0 when left alone. "
    "Give it (each element of an array of blocks) a point that no other block of the program has.",
)

TWINS_OF_BLOCKS = (
    "A block with previous_of is the twin of the block of that name. Give it a point as above, "
    "where it has none, and bind there what the other one's buffer held in the last frame: "
    "keep two buffers and swap them, or copy before you write. With takes_the_last_buffer it is "
    "laid out like the other one; without, ask the program for the offsets and write a buffer of "
    "its own.",
)

TWINS_OF_STREAMS = (
    "An attribute, texture or storage block with previous_of gets what its original had in the "
    "last frame: keep two of each and swap them. What is at an index of the one is the same vertex "
    "or instance at that index of the other.",
)

FRAME_OF_TWO = (
    "What is said of a cache holds for its second texture (cache.second) as well; both are cleared "
    "to values of their own."
)

FRAME_OF_FRACTION = (
    "Targets with a divisor are smaller than the picture. Passes into them have a depth buffer of "
    "their own, cleared with the other one, and a viewport that is as much smaller: its place "
    "rounded down, its extent up. What 'uniforms' tells of a viewport is told of the pass's own.",
    "Pixels for which no texel fits are left open by the pass that reads this frame's cache, and "
    "drawn by the next one, which is the unchanged shader. With a period of 1, unless nothing is "
    "refreshed, passes with on_reset false draw nothing, and may be left out.",
)

FRAME_OF_PARKED = (
    "Passes with draws 'screen' or 'groups' come behind the last pass of all objects, first the "
    "former and then the latter: one that marks pixels is drawn once for all manifests that share "
    "the cache, one that fixes them up once for each group. Targets 'parked-...' and the depth "
    "buffer of marks need neither be cleared nor kept, and objects of several manifests may share "
    "them.",
    "The depth buffer of marks has 24 bits or more, with the depth range and the clip control that "
    "objects have, even if depth is reversed.",
)

NOT_FINITE = (
    "What is not finite, or too large or too small for cache.format, is read back as it is in the "
    "frame that computes it (half floats make 65504 of larger numbers). Of later frames "
    "cache.options.guard tells: with 'miss' they compute it anew, with 'clamp' they reuse the "
    "nearest number and 0 for NaN, with 'off' they reuse it, and half floats may make infinity of "
    "larger numbers."
)

ON_RESET = (
    "Draw only the passes with on_reset true: what was stored is not looked up. The image of one "
    "and two passes is the original's, but for what a driver rounds otherwise around a value that "
    "is cut out (mode proof: not even that). Three passes read the payload back from the cache, "
    "and show the original with the payload as cache.format holds it: rgba32f and rgba32ui hold "
    "it as it is, rgba16f rounds it (to 11 bits, and larger numbers to 65504)."
)
ON_RESET_AT_FRACTION = (
    "Draw only the passes with on_reset true: what was stored is not looked up. The image is that "
    "of any other frame: most pixels have their payloads from texels around them, the others are "
    "the original's."
)
OF_SIZE = "of the size that targets.cache tells of"

SHORT_RESET = (
    "One and three passes may then be drawn as the one of two passes with on_reset true: the cache "
    "is the same, and the image is that of two passes; no branch is in the way, and the geometry "
    "is drawn once."
)

RESET = (
    "On the first frame, and whenever the last frame does not show the same scene (camera cut, "
    "resize, new projection, reloaded shader, lost context): clear both caches to cache.clear. "
    "After a resize or a lost context make them anew first, as large as the target.",
    ON_RESET,
    SHORT_RESET,
    "An object that the last frame did not show, or that jumps, is drawn so by itself; the caches "
    "stay as they are.",
    "A cut that is not told is drawn rightly up to what passes the hit test by chance, and costs "
    "look-ups that find nothing.",
)

RESET_FULL_SCREEN = (
    "On the first frame, and whenever the last frame shows something else (a cut, a resize, a "
    "reloaded shader, a lost context): clear both caches to cache.clear. After a resize or a lost "
    "context make them anew first, as large as the target.",
    ON_RESET,
    SHORT_RESET,
)

RESET_UNIFORMS = (
    "Uniforms with on_reset have that value in the draws of a reset, so that one pass, which looks "
    "up in every frame, finds nothing."
)
RESET_TWINS = "What is a twin of the last frame may have any value in the draws of a reset."


AS_LARGE = ", as large as the cache"
WHICH_IS = ", which is as large as the cache"
WHOLE_TARGET = f"a viewport that covers the whole target and begins at (0, 0){AS_LARGE}"
PART_OF_TARGET = f"a viewport inside of the target{WHICH_IS}"

ONE_VIEW = "one view: each view or target has caches and last values of its own"

RELIES_ON = (
    "opaque geometry, drawn without blending, alpha to coverage or multisampling",
    "the depth function 'less' in the application, with depth cleared to 1; for any other, "
    "depth_functions says what the passes' are and what depth is cleared to",
    "colours are written as the shader computes them, with no conversion to sRGB between the "
    "passes",
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

_LARGEST_OF_HALF = (
    "payloads up to 65504 in size where cache.format is rgba16f: of larger ones three passes show "
    "what that holds, in the very frame"
)


def frame_sentences(
    two_textures: bool, configuration: Configuration, setting: Setting, programs: ProgramSet
) -> list[str]:
    """What it does each frame, in order; ``two_textures``: is a payload too wide for one?"""
    blocks = {entry.name for entry in setting.inputs if isinstance(entry, UniformBlockInput)}
    last = programs.last_frame
    return [
        *(FRAME_FULL_SCREEN if setting.full_screen else FRAME),
        NOT_FINITE,
        *(PLACES if programs.vulkan is None else VULKAN_PLACES),
        *(BLOCKS if blocks and programs.vulkan is None else ()),
        *(TWINS_OF_BLOCKS if blocks & last.twins.keys() else ()),
        *(TWINS_OF_STREAMS if last.moving & last.twins.keys() else ()),
        *[FRAME_OF_TWO] * two_textures,
        *(FRAME_OF_FRACTION if configuration.divisor > 1 else ()),
        *(FRAME_OF_PARKED if any(emitted.parked for emitted in programs.passes) else ()),
    ]


def reset_sentences(
    configuration: Configuration, setting: Setting, programs: ProgramSet
) -> list[str]:
    """What it does on the first frame, whenever the last one does not fit, and on a change."""
    sentences = list(RESET_FULL_SCREEN if setting.full_screen else RESET)
    at_once = [name for name in programs.variants if algorithm(name).resets_at_once]
    # An algorithm that resets in one pass does so anyway, and without it no pass can be borrowed.
    if not at_once or len(programs.variants) == 1:
        sentences.remove(SHORT_RESET)
    if configuration.divisor > 1:
        sentences[sentences.index(ON_RESET)] = ON_RESET_AT_FRACTION
        sentences = [text.replace("as large as the target", OF_SIZE) for text in sentences]
    twins = [RESET_TWINS] * bool(programs.last_frame.twins)
    return [*sentences, RESET_UNIFORMS, *twins, *_of_changes(configuration.refresh, setting)]


def _of_changes(refresh: Refresh, setting: Setting) -> list[str]:
    if not setting.depends_on:
        return []
    whom = "" if setting.full_screen else ", or the objects that it concerns by themselves"
    old = age(refresh, setting.mapping)
    return [
        f"What is reused was computed in an earlier frame; it is {old}. Where "
        "something in depends_on has another value now (a light, the eye, a texture's content), "
        "reuse shows the old one for that long. If that must not be seen, reset in the frame of "
        f"the change{whom}; what is not in depends_on needs no reset."
    ]


def age(refresh: Refresh, mapping: MappingKind) -> str:
    """How old a payload may become, behind ``it is``."""
    # A payload that stays at its pixel has that pixel's turn in every period. One that moves may
    # leave each block just before its turn.
    if refresh.age or (mapping == "screen" and refresh.schedule != "none"):
        return "at most a period old"
    if refresh.schedule == "none":
        return "as old as a surface has been in view: nothing is refreshed"
    return (
        "at most a period old where nothing moves, and may be older in motion, since it comes from "
        "pixels with other turns"
    )


def relies_on(configuration: Configuration, programs: ProgramSet, setting: Setting) -> list[str]:
    """What these programs rely on."""
    chosen = [algorithm(name) for name in programs.variants]
    relies = list(RELIES_ON_FULL_SCREEN if setting.full_screen else RELIES_ON)
    if configuration.hit_test.viewport:
        relies[relies.index(WHOLE_TARGET)] = PART_OF_TARGET
    if configuration.divisor > 1:
        relies = [text.removesuffix(AS_LARGE).removesuffix(WHICH_IS) for text in relies]
    if configuration.storage.depth != "ndc" and not setting.full_screen:
        relies.append("a perspective projection: in an orthographic one w tells no depth")
    if configuration.storage.format == "rgba16f" and any(record.reads_back for record in chosen):
        relies.append(_LARGEST_OF_HALF)
    if programs.last_frame.unchanging:
        names = ", ".join(programs.last_frame.unchanging)
        relies.append(f"these decide the position and do not change between frames: {names}")
    relies += list(programs.last_frame.numbers)
    parks = [emitted for emitted in programs.passes if emitted.parked]
    ahead = bool(parks) or any(record.branches for record in chosen)
    if configuration.fetches == "level" and ahead:
        relies.append(
            "isotropic texture filtering: levels of detail are asked for ahead, then fetched at"
        )
    most = max(len(emitted.targets) for emitted in programs.passes)
    if most > FEWEST_ATTACHMENTS:
        relies.append(
            f"{most} colour attachments in one pass: OpenGL has 8 or more, OpenGL ES and WebGL may "
            f"have {FEWEST_ATTACHMENTS}"
        )
    return [*relies, *_of_vulkan(programs), *_of_mapping(setting), *_of_screen(setting)]


def _of_vulkan(programs: ProgramSet) -> list[str]:
    if programs.vulkan is None:
        return []
    told = ["a viewport of positive height, with depths from 0 to 1"]
    if programs.vulkan.set >= FEWEST_SETS:
        told.append(f"{programs.vulkan.set + 1} descriptor sets: Vulkan promises {FEWEST_SETS}")
    return told


def _of_screen(setting: Setting) -> list[str]:
    if not setting.approximate:
        return []
    texts = " and ".join(f"'{text}'" for text in setting.approximate)
    return [
        f"little motion in a period: {texts} depends on where or how large a surface is seen, and "
        "is reused as it was then; reuse is exact only while neither camera nor objects move"
    ]


def _of_mapping(setting: Setting) -> list[str]:
    if setting.mapping == "user":
        return [f"{PREVIOUS_CLIP}() says where the last frame showed what a pixel shows now"]
    if setting.unchanged:
        names = ", ".join(setting.unchanged)
        return [f"reuse is exact while these do not change: {names}"]
    return []
