"""The original in every second frame, and between them the last one, warped to where things are.

This is frame reprojection as headsets and frame generators do it, but with exact motion: the
objects are drawn by bare vertex programs, and each pixel fetches what the last frame showed at its
place. Where that was hidden, a pixel nearby of the last frame that fits its depth is taken.
"""

from __future__ import annotations

from bench.peers.peer import OF_DEPTH, Peer, PeerShader, own_surface, read_shader


class HalfRate(Peer):
    """Even frames are the original, odd ones are made of the frame before."""

    def make(self) -> None:
        """See ``Peer``."""
        self._original = self.shaded_apart(self.world.size)
        last = self._original.world.targets
        self._numbers = {"u_size": self.world.size, **own_surface(self.world)}
        shader = PeerShader(
            read_shader("half_rate.frag", *OF_DEPTH, "reproject.glsl"),
            tuple(self._numbers),
            {"u_color": last.color, "u_depth": last.depth_texture},
        )
        self._warp = self.over_objects(shader)

    def draw(self, frame: int) -> None:
        """See ``Peer``."""
        if frame % 2 == 0 or self.begins(frame):
            self._original.draw(frame)
            self._show()
        else:
            self._warp.draw(frame, self._numbers)

    def _show(self) -> None:
        """Copy the original's picture into the world's target: it is wanted once more."""
        source, target = self._original.world.targets, self.world.targets
        self.world.gpu.ctx.copy_framebuffer(
            target.framebuffer((target.color,), None), source.framebuffer((source.color,), None)
        )
