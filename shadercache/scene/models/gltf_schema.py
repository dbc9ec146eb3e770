"""What a glTF 2.0 file says, as far as it is read; msgspec checks the types while it decodes."""

from __future__ import annotations

from typing import Any, Literal

from msgspec import Struct


class GltfPart(Struct, frozen=True, rename="camel"):
    """Names are those of the specification, in Python's spelling."""


class Buffer(GltfPart, frozen=True):
    """Bytes: of the GLB's binary chunk where there is no ``uri``."""

    byte_length: int
    uri: str | None = None


class BufferView(GltfPart, frozen=True):
    """A stretch of a buffer."""

    buffer: int
    byte_length: int
    byte_offset: int = 0
    byte_stride: int | None = None


class SparseIndices(GltfPart, frozen=True):
    """Which elements of a sparse accessor differ."""

    buffer_view: int
    component_type: int
    byte_offset: int = 0


class SparseValues(GltfPart, frozen=True):
    """What these are."""

    buffer_view: int
    byte_offset: int = 0


class Sparse(GltfPart, frozen=True):
    """The elements of an accessor that differ from what lies beneath."""

    count: int
    indices: SparseIndices
    values: SparseValues


class Accessor(GltfPart, frozen=True):
    """An array in a buffer view; zeros without one."""

    component_type: int
    count: int
    type: Literal["SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"]
    buffer_view: int | None = None
    byte_offset: int = 0
    normalized: bool = False
    sparse: Sparse | None = None


class Primitive(GltfPart, frozen=True):
    """What is drawn at once: a material's share of a mesh."""

    attributes: dict[str, int]
    indices: int | None = None
    material: int | None = None
    mode: int = 4
    targets: list[dict[str, int]] = []
    extensions: dict[str, Any] = {}


class GltfMesh(GltfPart, frozen=True):
    """Primitives, and how far their morph targets are moved at first."""

    primitives: list[Primitive]
    weights: list[float] = []
    name: str = ""


class GltfNode(GltfPart, frozen=True):
    """A place in the hierarchy: a matrix, or translation, rotation and scale."""

    children: list[int] = []
    mesh: int | None = None
    skin: int | None = None
    matrix: list[float] | None = None
    translation: tuple[float, float, float] = (0.0, 0.0, 0.0)
    rotation: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)
    scale: tuple[float, float, float] = (1.0, 1.0, 1.0)
    weights: list[float] = []
    name: str = ""


class GltfScene(GltfPart, frozen=True):
    """The roots of what is drawn together."""

    nodes: list[int] = []


class GltfSkin(GltfPart, frozen=True):
    """The nodes that move vertices."""

    joints: list[int]
    inverse_bind_matrices: int | None = None


class ChannelTarget(GltfPart, frozen=True):
    """What a channel moves; nothing without a node."""

    path: str
    node: int | None = None


class GltfChannel(GltfPart, frozen=True):
    """A sampler's numbers for one property of a node."""

    sampler: int
    target: ChannelTarget


class GltfSampler(GltfPart, frozen=True):
    """Values at times."""

    input: int
    output: int
    interpolation: Literal["LINEAR", "STEP", "CUBICSPLINE"] = "LINEAR"


class GltfAnimation(GltfPart, frozen=True):
    """Channels that are played together."""

    channels: list[GltfChannel]
    samplers: list[GltfSampler]
    name: str = ""


class TextureInfo(GltfPart, frozen=True):
    """A texture in a material, with the number of its texture coordinates."""

    index: int
    tex_coord: int = 0


class Roughness(GltfPart, frozen=True):
    """``pbrMetallicRoughness``."""

    base_color_factor: tuple[float, float, float, float] = (1.0, 1.0, 1.0, 1.0)
    base_color_texture: TextureInfo | None = None
    metallic_factor: float = 1.0
    roughness_factor: float = 1.0
    metallic_roughness_texture: TextureInfo | None = None


class GltfMaterial(GltfPart, frozen=True):
    """The part of a material that shaders may be given."""

    pbr_metallic_roughness: Roughness = Roughness()
    normal_texture: TextureInfo | None = None
    occlusion_texture: TextureInfo | None = None
    emissive_texture: TextureInfo | None = None
    emissive_factor: tuple[float, float, float] = (0.0, 0.0, 0.0)
    double_sided: bool = False
    name: str = ""


class GltfTexture(GltfPart, frozen=True):
    """Which image; none where an extension has another form of it."""

    source: int | None = None


class GltfImage(GltfPart, frozen=True):
    """A PNG or JPEG file, or one in a buffer view."""

    uri: str | None = None
    buffer_view: int | None = None
    name: str = ""


class Asset(GltfPart, frozen=True):
    """Which glTF it is."""

    version: str


class Document(GltfPart, frozen=True):
    """A whole file."""

    asset: Asset
    extensions_required: list[str] = []
    buffers: list[Buffer] = []
    buffer_views: list[BufferView] = []
    accessors: list[Accessor] = []
    meshes: list[GltfMesh] = []
    nodes: list[GltfNode] = []
    scenes: list[GltfScene] = []
    scene: int = 0
    skins: list[GltfSkin] = []
    animations: list[GltfAnimation] = []
    materials: list[GltfMaterial] = []
    textures: list[GltfTexture] = []
    images: list[GltfImage] = []
