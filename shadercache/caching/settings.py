"""What ``--cache`` sets, by the words of the command line and of manifests."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import get_args, get_type_hints

from shadercache.caching.configuration import Configuration
from shadercache.diagnostics import usage_error

_FIELDS = {
    "refresh": ("refresh", "schedule"),
    "age": ("refresh", "age"),
    "adaptive": ("refresh", "adaptive"),
    "filter": ("filter", "kind"),
    "fallback": ("filter", "fallback"),
    "magnification": ("hit_test", "magnification"),
    "depth": ("storage", "depth"),
    "tolerance": ("hit_test", "tolerance"),
    "ids": ("hit_test", "ids"),
    "mask": ("hit_test", "mask"),
    "guard": ("storage", "guard"),
    "viewport": ("hit_test", "viewport"),
}
"""Word -> slot of a configuration, and field of the slot."""


LEAST, MOST = 2.0**-126, 2.0**126
"""Numbers that 32-bit floats hold, far from where they end."""

NUMBER = "a number above 0"
"""What stands among choices for any."""


def cache_choices() -> dict[str, tuple[str, ...]]:
    """What can be chosen of each, the default first."""
    plain = written_settings(Configuration())
    hints = get_type_hints(Configuration)
    choices: dict[str, tuple[str, ...]] = {}
    for key, (slot, name) in _FIELDS.items():
        kind = get_type_hints(hints[slot])[name]
        words = get_args(kind) or ("off", NUMBER if kind is float else "on")
        choices[key] = (plain[key], *(word for word in words if word != plain[key]))
    return choices


def with_settings(configuration: Configuration, settings: Sequence[str]) -> Configuration:
    """A configuration with ``key=value`` texts applied, several in one apart by commas; ``ids`` is
    ``ids=on``.

    Raises:
        UsageError: SC028, a key or a value that is not known, or two that do not go together.
    """
    known = cache_choices()
    for setting in (part.strip() for text in settings for part in text.split(",")):
        key, equals, word = setting.partition("=")
        key, word = key.strip().replace("-", "_"), word.strip() if equals else "on"
        if key not in known:
            hint = f"one of {', '.join(known)}"
            raise usage_error("SC028", f"the cache has no option {key!r}", hint)
        slot, name = _FIELDS[key]
        value = {name: _value(key, word, known[key])}
        configuration = replace(
            configuration, **{slot: replace(getattr(configuration, slot), **value)}
        )
    refresh = configuration.refresh
    if refresh.adaptive and (refresh.age or refresh.schedule == "none"):
        other = "age=on" if refresh.age else "refresh=none"
        hint = "it decides itself, within the turns of a schedule, when a payload is too old"
        raise usage_error("SC028", f"the cache's adaptive does not go with {other}", hint)
    return configuration


def _value(key: str, word: str, known: Sequence[str]) -> str | bool | float:
    """What a word means. Raises :class:`UsageError` SC028."""
    if NUMBER in known and word != "off":
        try:
            number = float(word)
        except ValueError:
            number = math.nan
        if LEAST <= number <= MOST:
            return number
    elif word in known:
        return 0.0 if NUMBER in known else word == "on" if "on" in known else word
    hint = f"one of {', '.join(known)}"
    raise usage_error("SC028", f"the cache's {key} cannot be {word!r}", hint)


def written_settings(configuration: Configuration) -> dict[str, str]:
    """The settings as a manifest has them: what :func:`with_settings` reads."""
    words = {}
    for key, (slot, name) in _FIELDS.items():
        value = getattr(getattr(configuration, slot), name)
        words[key] = _word(value)
    return words


def _word(value: str | float) -> str:
    """A value as :func:`with_settings` reads it."""
    if isinstance(value, str):
        return value
    if isinstance(value, bool) or not value:
        return "on" if value else "off"
    return repr(value).removesuffix(".0")
