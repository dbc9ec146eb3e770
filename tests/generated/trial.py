"""One generated shader under the laws: what is wrong with it, in words."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
import traceback
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from contextlib import closing, contextmanager, suppress
from dataclasses import dataclass, field
from itertools import combinations
from pathlib import Path

import moderngl
import numpy as np
from laws.slices import NIGHTLY
from numpy.typing import NDArray

from shadercache.analysis.candidates import Candidate
from shadercache.caching.algorithms import NAMES, USUAL
from shadercache.compiler import Analysis, Emission, analyse
from shadercache.diagnostics import InputError
from shadercache.front.read_options import ReadOptions
from shadercache.gpu.context import Gpu
from shadercache.render.bundle import Bundle
from shadercache.sema.facts import Stage
from shadercache.source import Source
from shadercache.transform.unique_names import make_names_unique
from shadercache.valid.read import read
from shadercache.verify import laws
from shadercache.verify.verdict import Difference, Image, Verdict
from shadercache.verify.verifier import Verifier
from tests.configured import PROOF, configured, rewritten, variant

from .dialects import Dialect
from .law8 import apart_derivatives
from .reach import near
from .world import SIZE, ring, scene

Nodes = tuple[Candidate, ...]
"""What is cached together."""

Chooser = Callable[[Sequence[Candidate], Sequence[Candidate]], Sequence[Candidate]]
"""Chooses from all legal nodes, and those of them that may come to what fragments share."""

ROUNDING = 1e-3
"""What rounding may change, absolutely and relatively: sums and sines of a hundred operations."""

MOST_APART = 0.25
"""Share of the pixels in which rounding may decide a condition, and so change whatever follows."""

UNRAISED = ("gl330", "es300")
"""Dialects whose text the driver is given as it is."""

SHIPPED = configured(mode="plain", form="rgba32f")

SHARING = re.compile(r"\bdFd|\bfwidth|\btexture")
"""What a text without derivatives has not."""

REFERENCE = shutil.which("glslangValidator")


@dataclass
class Report:
    """What came out of one shader; ``problems`` is empty where all is well."""

    problems: list[str] = field(default_factory=list)
    codes: Counter[str] = field(default_factory=Counter)
    algorithms: Counter[str] = field(default_factory=Counter)
    nodes: int = 0
    finite: bool = True
    turned_down: bool = False
    """The driver does not take the user's own text, which it should."""
    plain: list[float] = field(default_factory=list)
    """Of each plain variant: the share of pixels that differ from the original by any bit."""


def try_shader(gpu: Gpu, text: str, dialect: Dialect, chooser: Chooser) -> Report:
    """Check the laws on the legal nodes that ``chooser`` takes, and all programs of theirs.

    A crash is a problem like any other, so that a smallest shader is found for it too.
    """
    report = Report()
    try:
        _try(gpu, text, dialect, chooser, report)
    except Exception as error:
        report.problems.append(f"{type(error).__name__}: {error}\n{traceback.format_exc()}")
    return report


def _try(gpu: Gpu, text: str, dialect: Dialect, chooser: Chooser, report: Report) -> None:
    analysis = analyse(Source("made.frag", text), Source("made.vert", dialect.vertex))
    for node in analysis.nodes:
        report.codes[node.refusal.code.code if node.refusal else "offered"] += 1
    legal = [node for node in analysis.nodes if node.legal]
    chosen = chooser(legal, near(analysis.program.module, legal))
    report.nodes = len(chosen)
    sets = [*((node,) for node in chosen), *_together(analysis, chosen)]
    made = [(nodes, _rewritten(analysis, nodes)) for nodes in sets]
    plain = [rewritten(analysis, chosen[0], SHIPPED, unprofitable=True)] if chosen else []
    report.turned_down = _turned_down(gpu, text, dialect)
    if not report.turned_down:
        report.problems += _drawn(gpu, analysis, made, plain, report, dialect.es)
    texts = {"user.frag": text, "user.vert": dialect.vertex}
    for number, (_, emission) in enumerate(made):
        texts |= {f"{number}-{name}": content for name, content in emission.files.items()}
    for emission in plain:  # what is shipped, for one node: emission takes most of the time
        texts |= {f"plain-{name}": content for name, content in emission.files.items()}
    texts = {
        name: content
        for content, name in {content: name for name, content in reversed(texts.items())}.items()
    }
    report.problems += _read(texts)
    report.problems += _compiled(texts)


def _turned_down(gpu: Gpu, text: str, dialect: Dialect) -> bool:
    """Is there nothing to compare with? Mesa looks for the names of a ``do`` loop's condition among
    those of its body where that has a ``continue`` (22.3.6), and finds others of other types."""
    if dialect.name not in UNRAISED:
        return False
    try:
        gpu.ctx.program(vertex_shader=dialect.vertex, fragment_shader=text).release()
    except moderngl.Error:
        return True
    return False


def _together(analysis: Analysis, nodes: Sequence[Candidate]) -> Iterator[Nodes]:
    """Two of the nodes that may be cached together, if there are any."""
    for pair in combinations(nodes, 2):
        with suppress(InputError):
            analysis.require_all(pair, unprofitable=True)
            yield pair
            return


def _rewritten(analysis: Analysis, nodes: Nodes) -> Emission:
    # What is taken only by name is tried at night.
    names = NAMES if os.environ.get(NIGHTLY) else USUAL
    return rewritten(analysis, nodes, PROOF, names, unprofitable=True)


def _drawn(
    gpu: Gpu,
    analysis: Analysis,
    made: Sequence[tuple[Nodes, Emission]],
    plain: Sequence[Emission],
    report: Report,
    es: bool,
) -> Iterator[str]:
    """What laws 1 to 4 say."""
    try:
        verifier = Verifier(gpu, (scene(), analysis), SIZE, ring())
    except InputError as error:
        yield f"the original cannot be drawn: {error}"
        return
    with closing(verifier), zeros_alike():
        found = verifier.round_trip()
        if found is None or not found.exact:
            yield f"law 1: {found}"
        for emission in plain:
            shares = _plain_shares(verifier, Bundle(emission.manifest, emission.files), report)
            if not es and max(shares) > MOST_APART:
                yield f"plain mode changes {max(shares):.0%} of the pixels by more than rounding"
        # In GLSL ES plain mode may round to the 16 bits of mediump, in constants too (Mesa).
        if not es and (share := _apart(verifier)) > MOST_APART:
            yield f"the original in proof mode differs from the plain one in {share:.0%} of pixels"
        seen = verifier.references
        image = seen.world.targets.image()[seen.covered[-1]]
        report.finite = bool(np.isfinite(image).all())
        for nodes, emission in made:
            bundle = Bundle(emission.manifest, emission.files)
            verdict = Verdict(*(bundle.node(key) for key in ("id", "path", "text")), True)
            try:
                laws.judge(verifier.references, bundle, verdict)
            except InputError as error:
                verdict.failure = str(error)
            report.algorithms.update(verdict.algorithms)
            report.algorithms["of a set"] += len(nodes) > 1
            refused = list(bundle.refused)
            report.algorithms.update(f"{name} refused" for name in refused)
            if verdict.broken:
                what = ", ".join(verdict.broken)
                yield f"'{verdict.text}' in {verdict.path}: {what} {verdict.failure}".rstrip()


def _apart(verifier: Verifier) -> float:
    """The share of pixels that proof mode changes by more than rounding.

    Its original is made by passes that variants go through as well, so that the laws alone would
    not see what those break in both. Where a rounding decides a condition, some pixels may differ.
    """
    images, covered = verifier.references.images, verifier.references.covered[0]
    plain, proof = (images[mode][0][covered] for mode in ("plain", "proof"))
    return _share_apart(plain, proof)


def _share_apart(image: Image, reference: Image) -> float:
    near = np.isclose(image, reference, rtol=ROUNDING, atol=ROUNDING, equal_nan=True)
    return 1.0 - float(near.all(axis=-1).mean())


def _plain_shares(verifier: Verifier, bundle: Bundle, report: Report) -> list[float]:
    """For each algorithm, in how many pixels plain mode differs by more than rounding."""
    found = []
    covered, reference = verifier.references.covered[1], verifier.references.images["plain"][1]
    for name in bundle.algorithms:
        with variant(verifier.references.world, bundle, name, period=1) as runner:
            runner.draw(0)
            image = runner.image(1)
        report.plain.append(laws.difference(image, reference, covered).changed)
        found.append(_share_apart(image[covered], reference[covered]))
    return found


@contextmanager
def zeros_alike() -> Iterator[None]:
    """Zeros are equal whatever their sign.

    Drivers drop ``+ 0.0`` where they know the zero, in precise expressions too (Mesa), and a
    payload from the cache they do not know; generated shaders are full of such sums.
    """
    strict = laws.difference

    def lenient(image: Image, reference: Image, covered: NDArray[np.bool_]) -> Difference:
        zero = np.float32(0.0)  # -0 + 0 is +0, and nothing else that is finite changes
        same_type = image.dtype == np.float32
        return strict(
            image + zero if same_type else image,
            reference + zero if same_type else reference,
            covered,
        )

    laws.difference = lenient
    try:
        yield
    finally:
        laws.difference = strict


def _read(texts: dict[str, str]) -> Iterator[str]:
    """Every program, and the original, by our own checker and by law 8: derivatives that fragments
    take apart, where those of the original are taken together."""
    apart = dict[str, list[str]]()
    for name, text in texts.items():
        stage: Stage = "fragment" if name.endswith(".frag") else "vertex"
        try:
            module, facts = read(Source(name, text), stage, ReadOptions(), needs_main=True)
        except InputError as error:
            yield f"our own checker, {name}: {error}\n{text}"
            continue
        if stage == "fragment" and SHARING.search(text):
            apart[name] = apart_derivatives(make_names_unique(module, facts))
    if not apart.get("user.frag"):
        for name, found in apart.items():
            for item in found:
                yield f"law 8, {name}: '{item}' is not taken by all\n{texts[name]}"


def _compiled(texts: dict[str, str]) -> Iterator[str]:
    """Errors of the reference compiler, and warnings that the original does not draw."""
    if REFERENCE is None:
        return
    with tempfile.TemporaryDirectory() as folder:
        for name, text in texts.items():
            Path(folder, name).write_text(text, encoding="utf-8")
        done = subprocess.run(
            [REFERENCE, *texts], cwd=folder, capture_output=True, text=True, check=False
        )
    name, known = "", set[str]()
    for line in done.stdout.splitlines():
        if line in texts:
            name = line
        elif line.startswith(("ERROR:", "WARNING:")):
            words = line.split(": ", 3)[-1]
            if name.startswith("user.") and line.startswith("WARNING:"):
                known.add(words)
            elif words not in known:
                yield f"the reference compiler, {name}: {line}\n{texts.get(name, '')}"
