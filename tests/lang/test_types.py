"""Types as values."""

from __future__ import annotations

import pytest

from shadercache.lang import words
from shadercache.lang.types import (
    FLOAT,
    INT,
    VOID,
    Type,
    array_of,
    builtin_type,
    matrix,
    struct_type,
    vector,
)


def kind(name: str) -> Type:
    found = builtin_type(name)
    assert found is not None, name
    return found


@pytest.mark.parametrize("name", sorted(words.type_names(400)))
def test_every_type_name_of_the_language_is_a_type(name: str) -> None:
    assert builtin_type(name) is not None


def test_unknown_names_are_no_types() -> None:
    assert builtin_type("vec5") is None
    assert builtin_type("Ray") is None


def test_types_are_interned() -> None:
    assert kind("mat3x3") is kind("mat3") is matrix("float", 3, 3)
    assert vector("int", 1) is INT
    assert vector("uint", 4) is kind("uvec4")
    assert array_of(FLOAT, 3) is array_of(FLOAT, 3)
    assert array_of(FLOAT, 3) is not array_of(FLOAT, 4)
    assert struct_type("S", {"a": FLOAT}) is not struct_type("S", {"a": FLOAT})


@pytest.mark.parametrize(
    ("name", "base", "rows", "cols", "components"),
    [
        ("float", "float", 1, 1, 1),
        ("bvec3", "bool", 3, 1, 3),
        ("mat2x3", "float", 3, 2, 6),
        ("mat4x2", "float", 2, 4, 8),
        ("dmat3", "double", 3, 3, 9),
        ("uvec2", "uint", 2, 1, 2),
        ("sampler2D", None, 1, 1, None),
        ("void", None, 1, 1, None),
    ],
)
def test_shape(name: str, base: str | None, rows: int, cols: int, components: int | None) -> None:
    one = kind(name)
    assert (one.base, one.rows, one.cols, one.components) == (base, rows, cols, components)
    assert str(one) == name


PREDICATES = {
    "is_scalar": {"float", "int", "uint", "bool", "double"},
    "is_vector": {"vec2", "ivec3", "bvec4", "dvec2"},
    "is_matrix": {"mat2", "mat4x3", "dmat2"},
    "is_float": {"float", "vec2", "mat2", "mat4x3"},
    "is_numeric": {
        *("float", "int", "uint", "double", "vec2", "ivec3", "dvec2", "mat2", "mat4x3", "dmat2")
    },
    "is_opaque": {"sampler2D", "usamplerBuffer", "samplerCubeShadow"},
    "is_void": {"void"},
}


@pytest.mark.parametrize("name", sorted(set().union(*PREDICATES.values())))
def test_predicates(name: str) -> None:
    found = {what for what in PREDICATES if getattr(kind(name), what)}
    assert found == {what for what, names in PREDICATES.items() if name in names}
    array = array_of(kind(name), 2)
    assert array.is_array
    assert not any(getattr(array, what) for what in PREDICATES)


def test_arrays() -> None:
    inner = array_of(kind("vec3"), 2)
    outer = array_of(inner, 4)
    assert str(outer) == "vec3[4][2]"
    assert outer.dims == (4, 2)
    assert outer.element is inner
    assert inner.element is kind("vec3")
    assert outer.components == 24
    assert str(array_of(INT, None)) == "int[]"
    assert array_of(INT, None).is_unsized
    assert array_of(INT, None).components is None
    assert array_of(INT, None).components_or_one == 1


def test_structs() -> None:
    ray = struct_type("Ray", {"origin": kind("vec3"), "hits": array_of(INT, 2)})
    assert str(ray) == "Ray"
    assert ray.is_struct
    assert not ray.is_opaque
    assert ray.components == 5
    assert array_of(ray, 3).components == 15
    lit = struct_type("Lit", {"ray": ray, "map": kind("sampler2D")})
    assert lit.holds_opaque
    assert not ray.holds_opaque
    assert lit.components is None


@pytest.mark.parametrize(
    ("name", "element"),
    [("vec3", "float"), ("bvec2", "bool"), ("mat2x3", "vec3"), ("dmat2", "dvec2")],
)
def test_elements(name: str, element: str) -> None:
    assert kind(name).element is kind(element)


@pytest.mark.parametrize("one", [FLOAT, VOID, kind("sampler2D")])
def test_what_has_no_elements(one: Type) -> None:
    with pytest.raises(TypeError):
        _ = one.element
