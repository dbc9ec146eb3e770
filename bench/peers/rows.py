"""What was compared as rows of a result store, where ``shadercache report`` finds it."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from datetime import UTC, datetime

from bench.peers.outcomes import Point, SceneOutcome
from shadercache import __version__
from shadercache.gpu.clock import pick_clock
from shadercache.gpu.context import Gpu
from shadercache.linking.linker import Linker
from shadercache.measure.image_error import Pixels
from shadercache.measure.measurement import ORIGINAL, Group, Measurement, SubjectResult
from shadercache.sweep.fingerprint import scene_fingerprint, short_hash
from shadercache.sweep.pictures import drawn_pictures
from shadercache.sweep.results import Blobs, image_errors
from shadercache.sweep.row import (
    RatioEntry,
    Row,
    Samples,
    SceneEntry,
    Times,
    TrialResult,
    Written,
)
from shadercache.sweep.trial_room import machine_of


def peer_rows(
    gpu: Gpu, linker: Linker, measured: Measurement, outcome: SceneOutcome, blobs: Blobs
) -> Iterator[Row]:
    """A row for each peer; a sweep has the variants.

    Args:
        outcome: of the measurement; its ratios are of two frames each.
        blobs: pictures are added to these.
    """
    scene, [group] = linker.scene, measured.groups
    machine = machine_of(gpu, pick_clock(gpu))
    entry = SceneEntry(
        scene.name, str(scene.path), measured.size, measured.options.frames, linker.analysis.mapping
    )
    points = {point.label: point for point in outcome.points if point.kind == "peer"}
    fingerprint = scene_fingerprint(linker)
    for label, other, shown in _peers(group, measured, points):
        images = drawn_pictures(measured.pictures[ORIGINAL], shown)
        identity = short_hash([label, scene.name, entry.size, entry.frames, str(machine)])
        samples = Samples(other.timing.samples, group.original.samples, group.geometry.samples)
        yield Row(
            key=short_hash([fingerprint, identity]),
            identity=identity,
            kind="peer",
            scene=entry,
            payload=None,
            label=label,
            configuration=None,
            machine=machine,
            outcome=TrialResult(
                Times(
                    ratio=_ratio(points[label], samples),
                    tail=other.timing.tail,
                    capped=group.reached.capped,
                    reset=None,
                    p_over_t=None,
                    floor=None,
                    efficiency=None,
                    samples=samples,
                ),
                image_errors(other),
                None,
                measured.covered,
            ),
            texts={"source.frag": blobs.add(linker.analysis.fragment.text.encode())},
            pictures={kind: blobs.add(data) for kind, data in images},
            written=Written(datetime.now(UTC).isoformat(timespec="seconds"), __version__),
        )


def _peers(
    group: Group, measured: Measurement, labels: Collection[str]
) -> Iterator[tuple[str, SubjectResult, Pixels]]:
    """Label, result and image of each peer; the cached colour is drawn as variants are."""
    shots = {shot.label: shot.cached for shot in measured.shots}
    for node in group.nodes:
        if node.label in labels:
            yield node.label, node.variants[0], shots[node.label]
    for other in group.others:
        yield other.label, other, measured.pictures[other.label]


def _ratio(point: Point, samples: Samples) -> RatioEntry:
    total = sum(samples.original) / sum(samples.subject)
    return RatioEntry(point.ratio, point.low, point.high, total)
