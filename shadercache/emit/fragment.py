"""The fragment shaders of all passes of a node's variants."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

from shadercache.analysis.candidates import Candidate
from shadercache.ast import nodes as n
from shadercache.ast.walk import walk
from shadercache.emit.assemble import Shader
from shadercache.emit.builder import PassBuilder
from shadercache.emit.one_pass import one_pass, unfit_as_made, unfit_for_one_pass
from shadercache.transform.reachable import names_in
from shadercache.transform.specialise import CutKind


class FragmentEmitter(PassBuilder):
    """Makes the passes of nodes that are cached together. Each method returns a finished shader."""

    def made(self, build: Callable[[FragmentEmitter], Shader]) -> Shader:
        """The pass that one of the following methods builds, built once."""
        if build not in self._passes:
            self._passes[build] = build(self)
        return self._passes[build]

    @cached_property
    def _passes(self) -> dict[Callable[[FragmentEmitter], Shader], Shader]:
        return {}

    def one(self) -> Shader:
        """One pass: look up, else compute; then shade."""
        return one_pass(self)

    def hit(self) -> Shader:
        """Two passes, first. The discard comes last where the shading takes derivatives, where a
        loop writes into an array, and where the payload decides on a loop: there it is certain that
        fragments without a payload leave the loop, whatever a driver does behind a discard."""
        if self.whole:
            early = self.finish("passes/here", [self.shaded("need")], both=True)
        else:
            early = self.finish("passes/hit", [self.shaded("use")], both=True)
        if (
            not self.takes_derivatives(early.module)
            and not _loops_over_arrays(early.module)
            and not self.decides_loops
        ):
            return early
        if self.whole:
            return self.finish("passes/here_late", [self.shaded("lack")], both=True)
        return self.finish("passes/hit_late", [self.shaded("use")], both=True)

    def miss(self) -> Shader:
        """Two passes, second: the original, keeping the payload."""
        kind: CutKind = "keep" if self.whole else "store"
        return self.finish("passes/miss", [self.shaded(kind)], both=True)

    def reuse(self) -> Shader:
        """Three passes, first: carry payloads over. What the shader discards is discarded, and
        where it takes derivatives for that, the misses are discarded behind them."""
        early = self.finish("passes/reuse", [self.shaded("use")] if self.whole else [])
        if not self.takes_derivatives(early.module):
            return early
        return self.finish("passes/reuse_late", [self.shaded("use")])

    def payload_only(self) -> Shader:
        """Three passes, second: compute payloads."""
        if self.whole:
            return self.finish("passes/miss", [self.shaded("keep")])
        return self.finish("passes/payload", [self.computed()])

    def shade(self) -> Shader:
        """Three passes, third: the colour from the payload."""
        return self.finish("passes/shade", [self.shaded("use")], store=False)

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
        named = names_in(self.made(FragmentEmitter.shade).module)
        return tuple(
            node
            for node, payload in zip(self.nodes, self.payloads, strict=True)
            if payload not in named
        )

    def unfit(self, passes: int) -> str | None:
        """Why the nodes cannot be cached in so many passes, if so."""
        if passes == 1:
            return unfit_for_one_pass(self) or unfit_as_made(self, self.made(FragmentEmitter.one))
        if passes == 3 and self.decides_loops:
            return (
                "the value decides how long a loop runs, and in the last of three passes fragments "
                "along edges read the payloads of others, with which it might never end"
            )
        return None


def _loops_over_arrays(module: n.Module) -> bool:
    """Does a loop use an element of something? Behind a discard llvmpipe writes it wrongly, and
    what is written by a function or in part is not told from what is read."""
    loops = (item for item in walk(module) if isinstance(item, n.For | n.While | n.DoWhile))
    return any(isinstance(item, n.Index) for loop in loops for item in walk(loop))
