"""What a tuning found, in sentences.

Text in asterisks is to be emphasised, text in backquotes is code.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

from shadercache.caching.configuration import Configuration
from shadercache.diagnostics import shortened
from shadercache.report.parts.page_words import (
    algorithm_in_words,
    capital,
    error_in_words,
    listed,
    settings_in_words,
)

METRICS: Mapping[str, str] = {"rmse": "RMSE", "psnr": "PSNR", "flip": "FLIP", "flicker": "flicker"}
"""The errors that may be asked for, and what they are called."""

_ARTICLES = {"rmse": "an", "psnr": "a", "flip": "a", "flicker": "a"}


def error_of_bound(metric: str, limit: float) -> float:
    """A bound where 0 is no error: of a PSNR the RMSE."""
    return float(10.0 ** (-limit / 20.0)) if metric == "psnr" else limit


def told_error(metric: str, error: float) -> str:
    """An error in the metric, as it is shown."""
    if metric != "psnr":
        return error_in_words(error)
    return f"{-20.0 * math.log10(error):.1f} dB" if error > 0.0 else "infinitely many dB"


def told_limit(metric: str, limit: float) -> str:
    """A bound without its metric: such as ".005", "40 dB"."""
    return f"{limit:g} dB" if metric == "psnr" else f"{limit:g}".removeprefix("0")


def way_in_words(family: Mapping[str, Any], instead: str | None = None) -> str:
    """How a family works, without its value and period: such as "three passes, half rate".

    Args:
        instead: the algorithm that draws it in place of its own; or ``original``.
    """
    chosen = Configuration.from_json(family["configuration"])
    words = [algorithm_in_words(chosen.algorithm), *map(_setting, settings_in_words(chosen))]
    if chosen.refresh.block != Configuration().refresh.block:
        words.append(f"block {chosen.refresh.block}")
    if instead is not None:
        other = "the original" if instead == "original" else algorithm_in_words(instead)
        words.append(f"here drawn by {other}")
    return ", ".join(words)


def _setting(setting: str) -> str:
    """``key=value`` in words."""
    key, _, value = setting.partition("=")
    return {"rate": f"{value} rate", "format": value}.get(key, f"{key} {value}")


def plan_in_words(found: Mapping[str, Any], drawn: Mapping[str, Any]) -> str:
    """Such as "`albedo` in two passes, refreshed every 4 frames"."""
    parts = []
    for number, period in drawn["plan"]:
        family = found["families"][number]
        value = found["groups"][family["group"]]["values"][family["value"]]
        words = f"`{shortened(value['text'])}` in {way_in_words(family)}"
        often = "in every frame" if period == 1 else f"every {period} frames"
        parts.append(f"{words}, refreshed {often}")
    left = f", but {listed(drawn['without'])} left as it is" if drawn["without"] else ""
    return listed(parts) + left


def headline(found: Mapping[str, Any]) -> str:
    """The answer in a sentence."""
    metric, scene = found["metric"], found["scene"]
    kind = f"{_ARTICLES[metric]} {METRICS[metric]} of"
    chosen = [one for one in found["answers"] if one["proven"] is not None]
    left = [told_limit(metric, one["bound"]) for one in found["answers"] if one["proven"] is None]
    if not chosen:
        bounds = listed(left)
        return f"*Leave {scene} alone*: within {kind} {bounds} nothing was proven to be faster."
    best = max(chosen, key=lambda one: _proven(found, one)["speedup"]["median"])
    ratio = _proven(found, best)["speedup"]
    words = plan_in_words(found, _proven(found, best))
    told = (
        f"Within {kind} {told_limit(metric, best['bound'])}, {scene} is drawn "
        f"*{ratio['median']:.2f}× as fast* by caching {words}."
    )
    return f"{told} For {listed(left)} leave it alone." if left else told


def verdicts(found: Mapping[str, Any]) -> Iterator[dict[str, Any]]:
    """For each bound that was asked for: its error, how it is written, a few large words, and
    sentences."""
    metric = found["metric"]
    for answer in found["answers"]:
        told = {
            "error": error_of_bound(metric, answer["bound"]),
            "limit": told_limit(metric, answer["bound"]),
        }
        if answer["proven"] is None:
            yield {**told, "large": "leave it alone", "text": f"{capital(answer['why'])}."}
            continue
        proven = _proven(found, answer)
        ratio = proven["speedup"]
        mean, worst = (told_error(metric, proven[key]) for key in ("mean", "worst"))
        yield {
            **told,
            "large": f"{ratio['median']:.2f}×",
            "small": f"as fast [{ratio['low']:.2f}–{ratio['high']:.2f}]",
            "text": f"{capital(plan_in_words(found, proven))}. On frames that the choice "
            f"had not seen, the error is {mean} on average and {worst} in the worst one.",
        }


def coverage(found: Mapping[str, Any]) -> str:
    """How much of everything was looked at."""
    families = found["families"]
    combinations = _counted(len(families), "combination")
    values = _counted(len({(one["group"], one["value"]) for one in families}), "value")
    return (
        f"*{found['drawn']:,} of {found['combinations']:,} combinations were drawn*, in "
        f"{found['budget']['spent']:.0f} s. Models of time and error were fitted to {combinations} "
        f"of {values}; {_counted(len(found['finalists']), 'plan')} ran at full length, "
        f"{len(found['proven'])} on frames that no choice was made by."
    )


def _counted(number: int, what: str) -> str:
    return f"{number} {what}" if number == 1 else f"{number} {what}s"


def left_out(found: Mapping[str, Any]) -> Iterator[str]:
    """What was not drawn, and why; what could not be."""
    for group in found["groups"]:
        counts = [f"{count:,} {why}" for why, count in group["left_out"].items()]
        if counts:
            yield f"Of the nodes of `{group['fragment']}`, {listed(counts)}."
    untried = sum(len(group["not_drawn"]) for group in found["groups"])
    if untried:
        were = "value was" if untried == 1 else "values were"
        yield f"{untried} {were} not drawn: others promise more, or the time was up."
    for failed in found["failed"]:
        yield f"`{shortened(failed['text'])}` could not be drawn: {failed['why']}."


def _proven(found: Mapping[str, Any], answer: Mapping[str, Any]) -> Mapping[str, Any]:
    proven: Mapping[str, Any] = found["proven"][answer["proven"]]
    return proven
