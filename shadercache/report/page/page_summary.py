"""What a group of rows says, in sentences.

Text in asterisks is to be emphasised, text in backquotes is code.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from shadercache.caching.algorithms import NAMES
from shadercache.diagnostics import shortened
from shadercache.report.page.page_group import SMALL_ERROR, Measured, PageGroup
from shadercache.report.parts.page_words import (
    algorithm_in_words,
    capital,
    error_in_words,
    listed,
)

_KINDS = {
    "refused": "the compiler refuses",
    "rejected": "the driver does not take",
    "hung": "took too long",
    "crashed": "crashed the driver",
}


def summary(group: PageGroup) -> list[str]:
    """The sentences, the most important one first."""
    if not group.measured:
        failed = "No configuration of this sweep has a result, so there is nothing to draw."
        return [failed, *_failures(group)]
    return [
        *_best(group),
        *_against_peers(group),
        *_by_algorithm(group),
        *_certainty(group),
        *_failures(group),
    ]


def variant_in_words(one: Measured) -> str:
    """Such as "`albedo` in two passes, refreshed every 32 frames"."""
    if one.row.configuration is None:
        return one.row.label
    words = algorithm_in_words(one.row.configuration["algorithm"])
    period = one.row.configuration["refresh"]["period"]
    often = "in every frame" if period == 1 else f"every {period} frames"
    return f"`{_cached(one)}` in {words}, refreshed {often}"


def _cached(one: Measured) -> str:
    """The name of what is cached, or its text where it has no name but its id."""
    payload = one.row.payload
    unnamed = payload is not None and one.row.label in payload.ids
    return shortened(payload.text) if payload is not None and unnamed else one.row.label


def speed_in_words(one: Measured) -> str:
    """Such as "1.70× as fast [1.67–1.75] at an RMSE of .0060"."""
    ratio, error = one.result.times.ratio, error_in_words(one.result.image.rmse)
    return f"{ratio.median:.2f}× as fast [{ratio.low:.2f}–{ratio.high:.2f}] at an RMSE of {error}"


def _best(group: PageGroup) -> Iterator[str]:
    best = group.best
    if best is None:
        yield "*This store holds peers only*: no cached value of this scene has a result."
        return
    limit = error_in_words(SMALL_ERROR)
    small = sum(one.result.image.rmse <= SMALL_ERROR for one in group.variants)
    if small and best.result.times.ratio.median > 1.0:
        yield (
            f"*{capital(variant_in_words(best))}, is {speed_in_words(best)}*: "
            f"the fastest of {small} variants whose error stays below {limit}, "
            f"of {len(group.variants)} in all."
        )
    else:
        what = "The fastest of them is" if small else "The nearest image is that of"
        yield (
            f"*No variant with an RMSE below {limit} is faster than the original.* "
            f"{what} {variant_in_words(best)}: {speed_in_words(best)}."
        )
    fastest = min(group.variants, key=lambda one: one.time)
    if fastest is not best:
        yield (
            f"The fastest variant of all, {variant_in_words(fastest)}, "
            f"is {speed_in_words(fastest)}."
        )


def _against_peers(group: PageGroup) -> Iterator[str]:
    """Who is on the front of all that is faster than the original, by ascending error."""
    if not group.peers or not group.variants:
        return
    front = [one for one in group.front("rmse", group.measured) if one.time < 1.0][::-1]
    if not front:
        yield "Neither caching nor a peer is faster than the original."
        return
    runs: list[list[Measured]] = []
    for one in front:
        if runs and _rival(runs[-1][0]) == _rival(one):
            runs[-1].append(one)
        else:
            runs.append([one])
    parts = [
        f"from {error_in_words(run[0].result.image.rmse)} on {_rival(run[0])} ({_speeds(run)})"
        for run in runs
    ]
    least = error_in_words(front[0].result.image.rmse)
    yield (
        f"Beside what one would do instead: below an RMSE of {least} nothing is faster than the "
        f"original, then the fastest is {listed(parts)}."
    )


def _rival(one: Measured) -> str:
    return one.row.label if one.is_peer else "caching"


def _speeds(run: Sequence[Measured]) -> str:
    ratios = [f"{one.result.times.ratio.median:.2f}×" for one in (run[0], run[-1])]
    return " to ".join(dict.fromkeys(ratios))


def _by_algorithm(group: PageGroup) -> Iterator[str]:
    labels: dict[str, list[Measured]] = {}
    for one in group.variants:
        labels.setdefault(one.row.label, []).append(one)
    several = [same for same in labels.values() if len({one.algorithm for one in same}) > 1]
    if len(several) > 1:
        won = Counter(min(same, key=lambda one: one.time).algorithm for same in several)
        counts = [f"{algorithm_in_words(name)} for {won[name]}" for name in NAMES if won[name]]
        yield f"Of {len(several)} cached values the fastest is {listed(counts)}."
    # A variant is slower only where its whole interval says so.
    slower = sum(one.result.times.ratio.high < 1.0 for one in group.variants)
    if slower:
        yield f"{slower} of {len(group.variants)} variants are slower than the original."


def _certainty(group: PageGroup) -> Iterator[str]:
    ratios = [one.result.times.ratio for one in group.measured]
    widths = sorted((one.high - one.low) / (2.0 * one.median) for one in ratios)
    middle, widest = widths[len(widths) // 2], widths[-1]
    yield (
        f"Every ratio has a 95 % interval: half of them are known to ±{100.0 * middle:.1f} %, "
        f"the least certain to ±{100.0 * widest:.1f} %."
    )


def _failures(group: PageGroup) -> Iterator[str]:
    counts = Counter(row.failure.kind for row in group.rows if row.failure is not None)
    if counts:
        parts = [f"{number} that {_KINDS[kind]}" for kind, number in counts.most_common()]
        total = counts.total()
        are = "is 1 configuration" if total == 1 else f"are {total} configurations"
        yield f"There {are} without a result: {listed(parts)}."
