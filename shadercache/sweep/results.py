"""Rows made of what was measured, and of failures."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from datetime import UTC, datetime

from shadercache import __version__
from shadercache.caching.configuration import Configuration
from shadercache.measure.frame_profile import Profile
from shadercache.measure.measurement import (
    Group,
    Measurement,
    NodeResult,
    SubjectResult,
    VariantResult,
)
from shadercache.measure.result_files import plain
from shadercache.measure.statistics import Ratio
from shadercache.render.bundle import Bundle
from shadercache.sweep.pictures import shot_pictures
from shadercache.sweep.plan import SweepTrial
from shadercache.sweep.row import (
    Failure,
    ImageErrors,
    PartEntry,
    RatioEntry,
    ReuseShares,
    Row,
    Samples,
    Times,
    TrialResult,
    Written,
)
from shadercache.sweep.store import hash_of

UNEXPLAINED = "not explained"
"""What is left of a frame beside the parts of its profile."""


class Blobs:
    """Texts and pictures of a trial, each once, by the name that the store has for it."""

    def __init__(self) -> None:
        self.data: dict[str, bytes] = {}

    def add(self, data: bytes) -> str:
        """Keep something; returns its name."""
        name = hash_of(data)
        self.data[name] = data
        return name


def result_rows(
    trial: SweepTrial,
    measurement: Measurement,
    bundles: Mapping[Configuration, Bundle],
    blobs: Blobs,
    profiles: Mapping[Configuration, Profile],
) -> Iterator[Row]:
    """A row for each variant of a measurement.

    Args:
        bundles: the programs of each configuration.
        blobs: shaders and pictures are added to these.
        profiles: where frames go, of those configurations of which it is known.
    """
    shots = {shot.configuration: shot for shot in measurement.shots}
    for group in measurement.groups:
        for node in group.nodes:
            for variant in node.variants:
                configuration = variant.configuration
                bundle, shot = bundles[configuration], shots[configuration]
                texts = {
                    source.name: blobs.add(source.text.encode())
                    for spec in bundle.passes(configuration.algorithm)
                    for source in (spec.vertex, spec.fragment)
                }
                images = {kind: blobs.add(data) for kind, data in shot_pictures(shot)}
                result = TrialResult(
                    _times(group, node, variant, profiles.get(configuration)),
                    image_errors(variant),
                    ReuseShares(
                        variant.hit_rate,
                        variant.burst,
                        dict(variant.outcomes),
                        dict(variant.work),
                        dict(shot.probe.values),
                        variant.bytes_per_pixel,
                    ),
                    measurement.covered,
                )
                yield _row(trial, configuration, result, texts, images)


def failure_row(trial: SweepTrial, configuration: Configuration, failure: Failure) -> Row:
    """The row of a configuration that has no result."""
    return _row(trial, configuration, failure, {}, {})


def _row(
    trial: SweepTrial,
    configuration: Configuration,
    outcome: Failure | TrialResult,
    texts: dict[str, str],
    pictures: dict[str, str],
) -> Row:
    assert trial.machine is not None
    now = datetime.now(UTC).isoformat(timespec="seconds")
    return Row(
        key=trial.key(configuration),
        identity=trial.identity(configuration),
        kind="variant",
        scene=trial.scene,
        payload=trial.payload,
        label=trial.payload.label,
        configuration=configuration.to_json(),
        machine=trial.machine,
        outcome=outcome,
        texts=texts,
        pictures=pictures,
        written=Written(now, __version__),
    )


def _times(
    group: Group, node: NodeResult, variant: VariantResult, profile: Profile | None
) -> Times:
    timing = variant.timing
    return Times(
        ratio=_entry(variant.speedup),
        tail=timing.tail,
        capped=group.reached.capped,
        reset=variant.reset,
        p_over_t=node.ratio,
        floor=variant.floor,
        efficiency=variant.efficiency,
        samples=Samples(timing.samples, group.original.samples, group.geometry.samples),
        profile=() if profile is None else tuple(_parts(profile)),
    )


def _parts(profile: Profile) -> Iterator[PartEntry]:
    for part in profile.parts:
        yield PartEntry(part.name, _entry(part.share))
    yield PartEntry(UNEXPLAINED, _entry(profile.unexplained))


def _entry(ratio: Ratio) -> RatioEntry:
    return RatioEntry(ratio.median, ratio.low, ratio.high, ratio.total)


def image_errors(variant: SubjectResult) -> ImageErrors:
    """What a row holds of the errors of a variant, or of anything else that was drawn."""
    error = plain(variant.error)  # the PSNR of equal images has no end
    return ImageErrors(
        rmse=error["rmse"],
        p99=error["p99"],
        maximum=error["maximum"],
        psnr=error["psnr"],
        frame_rmse=variant.frame_rmse,
        perceived=variant.perceived,
    )
