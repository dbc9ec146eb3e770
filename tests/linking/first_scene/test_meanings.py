"""What names commonly mean."""

from __future__ import annotations

import pytest

from shadercache.lang.types import Type, builtin_type
from shadercache.linking.first_scene.meanings import (
    EYES,
    array_of_attribute,
    matrix_meaning,
    plain,
    role_of,
)


def kind(name: str) -> Type:
    found = builtin_type(name)
    assert found is not None
    return found


@pytest.mark.parametrize(
    ("names", "spelt", "array"),
    [
        ("a_position aPos position vertexPosition inPosition POSITION in_Position aVertexPosition "
         "vertex v_pos a_vertex vPosition Position vs_position", "vec3", "position"),
        ("gl_Vertex a_position", "vec4", "position"),
        ("aPos pos position vertexPosition", "vec2", "position"),
        ("a_normal aNormal normal vertexNormal inNormal NORMAL gl_Normal aVertexNormal", "vec3",
         "normal"),
        ("a_uv aUV uv texCoord aTexCoords inTexCoord TEXCOORD_0 a_texcoord0 a_st aTextureCoord "
         "vertexUV", "vec2", "uv"),
        ("uv2 TEXCOORD_1 aTexCoord1", "vec2", "uv1"),
        ("gl_MultiTexCoord0", "vec4", "uv"),
        ("a_tangent tangent inTangent TANGENT", "vec4", "tangent"),
        ("aBitangent binormal", "vec3", "bitangent"),
        ("color aColor COLOR_0 gl_Color vertexColor colour", "vec4", "color"),
        ("JOINTS_0 aBoneIds skinIndex a_joints blendIndices", "vec4", "joints"),
        ("JOINTS_0", "uvec4", "joints"),
        ("WEIGHTS_0 skinWeight aBoneWeights a_weights", "vec4", "weights"),
        ("morphTarget0 aMorph0", "vec3", "morph0_position"),
        ("morphNormal1", "vec3", "morph1_normal"),
        ("a_offset instanceOffset thing", "vec3", None),
    ],
)  # fmt: skip
def test_attributes(names: str, spelt: str, array: str | None) -> None:
    found = {name: array_of_attribute(name, kind(spelt)) for name in names.split()}
    assert found == dict.fromkeys(names.split(), array)


@pytest.mark.parametrize(
    ("names", "meaning"),
    [
        ("uMVP u_mvp mvpMatrix modelViewProjection u_modelViewProjectionMatrix WorldViewProj "
         "gl_ModelViewProjectionMatrix uMvpMatrix", "model-view-projection"),
        ("model uModel u_model modelMatrix ModelMatrix world u_World uModelMat objectToWorld",
         "model"),
        ("view uView viewMatrix u_viewMat V", "view"),
        ("projection uProj projectionMatrix u_Projection P ProjMat", "projection"),
        ("modelViewMatrix uModelView MV gl_ModelViewMatrix", "model-view"),
        ("viewProjection u_viewProj VP viewProjectionMatrix projectionView", "view-projection"),
        ("inverseView viewInverse u_invView viewMatrixInverse", "inverse-view"),
        ("shadow lightSpaceMatrix", None),
    ],
)  # fmt: skip
def test_matrices(names: str, meaning: str | None) -> None:
    found = {name: matrix_meaning(name, kind("mat4")) for name in names.split()}
    assert found == dict.fromkeys(names.split(), meaning)


def test_matrices_of_other_sizes() -> None:
    for name in ("normalMatrix", "u_NormalMat", "gl_NormalMatrix"):
        assert matrix_meaning(name, kind("mat3")) == "normal-matrix"
    assert matrix_meaning("model", kind("mat3")) is None
    assert matrix_meaning("model", kind("mat2")) is None


@pytest.mark.parametrize(
    ("names", "is_one"),
    [
        ("cameraPosition uCameraPos u_eye viewPos eyePos _WorldSpaceCameraPos camPos", True),
        ("viewDir cameraUp color eyeColor", False),
    ],
)
def test_eyes(names: str, is_one: bool) -> None:
    for name in names.split():
        assert (EYES.match(plain(name)) is not None) == is_one, name


@pytest.mark.parametrize(
    ("names", "role"),
    [
        ("map uAlbedo u_texture tex0 diffuseMap texture_diffuse1 baseColorTexture colorMap",
         "albedo"),
        ("normalMap u_normals bumpMap texture_normal1", "normal"),
        ("roughnessMap metallicRoughnessTexture metalnessMap", "roughness"),
        ("aoMap occlusionTexture", "occlusion"),
        ("emissiveMap", "emissive"),
        ("noise lut", None),
    ],
)  # fmt: skip
def test_samplers(names: str, role: str | None) -> None:
    found = {name: role_of(name) for name in names.split()}
    assert found == dict.fromkeys(names.split(), role)
