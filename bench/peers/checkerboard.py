"""Every second pixel is shaded, like the fields of a checkerboard, the others in the next frame.

What is missing is fetched from the last picture by reprojection, kept within the colours of the
four fresh neighbours, and is the mean of these where it was hidden (El Mansouri 2016, Wihlidal
2017). Consoles shade the fields as two samples of a multisampled picture of half the width and
height; OpenGL cannot place these, so two such pictures are drawn, shifted by half a pixel.
"""

from __future__ import annotations

from dataclasses import replace

from bench.peers.lod_bias import sharper_textures
from bench.peers.peer import OF_HISTORY, Peer, PeerShader, read_shader
from bench.peers.reduced_resolution import smaller
from shadercache.render.pass_runners import OriginalRunner

# Shifts in pixels of the smaller picture that put its samples upon a pixel of each 2 x 2, by its
# column and row there. A shift moves the picture, so the samples go the other way.
_UPON = {
    (x, y): (0.25 if x == 0 else -0.25, 0.25 if y == 0 else -0.25) for x in (0, 1) for y in (0, 1)
}


class Checkerboard(Peer):
    """Half of the pixels are shaded in each frame, the others come from the last picture."""

    def make(self) -> None:
        """See ``Peer``."""
        self._lower, self._upper = (self._fields(row) for row in (0, 1))
        self._history = self.lent_history()
        shader = PeerShader(
            read_shader("checkerboard.frag", *OF_HISTORY),
            ("u_size", "u_turn", "u_begins"),
            {
                "u_lower": self._lower.world.targets.color,
                "u_upper": self._upper.world.targets.color,
            },
            self._history,
        )
        self._fill = self.over_objects(shader)

    def _fields(self, row: int) -> OriginalRunner:
        """Shades the fields in the lower (0) or upper rows: in even frames on one diagonal, in odd
        ones on the other."""
        places = (_UPON[row, row], _UPON[1 - row, row])
        engine = replace(self.world.scene.view.engine, places=places)
        return self.shaded_apart(smaller(self.world.size, 2), engine)

    def draw(self, frame: int) -> None:
        """See ``Peer``."""
        # A pixel of the smaller picture is two of the screen's wide, which is a level of detail.
        with sharper_textures(self.world):
            self._lower.draw(frame)
            self._upper.draw(frame)
        numbers = {
            "u_size": self.world.size,
            "u_turn": (frame % 2,),
            "u_begins": (self.begins(frame),),
        }
        self._fill.draw(frame, numbers)
