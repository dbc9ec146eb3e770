"""Shading at half or a quarter of the resolution, brought back to full size in two ways.

*Bilinear*: the small picture is stretched over the screen. *Depth-aware*: the objects are drawn
again at full size, and each pixel takes of the four texels around it those of its own surface. That
is the joint bilateral upsampling of Kopf et al. 2007 with depth as the guide, as in Yang et al.
2008, but texels count or do not, as in Jansen and Bavoil 2011: so one gather and one bilinear fetch
do. A texel's depth is compared with the plane of the triangle at hand, so that slanted surfaces are
no edges.
"""

from __future__ import annotations

from bench.peers.peer import OF_DEPTH, Peer, PeerShader, own_surface, read_shader
from bench.peers.scene_programs import ScenePrograms


def smaller(size: tuple[int, int], divisor: int) -> tuple[int, int]:
    """The size that many times smaller, at least a pixel."""
    return max(1, size[0] // divisor), max(1, size[1] // divisor)


class BilinearUpsampling(Peer):
    """The picture is shaded small and stretched."""

    def __init__(self, label: str, programs: ScenePrograms, frames: int, divisor: int) -> None:
        super().__init__(label, programs, frames)
        self._divisor = divisor

    def make(self) -> None:
        """See ``Peer``."""
        self._shaded = self.shaded_apart(smaller(self.world.size, self._divisor))
        color = self._shaded.world.targets.color
        self._stretch = self.over_screen(
            PeerShader(read_shader("bilinear.frag"), ("u_size",), {"u_color": color})
        )

    def draw(self, frame: int) -> None:
        """See ``Peer``."""
        self._shaded.draw(frame)
        self._stretch.draw(frame, {"u_size": self.world.size})


class DepthAwareUpsampling(BilinearUpsampling):
    """The picture is shaded small, and each pixel takes of it what is of its own surface."""

    def make(self) -> None:
        """See ``Peer``."""
        self._shaded = self.shaded_apart(smaller(self.world.size, self._divisor))
        small, full = self._shaded.world, self.world
        scale = small.size[0] / full.size[0], small.size[1] / full.size[1]
        self._numbers = {"u_scale": scale, **own_surface(full)}
        shader = PeerShader(
            read_shader("depth_aware.frag", *OF_DEPTH),
            tuple(self._numbers),
            {"u_color": small.targets.color, "u_depth": small.targets.depth_texture},
        )
        self._upsample = self.over_objects(shader)

    def draw(self, frame: int) -> None:
        """See ``Peer``."""
        self._shaded.draw(frame)
        self._upsample.draw(frame, self._numbers)
