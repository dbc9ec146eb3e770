"""The fragment shaders of all passes of a node's variants, and of the programs beside them."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from importlib import import_module
from typing import Any, TypeAlias

from shadercache.analysis.candidates import Candidate
from shadercache.caching.algorithms import Algorithm
from shadercache.emit.assemble import Shader
from shadercache.emit.builder import PassBuilder
from shadercache.transform.reachable import names_in

Maker: TypeAlias = Callable[["FragmentEmitter"], Shader]


class FragmentEmitter(PassBuilder):
    """Makes the passes of nodes that are cached together."""

    def made(self, build: Maker) -> Shader:
        """What a maker builds, built once."""
        if build not in self._passes:
            self._passes[build] = build(self)
        return self._passes[build]

    @cached_property
    def _passes(self) -> dict[Maker, Shader]:
        return {}

    def payload_alone(self) -> Shader:
        """The payloads in place of the colour, for their cost (P of P/T)."""
        wanted = {self.own("value"): 0}
        clones = [self.shaded("keep") if self.whole else self.computed()]
        return self.build("passes/payload_alone", clones, (), wanted)

    def hit_mask(self) -> Shader:
        """What the look-up says, for the eyes and for the hit rate."""
        wanted = {self.own("outcome"): 0}
        clones = [self.shaded("keep")] if self.whole else []
        return self.build("passes/hit_mask", clones, (), wanted)

    def needed(self) -> Shader:
        """Which pixels have payloads, for those who count hits: other programs store them."""
        wanted = {self.own("outcome"): 0}
        clones = [self.shaded("keep") if self.whole else self.computed()]
        return self.build("passes/needed", clones, (), wanted)

    def unneeded(self) -> tuple[Candidate, ...]:
        """The nodes that the colour does not need where the others are reused."""
        shade = self.finish("passes/shade", [self.shaded("use")], store=False)
        named = names_in(shade.module)
        return tuple(
            node
            for node, payload in zip(self.nodes, self.payloads, strict=True)
            if payload not in named
        )

    def unfit(self, algorithm: Algorithm) -> str | None:
        """Why the nodes cannot be cached by an algorithm, if so."""
        if algorithm.unfit is None:
            return None
        reason: str | None = function_named(algorithm.unfit)(self)
        return reason


def function_named(text: str) -> Any:
    """A function of this folder, as the table of algorithms writes it: ``module:function``."""
    module, _, name = text.partition(":")
    return getattr(import_module(f"{__package__}.{module}"), name)
