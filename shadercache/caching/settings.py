"""What ``--cache`` sets, by the words of the command line and of manifests."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import get_args, get_type_hints

from shadercache.caching.configuration import Configuration
from shadercache.diagnostics import usage_error

_FIELDS = {
    "refresh": ("refresh", "schedule"),
    "age": ("refresh", "age"),
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


def cache_choices() -> dict[str, tuple[str, ...]]:
    """What can be chosen of each, the default first."""
    plain = written_settings(Configuration())
    hints = get_type_hints(Configuration)
    choices: dict[str, tuple[str, ...]] = {}
    for key, (slot, name) in _FIELDS.items():
        words = get_args(get_type_hints(hints[slot])[name]) or ("off", "on")
        choices[key] = (plain[key], *(word for word in words if word != plain[key]))
    return choices


def with_settings(configuration: Configuration, settings: Sequence[str]) -> Configuration:
    """A configuration with ``key=value`` texts applied, several in one apart by commas; ``ids`` is
    ``ids=on``.

    Raises:
        UsageError: SC028, a key or a value that is not known.
    """
    known = cache_choices()
    for setting in (part.strip() for text in settings for part in text.split(",")):
        key, equals, word = setting.partition("=")
        key, word = key.strip().replace("-", "_"), word.strip() if equals else "on"
        if key not in known:
            hint = f"one of {', '.join(known)}"
            raise usage_error("SC028", f"the cache has no option {key!r}", hint)
        if word not in known[key]:
            hint = f"one of {', '.join(known[key])}"
            raise usage_error("SC028", f"the cache's {key} cannot be {word!r}", hint)
        slot, name = _FIELDS[key]
        value = {name: word == "on" if "on" in known[key] else word}
        configuration = replace(
            configuration, **{slot: replace(getattr(configuration, slot), **value)}
        )
    return configuration


def written_settings(configuration: Configuration) -> dict[str, str]:
    """The settings as a manifest has them: what :func:`with_settings` reads."""
    words = {}
    for key, (slot, name) in _FIELDS.items():
        value = getattr(getattr(configuration, slot), name)
        words[key] = value if isinstance(value, str) else ("on" if value else "off")
    return words
