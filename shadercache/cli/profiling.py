"""``bench --profile``: where frames go, as tables and JSON."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from shadercache.cli.measuring import opened
from shadercache.cli.options import PictureOptions
from shadercache.cli.tables import format_table

if TYPE_CHECKING:
    from shadercache.caching.configuration import Configuration
    from shadercache.linking.linker import Linker
    from shadercache.measure.frame_profile import Profile
    from shadercache.measure.measurement import MeasureOptions
    from shadercache.measure.statistics import Ratio


def profiled(
    linker: Linker,
    configurations: Sequence[Configuration],
    how: MeasureOptions,
    drawn: PictureOptions,
) -> list[Profile]:
    """Where frames of some configurations go."""
    from shadercache.measure.frame_profile import profile

    profiles = []
    for configuration in configurations:
        with opened(linker, drawn, "profile") as (world, tell):
            profiles.append(profile(world, linker, configuration, how, tell))
    return profiles


def profile_table(profile: Profile, label: str) -> str:
    """The parts of a frame, as text."""
    refresh, original = profile.configuration.refresh, 1e3 * profile.original
    frame = profile.frame.median
    named = [(part.name, part.share) for part in profile.parts]
    rows = [
        _row(name, share, original, frame)
        for name, share in (*named, ("not explained", profile.unexplained), ("all", profile.frame))
    ]
    return (
        f"where a frame of {profile.configuration.algorithm} goes: {label}, "
        f"period {refresh.period}, block {refresh.block}; the original takes {original:.1f} ms\n"
        + format_table(("part", "ms", "interval", "share"), rows, right="ms interval share")
    )


def _row(name: str, share: Ratio, original: float, frame: float) -> tuple[str, ...]:
    low, high = original * share.low, original * share.high
    milliseconds = f"{original * share.median:.2f}"
    return name, milliseconds, f"{low:.2f} to {high:.2f}", f"{share.median / frame:.1%}"


def to_json(profiles: Sequence[Profile]) -> list[dict[str, Any]]:
    """Plain values: shares of the original's frame, whose time is in seconds."""
    return [
        asdict(profile) | {"configuration": profile.configuration.to_json()} for profile in profiles
    ]
