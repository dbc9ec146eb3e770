"""What the papers claim, and what became of each claim here.

T1 to T15 are the trends of Sitthi-amorn et al. 2008 and of Scherzer et al. 2010; the others are
numbers of these and of the papers before them.
"""

from __future__ import annotations

from dataclasses import dataclass

PAPER = "Sitthi-amorn et al. 2008"
COURSE = "Scherzer et al. 2010"
SKETCH = "Nehab et al. 2006"
LONG = "Nehab et al. 2006, course"


@dataclass(frozen=True, slots=True)
class Claim:
    """One statement of a paper, in short; ``section`` says where it stands."""

    id: str
    paper: str
    section: str
    sentence: str


@dataclass(frozen=True, slots=True)
class Verdict:
    """A claim beside what was measured.

    ``confirmed`` is None where what was measured cannot tell, which ``numbers`` explains.
    """

    claim: str
    confirmed: bool | None
    numbers: str

    @property
    def word(self) -> str:
        """The verdict in words."""
        return {True: "confirmed here", False: "refuted here", None: "not decided here"}[
            self.confirmed
        ]


_ALL = (
    Claim("T1", PAPER, "4.1", "Three passes are the fastest for almost every node."),
    Claim("T2", PAPER, "4.1", "Two passes generally beat one where P/T is high."),
    Claim(
        "T3",
        PAPER,
        "4.1",
        "As 1 - P/T grows two passes get slower, and reuse itself gains less.",
    ),
    Claim(
        "T4",
        PAPER,
        "4.1",
        "The overhead of three passes does not depend on how much dearer a miss is than a hit; "
        "that of one and two passes does.",
    ),
    Claim(
        "T5",
        PAPER,
        "4.1",
        "Writing two render targets costs more than an extra pass of the geometry for almost "
        "every node.",
    ),
    Claim("T6", PAPER, "4.1", "The advantage of three passes over two shrinks as P/T rises."),
    Claim("T7", PAPER, "4.1", "The outliers are values whose work both passes do (overlap)."),
    Claim("T8", PAPER, "4.2", "The time drops steadily with the period, ever less."),
    Claim("T8b", PAPER, "4.2", "The improvement with the period decays exponentially."),
    Claim(
        "T9", PAPER, "4.2", "From blocks of 1 x 1 to 2 x 2 the time drops for all three algorithms."
    ),
    Claim(
        "T10",
        PAPER,
        "4.2",
        "From 2 x 2 to 4 x 4 nothing changes (but for one pass on one of two cards), nor beyond.",
    ),
    Claim("T11", COURSE, "3.4.1", "One pass gains little at any period."),
    Claim(
        "T12a", COURSE, "3.4.1", "At short periods two passes can take longer than the original."
    ),
    Claim("T12b", COURSE, "3.4.1", "Three passes reduce the time consistently."),
    Claim(
        "T13",
        COURSE,
        "3.4.1, equations 2 and 3",
        "T(n) = g T_hit + (1 - g) T_miss with g = mu (1 - 1/n) agrees closely with three passes.",
    ),
    Claim(
        "T14a",
        COURSE,
        "3.4.2, equation 5",
        "The error over the period is alpha (1 - exp(-lambda (n - 1))): it rises and saturates.",
    ),
    Claim(
        "T14b",
        COURSE,
        "3.4.3, figure 11",
        "Error and time tend to four clusters: A, inside the noise, fast and near; B, cheap and "
        "view-dependent, slow and far; C, nearly all, the fastest and far; D, overlap, no gain.",
    ),
    Claim(
        "T15",
        PAPER,
        "4.2",
        "Refreshed blocks have to be aligned to the 2 x 2 quads of the hardware.",
    ),
    Claim("N1", PAPER, "2.1", "A pixel in every period is refreshed in each frame (equation 1)."),
    Claim("N2", PAPER, "2.1", "Refreshes happen in contiguous squares of k x k pixels."),
    Claim("N3", PAPER, "figure 5", "Misses occur at disocclusions."),
    Claim("N4", SKETCH, "the sketch", "More than 90 % of the pixels are found again."),
    Claim(
        "N5",
        COURSE,
        "3.5",
        "Trash can, 24 of 25 samples cached, refreshed every fourth frame: 2.1 times as fast.",
    ),
    Claim("N6", COURSE, "3.5", "Chess, the static pieces' occlusion cached: 8 times as fast."),
    Claim("N7", COURSE, "3.5", "Chess, all occlusion cached: 15 times as fast, or more."),
    Claim("N8", COURSE, "3.2.4", "A counter beside the payload bounds its age by the period."),
    Claim(
        "N9",
        COURSE,
        "3.2.3",
        "Filters of a higher order (Lanczos2, Mitchell) blur a third to a half less.",
    ),
)

CLAIMS = {claim.id: claim for claim in _ALL}
"""By id, in the order of the page."""

ELSEWHERE = (
    (
        Claim(
            "", COURSE, "3.4.2, equation 4", "Blur by bilinear resampling: n (v (1 - v)) of both."
        ),
        "./dev stress S3",
    ),
    (
        Claim("", COURSE, "3.2.2", "Numbers of objects in the cache keep trails away."),
        "./dev stress S5",
    ),
    (
        Claim("", LONG, "6.4.3", "A draw can be kept out of the cache by an invalid depth."),
        "./dev stress S6",
    ),
    (
        Claim("", COURSE, "3.2.4", "A period for each block that follows how the signal changes."),
        "shadercache bench chess --nodes whole --passes 2 --period 64 --cache adaptive=0.02",
    ),
)
"""Claims that other commands test."""

NOT_BUILT = (
    Claim("", COURSE, "3.2.3", "Trilinear look-ups where surfaces shrink."),
    Claim("", COURSE, "3.3", "Value and period chosen by models of error and time."),
    Claim("", LONG, "6.5.1", "Stereo: 28 to 44 frames a second, with view-dependence 39."),
    Claim("", LONG, "6.5.2", "Motion blur: twice the samples at equal time."),
    Claim("", LONG, "6.5.3", "Depth of field: more than twice the samples at equal time."),
    Claim("", LONG, "6.4.5", "Supersampling over time: a quarter of the variance in ten frames."),
    Claim("", LONG, "6.5.4", "Bumped environment maps: 4 cached taps at 160 fps for 9 at 98."),
    Claim("", LONG, "6.5.5", "Shadow maps: 4 taps over time as good as 16."),
    Claim("", LONG, "6.6", "Tiles over time: almost twice as fast."),
    Claim(
        "", COURSE, "4.2.2", "Four subpixel buffers: better than 4 x 4 samples, six times faster."
    ),
    Claim("", COURSE, "4.4.1", "Pixel-correct shadows after about 60 frames."),
    Claim("", COURSE, "4.4.2", "Soft shadows near the cost of hard ones."),
    Claim("", COURSE, "4.5.1", "Screen-space occlusion over time: 45 frames a second for 23."),
    Claim("", COURSE, "4.5.2", "Imperfect shadow maps with confidence, 256 lights."),
    Claim("", COURSE, "4.6", "Spatio-temporal upsampling: 11 times as fast."),
    Claim("", COURSE, "5.1", "Occlusion culling with coherent queries: 2 to 3 times as fast."),
    Claim("", COURSE, "5.2", "Incremental instant radiosity: 1.4 to 6.8 times as fast."),
    Claim("", "Drobot 2011", "7.4", "Occlusion and shadows at half resolution with history."),
)
"""Headline numbers of what is not built yet."""
