"""A quarter of the pixels is shaded, elsewhere in each frame, and accumulated at full size.

The resolve follows what the survey of Yang et al. 2020 says of temporal upsampling: each pixel
blends what the jittered samples near its centre say into what its point showed before, the more the
nearer a sample is. What it showed is clipped to the colours around, that is to their mean and
deviation (Salvi 2016), in YCoCg (Karis 2014).
"""

from __future__ import annotations

from dataclasses import replace

from bench.peers.lod_bias import sharper_textures
from bench.peers.peer import OF_HISTORY, Peer, PeerShader, read_shader
from bench.peers.reduced_resolution import smaller

PLACES = ((0.25, 0.25), (-0.25, -0.25), (-0.25, 0.25), (0.25, -0.25))
"""Of the jitter, in pixels of the smaller picture: each puts a sample upon one of the four pixels
that share it. Upscalers take more places and smooth edges with them; what is to be met here is a
picture that does not."""


class TemporalUpscaling(Peer):
    """Half the resolution, jittered and accumulated."""

    def make(self) -> None:
        """See ``Peer``."""
        self._engine = replace(self.world.scene.view.engine, places=PLACES)
        self._shaded = self.shaded_apart(smaller(self.world.size, 2), self._engine)
        self._history = self.lent_history()
        shader = PeerShader(
            read_shader("temporal.frag", *OF_HISTORY),
            ("u_size", "u_shift", "u_begins"),
            {"u_color": self._shaded.world.targets.color},
            self._history,
        )
        self._resolve = self.over_objects(shader)

    def draw(self, frame: int) -> None:
        """See ``Peer``."""
        # The samples of several frames make up for what one level of detail would take away.
        with sharper_textures(self.world):
            self._shaded.draw(frame)
        numbers = {
            "u_size": self.world.size,
            "u_shift": self._engine.shift(frame),
            "u_begins": (self.begins(frame),),
        }
        self._resolve.draw(frame, numbers)
