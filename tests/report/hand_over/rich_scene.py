"""A scene whose shader has one of every kind of input that an example knows."""

from __future__ import annotations

from pathlib import Path

import numpy as np

VERTEX = """#version 330
in vec3 a_position;
in int a_part;
in vec3 i_offset;
in mat4 i_turn;
layout(std140) uniform Camera {
    mat4 view;
    mat4 projection;
    float unused;
} camera;
uniform float u_sizes[3];
uniform sampler2D u_pose;
out vec3 v_point;
flat out int v_part;
void main() {
    v_point = a_position;
    v_part = a_part;
    vec4 place = i_turn * vec4(a_position * u_sizes[1], 1.0) + vec4(i_offset, 0.0);
    place.xyz += texelFetch(u_pose, ivec2(0), 0).xyz;
    gl_Position = camera.projection * camera.view * place;
}
"""
FRAGMENT = """#version 330
in vec3 v_point;
flat in int v_part;
struct Lamp {
    vec3 color;
    bool on;
};
uniform Lamp u_lamps[2];
uniform uint u_seed;
uniform sampler2D u_map;
uniform samplerCube u_sky;
uniform sampler2DArray u_layers;
uniform sampler3D u_volume;
out vec4 color;
vec3 pattern(vec3 p) {
    vec3 found = texture(u_map, 3.0 * p.xy).rgb + texture(u_sky, p).rgb;
    found += textureLod(u_layers, vec3(p.yz, float(v_part)), 0.0).rgb;
    found += textureLod(u_volume, 2.0 * p, 0.0).rgb;
    return sin(float(u_seed) * found + cos(9.0 * p.yzx));
}
void main() {
    vec3 lamp = u_lamps[1].on ? u_lamps[1].color : u_lamps[0].color;
    color = vec4(0.5 + 0.5 * pattern(v_point) * lamp, 1.0);
}
"""
SCENE = """
name = "rich"
fragment = "rich.frag"
vertex = "rich.vert"
mesh = "mesh.npz"
cull = "back"
[attributes]
a_position = "position"
a_part = "part"
[camera]
eye = [0.0, 0.6, 6.0]
fov_degrees = 40.0
near = 1.0
far = 10.0
[camera.path]
degrees_per_frame = 0.5
[uniforms]
"camera.view" = "view"
"camera.projection" = "projection"
u_sizes = [0.5, 1.2, 0.1]
"u_lamps[0].color" = [1.0, 0.9, 0.8]
"u_lamps[0].on" = 1
"u_lamps[1].color" = [0.7, 0.8, 1.0]
"u_lamps[1].on" = 1
u_seed = 3
[instances]
i_offset = { table = "field.npz", array = "offset" }
i_turn = { table = "field.npz", array = "turn" }
[textures.u_pose]
POSE
[textures.u_map]
file = "map.npz"
mipmap = true
anisotropy = 4.0
[textures.u_sky]
file = "sky.npz"
[textures.u_layers]
file = "layers.npz"
filter = "nearest"
[textures.u_volume]
file = "volume.npz"
wrap = "clamp"
"""
OBJECTS = """
[[objects]]
name = "map of its own"
cull = "none"
textures.u_map = { file = "other.npz", filter = "nearest" }
[objects.instances]
i_offset = { table = "field.npz", array = "higher" }
i_turn = { table = "field.npz", array = "turn" }
[[objects]]
name = "field"
"""
FRAMES, COUNT = 8, 5


def write_rich_scene(folder: Path, several: bool, played: bool = False) -> Path:
    """The scene file; with ``several`` objects, else with one. ``played``: does the texture that
    moves vertices change from frame to frame?"""
    folder.mkdir()
    corners = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], np.float32) * 0.35
    index = np.array([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]], np.uint16)
    np.savez(folder / "mesh.npz", position=corners, part=np.array([0, 1, 2, 1]), index=index)
    offset = np.column_stack([np.linspace(-1.6, 1.6, COUNT), np.zeros((COUNT, 2))])
    angle = 0.05 * np.arange(FRAMES)[:, None] + np.arange(COUNT)
    turn = np.zeros((FRAMES, COUNT, 4, 4))
    turn[..., 0, 0], turn[..., 0, 2] = np.cos(angle), -np.sin(angle)
    turn[..., 2, 0], turn[..., 2, 2] = np.sin(angle), np.cos(angle)
    turn[..., 1, 1] = turn[..., 3, 3] = 1.0
    rows, higher = turn.reshape(FRAMES, COUNT, 16), offset + np.array([0.0, 0.9, 0.0])
    pose = np.linspace(0.0, 0.3, FRAMES * 4).reshape(FRAMES, 1, 1, 4)
    np.savez(folder / "field.npz", offset=offset, higher=higher, turn=rows, pose=pose)
    np.savez(folder / "pose.npz", pixels=pose[0].astype(np.float32))
    random = np.random.default_rng(4)
    np.savez(folder / "map.npz", pixels=random.integers(0, 256, (16, 16, 4), np.uint8))
    np.savez(folder / "other.npz", pixels=random.random((8, 8, 4), np.float32))
    np.savez(folder / "sky.npz", faces=random.random((6, 8, 8, 4), np.float32))
    np.savez(folder / "layers.npz", layers=random.random((3, 8, 8, 4), np.float32))
    np.savez(folder / "volume.npz", volume=random.random((4, 8, 8, 4)).astype(np.float16))
    (folder / "rich.vert").write_text(VERTEX)
    (folder / "rich.frag").write_text(FRAGMENT)
    path = folder / "scene.toml"
    pose_of = 'table = "field.npz"\narray = "pose"' if played else 'file = "pose.npz"'
    path.write_text(SCENE.replace("POSE", pose_of) + OBJECTS * several)
    return path
