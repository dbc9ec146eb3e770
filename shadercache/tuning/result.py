"""What tuning found, as plain JSON values: all that a page or a test needs to show it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from shadercache.caching.configuration import Configuration
from shadercache.measure.result_files import plain
from shadercache.scene.description import Scene
from shadercache.tuning.choose import Answer, Tuning
from shadercache.tuning.families import Family, Plan
from shadercache.tuning.groups import ShaderGroup
from shadercache.tuning.laboratory import Drawn
from shadercache.tuning.proof import Proven
from shadercache.tuning.values import Value

SCHEMA_VERSION = 1


def to_json(tuning: Tuning, scene: Scene, where: Mapping[str, Any]) -> Any:
    """Everything; times in seconds or as shares of the original's, numbers without end as null.

    Families, finalists and what was proven are lists; others refer to their entries by number.

    Args:
        where: as ``result_files.environment`` gives it.
    """
    question, drawings = tuning.question, tuning.drawings
    trials = drawings.trials
    families = {id(family): number for number, family in enumerate(trials.families)}
    proven = {id(one): number for number, one in enumerate(tuning.proven)}
    values = _values(tuning)

    def plan(one: Plan) -> list[list[int]]:
        return [[families[id(family)], period] for family, period in one.parts]

    return plain(
        {
            "schema_version": SCHEMA_VERSION,
            "environment": dict(where),
            "scene": scene.name,
            "title": scene.title,
            "size": list(drawings.size),
            "metric": question.bounds[0].metric,
            "bounds": [bound.limit for bound in question.bounds],
            "budget": {"seconds": question.seconds, "spent": drawings.spent},
            "original": drawings.original,
            "combinations": tuning.combinations,
            "drawn": tuning.drawn,
            "periods": list(question.space.periods),
            "groups": [_group(tuning, group, values[group]) for group in tuning.pools],
            "families": [_family(one, values) for one in trials.families],
            "finalists": [
                {
                    "plan": plan(one.plan),
                    "without": list(one.plan.without),
                    "predicted": {"share": one.plan.share, "error": one.plan.error},
                    "drawn": _drawn(one.drawn),
                }
                for one in drawings.finalists
            ],
            "proven": [{"plan": plan(one.plan), **_proven(one)} for one in tuning.proven],
            "answers": [_answer(one, proven, scene) for one in tuning.answers],
            "failed": [
                {"configuration": one.configuration.to_json(), "text": one.text, "why": one.why}
                for one in trials.failed
            ],
        }
    )


def _values(tuning: Tuning) -> dict[ShaderGroup, list[Value]]:
    """All values of each group that were thought of: those tried first, then sets and the like."""
    found = {group: list(pool.values) for group, pool in tuning.pools.items()}
    for family in tuning.drawings.trials.families:
        if not any(family.value is value for value in found[family.group]):
            found[family.group].append(family.value)
    return found


def _group(tuning: Tuning, group: ShaderGroup, values: list[Value]) -> dict[str, Any]:
    hits = tuning.drawings.trials.hits.get(group)
    return {
        "fragment": group.name,
        "objects": list(group.objects),
        "hits": hits,
        "left_out": tuning.pools[group].left_out,
        "values": [_value(group, value) for value in values],
        "not_drawn": _not_drawn(tuning, group, values),
    }


def _not_drawn(tuning: Tuning, group: ShaderGroup, values: Sequence[Value]) -> list[dict[str, Any]]:
    """Values that were not drawn, each with the time that is foretold by static costs, as a share
    of the original's, at the longest period."""
    pool, trials = tuning.pools[group], tuning.drawings.trials
    drawn = {family.value for family in trials.families}
    alike = (one for same in pool.alike.values() for one in same)
    times, longest = trials.static_times(group), tuning.question.space.periods[-1]
    return [
        _value(group, value) | {"foretold": times and times.at(value.share, longest)}
        for value in dict.fromkeys((*values, *alike))
        if value not in drawn
    ]


def _value(group: ShaderGroup, value: Value) -> dict[str, Any]:
    source = group.analysis.fragment
    spans = [node.expr.span for node in value.nodes]
    # What stands in an included file has no place in the shader's own.
    own = [span for span in spans if span.start >= 0 and source.part(span.start) is source]
    return {
        "ids": list(value.ids),
        "text": value.text,
        "type": " + ".join(node.type.name for node in value.nodes),
        "places": [[*source.position(span.start), *source.position(span.end)] for span in own],
        "share": value.share,
        "changes": sorted(value.changes),
    }


def _family(family: Family, values: Mapping[ShaderGroup, list[Value]]) -> dict[str, Any]:
    number = next(at for at, one in enumerate(values[family.group]) if one is family.value)
    return {
        "group": family.group.number,
        "value": number,
        "configuration": family.base.to_json(),
        "time": family.time,
        "error": family.error,
        "scale": family.scale,
        "haste": family.guarded_haste,
    }


def _drawn(drawn: Drawn) -> dict[str, Any]:
    return {"speedup": drawn.speedup, "mean": drawn.mean, "worst": drawn.worst}


def _proven(one: Proven) -> dict[str, Any]:
    return {
        "without": list(one.plan.without),
        "passages": [
            {"name": p.name, "start": p.start, "step": p.step, **_drawn(drawn)}
            for p, drawn in one.passages
        ],
        "speedup": one.speedup,
        "mean": one.mean,
        "worst": one.worst,
    }


def _answer(answer: Answer, proven: Mapping[int, int], scene: Scene) -> dict[str, Any]:
    chosen = answer.chosen
    return {
        "bound": answer.bound.limit,
        "proven": None if chosen is None else proven[id(chosen)],
        "assignment": None if chosen is None else chosen.plan.assignment(scene).to_json(),
        "why": answer.why,
    }


def told(configuration: Configuration) -> str:
    """A configuration in a few words: what differs from the default is named."""
    plain_one = Configuration()
    refresh = configuration.refresh
    words = [configuration.algorithm, f"period {refresh.period}", f"block {refresh.block}"]
    if configuration.payload_rate != "full":
        words.append(f"{configuration.payload_rate} rate")
    if configuration.filter != plain_one.filter:
        words.append(f"filter {configuration.filter.kind}")
    if refresh.adaptive:
        words.append(f"adaptive {refresh.adaptive:g}")
    if configuration.storage != plain_one.storage:
        words.append(configuration.storage.format)
    return ", ".join(words)
