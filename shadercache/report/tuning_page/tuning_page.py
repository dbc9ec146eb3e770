"""The page of a tuning as one file, and all that is drawn and read for it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from datetime import UTC, datetime
from hashlib import sha256
from typing import Any

from PIL import Image

from shadercache import __version__
from shadercache.caching.configuration import Assignment, Configuration
from shadercache.linking.linker import Linker
from shadercache.measure.image_error import Pixels
from shadercache.measure.shown import picture
from shadercache.render.render_scene import RenderScene
from shadercache.report.images import LEGEND, difference_picture, hit_picture
from shadercache.report.parts.page_parts import PageParts
from shadercache.report.parts.picture_uris import exact_uri, lossy_uri
from shadercache.report.tuning_page.plan_shots import (
    DrawnPlan,
    PlanShot,
    Value,
    original_of,
    payloads_of,
    shots_of,
    shown_frame,
)
from shadercache.report.tuning_page.tuned_texts import TunedTexts, assignments, texts_of
from shadercache.report.tuning_page.tuning_words import (
    METRICS,
    coverage,
    headline,
    left_out,
    verdicts,
    way_in_words,
)

MOST_SHOTS = 12
"""Plans that have pictures of their own."""

PARTS = PageParts(
    __package__,
    "tuning.html",
    ("common.css", "tuning.css"),
    (
        "base.js",
        "tasks.js",
        "plots.js",
        "viewer.js",
        "code.js",
        "table.js",
        "models.js",
        "plans.js",
        "bound.js",
        "tuning_plane.js",
        "chosen.js",
        "values_table.js",
        "tuning_start.js",
    ),
)

Progress = Callable[[int, int, str], None]
"""Called with (steps done, steps in all, what is being done)."""


@dataclass(frozen=True, eq=False)
class TunedPictures:
    """The original, plans and values as they were drawn at one frame."""

    original: Pixels | None = None
    shots: Sequence[PlanShot] = ()
    payloads: Mapping[Value, Pixels] | None = None


def page_of(
    found: Mapping[str, Any],
    world: RenderScene,
    linker: Linker,
    plans: Sequence[tuple[Sequence[Sequence[int]], Assignment]],
    progress: Progress | None = None,
) -> bytes:
    """Draw and read what the page of a tuning shows, and make it.

    Args:
        found: as ``tuning.result.to_json`` gives it.
        plans: what may be looked at, the most interesting first, each with what draws it; the first
            twelve get pictures.

    Raises:
        UsageError: SC031, plotly is not installed; else as ``Linker.link``.
    """
    texts = texts_of(found, linker)
    shown = [_drawn_plan(found, plan, assignment) for plan, assignment in plans[:MOST_SHOTS]]
    values: dict[Value, Assignment] = {}
    for family, assignment in zip(found["families"], assignments(found, linker.scene), strict=True):
        values.setdefault((family["group"], family["value"]), assignment)
    total, done = len(shown) + len(values), 0

    def drawing(what: str) -> None:
        nonlocal done
        if progress is not None:
            progress(done, total, what)
        done += 1

    with ExitStack() as held:
        if world.size != tuple(found["size"]):
            width, height = found["size"]
            other = world.drawn_apart((width, height), world.scene.view.engine)
            world = held.enter_context(other)
        frame = shown_frame(linker.scene)
        original = original_of(world, linker, frame)
        shots = shots_of(world, linker, shown, frame, drawing)
        payloads = dict(payloads_of(world, linker, values, frame, drawing))
    return tuning_page(found, TunedPictures(original, shots, payloads), texts)


def _drawn_plan(
    found: Mapping[str, Any], plan: Sequence[Sequence[int]], assignment: Assignment
) -> DrawnPlan:
    parts = tuple((number, period) for number, period in plan)
    groups = (found["groups"][found["families"][number]["group"]] for number, _ in parts)
    cached = {name for group in groups for name in group["objects"]}
    left = (name for name, chosen in assignment.objects if chosen is None and name in cached)
    return DrawnPlan(parts, assignment, tuple(left))


def tuning_page(found: Mapping[str, Any], pictures: TunedPictures, texts: TunedTexts) -> bytes:
    """The page, as UTF-8, from what a tuning found, its pictures and its shaders.

    Raises :class:`UsageError` SC031: plotly is not installed.
    """
    kept = _Kept()
    data = {
        "version": __version__,
        "made": datetime.now(UTC).strftime("%Y-%m-%d %H:%M UTC"),
        "metric": METRICS[found["metric"]],
        "legend": {name: [_css(color), words] for name, (color, words) in LEGEND.items()},
        "headline": headline(found),
        "coverage": coverage(found),
        "verdicts": list(verdicts(found)),
        "leftOut": list(left_out(found)),
        "scene": list(texts.scene),
        "sources": [kept.texts(group) for group in texts.groups],
        "families": [
            {
                "way": way_in_words(family, text.instead),
                "kind": _cache_kind(family),
                "files": kept.texts(text.files),
                "command": text.command,
            }
            for family, text in zip(found["families"], texts.families, strict=True)
        ],
        "tuning": found,
    }
    fixed = PARTS.fixed(kept.by_hash)
    data |= _pictures(pictures, PARTS.room(fixed, data))
    return PARTS.page(fixed, f"{found['scene']}: tuned", data)


class _Kept:
    """Texts by hash, each once."""

    def __init__(self) -> None:
        self.by_hash: dict[str, str] = {}

    def texts(self, files: Mapping[str, str]) -> dict[str, str]:
        """The hash of each file, which is kept."""
        hashes = {name: sha256(text.encode()).hexdigest()[:16] for name, text in files.items()}
        self.by_hash |= {hashes[name]: text for name, text in files.items()}
        return hashes


def _cache_kind(family: Mapping[str, Any]) -> str:
    """What families have in common that can share a cache, as tuning combines them."""
    chosen = Configuration.from_json(family["configuration"])
    return f"{chosen.algorithm} {chosen.look_up.key} {chosen.storage.format}"


def _pictures(pictures: TunedPictures, room: int) -> dict[str, Any]:
    """The pictures by name, as many as there is room for, and which shot has which."""
    uris: dict[str, str] = {}
    if pictures.original is not None:
        uris["original"] = lossy_uri(Image.fromarray(picture(pictures.original)))
        room -= len(uris["original"])
    told: list[dict[str, Any]] = []
    for number, one in enumerate(pictures.shots):
        layers = _layers(one, number)
        size = sum(len(uri) for uri in layers.values())
        if size > room:
            break
        room -= size
        uris |= layers
        told.append(_shot(one, number))
    payloads: dict[str, str] = {}
    for (group, value), pixels in (pictures.payloads or {}).items():
        uri = lossy_uri(Image.fromarray(picture(pixels)))
        if len(uri) > room:
            break
        room -= len(uri)
        payloads[f"{group}-{value}"] = name = f"payload-{group}-{value}"
        uris[name] = uri
    return {"pictures": uris, "shots": told, "payloads": payloads}


def _layers(one: PlanShot, number: int) -> dict[str, str]:
    """The pictures of a shot."""
    original, cached = picture(one.shot.original), picture(one.shot.cached)
    probe = one.shot.probe
    difference = Image.fromarray(difference_picture(original, cached))
    return {
        f"cached-{number}": lossy_uri(Image.fromarray(cached)),
        f"difference-{number}": exact_uri(difference),
        f"hits-{number}": exact_uri(Image.fromarray(hit_picture(probe.mask, probe.values))),
    }


def _shot(one: PlanShot, number: int) -> dict[str, Any]:
    shares = {name: share for name, share in one.shot.probe.shares.items() if share > 0.0}
    return {
        "plan": [list(part) for part in one.plan],
        "without": list(one.without),
        "frame": one.frame,
        "layers": {"original": "original"}
        | {layer: f"{layer}-{number}" for layer in ("cached", "difference", "hits")},
        "outcomes": shares,
        "errors": {"rmse": one.error.rmse, "p99": one.error.p99, "max": one.error.maximum},
    }


def _css(color: tuple[int, int, int]) -> str:
    return "#{:02x}{:02x}{:02x}".format(*color)
