"""The types of GLSL as values.

Types are interned: two types are equal exactly if they are the same object, so they can be compared
with ``is`` and make cheap dictionary keys. Each declaration of a struct makes a type of its own
(GLSL 3.30 section 4.1.8). Make types with the functions of this file, never with ``Type(...)``.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from math import prod

_PREFIX = {
    **{"float": "", "int": "i", "uint": "u", "bool": "b", "double": "d"},
    **{"int64_t": "i64", "uint64_t": "u64"},
    **{"float16_t": "f16", "int16_t": "i16", "uint16_t": "u16", "int8_t": "i8", "uint8_t": "u8"},
}
FLOATS = ("float", "double", "float16_t")
"""Scalars of which there are matrices."""
_EXPLICIT = {
    **{"float": ("float32_t", "f32"), "double": ("float64_t", "f64")},
    **{"int": ("int32_t", "i32"), "uint": ("uint32_t", "u32")},
}
"""Other names of scalars and of their vectors, which say how many bits they have."""
SCALARS = tuple(_PREFIX)

_SHADOW_SHAPES = ("1D", "2D", "Cube", "2DRect", "1DArray", "2DArray", "CubeArray")
_SHAPES_OF_ALL = (*_SHADOW_SHAPES, "3D", "Buffer", "2DMS", "2DMSArray")


@dataclass(frozen=True, slots=True, eq=False)
class StructType:
    """A struct or the contents of an interface block: its name and fields in order.

    What is inside is counted once: forty structs of two of the one before have 2^40 fields.
    """

    name: str
    fields: dict[str, Type]
    bases: frozenset[str | None] = field(init=False)
    components: int | None = field(init=False)
    slots: int = field(init=False)
    holds_array: bool = field(init=False)
    holds_opaque: bool = field(init=False)

    def __post_init__(self) -> None:
        kinds = self.fields.values()
        numbers = [kind.components for kind in kinds]
        known = [number for number in numbers if number is not None]
        inside = {
            "bases": frozenset[str | None]().union(*(kind.bases for kind in kinds)),
            "components": sum(known) if len(known) == len(numbers) else None,
            "slots": sum(kind.slots for kind in kinds),
            "holds_array": any(kind.holds_array for kind in kinds),
            "holds_opaque": any(kind.holds_opaque for kind in kinds),
        }
        for name, value in inside.items():
            object.__setattr__(self, name, value)


@dataclass(frozen=True, slots=True, eq=False)
class Type:
    """A type. For arrays all fields but ``dims`` describe the innermost element.

    ``base`` is ``None`` for opaque types, structs and ``void``. ``rows`` are the components of a
    vector or of a matrix column, ``cols`` the columns; both are 1 for everything else. ``dims``
    are array sizes, outermost first; ``None`` is a size that is not known (yet).
    """

    name: str
    base: str | None = None
    rows: int = 1
    cols: int = 1
    dims: tuple[int | None, ...] = ()
    struct: StructType | None = None
    _arrays: dict[int | None, Type] = field(default_factory=dict, repr=False)
    _element: Type | None = field(default=None, repr=False)

    def __str__(self) -> str:
        """The type as GLSL writes it: ``vec3``, ``float[4][2]``, ``Ray``."""
        return self.name + "".join("[]" if n is None else f"[{n}]" for n in self.dims)

    @property
    def is_array(self) -> bool:
        """Is it an array (of anything)?"""
        return bool(self.dims)

    @property
    def is_scalar(self) -> bool:
        """A ``bool`` or a number of any size."""
        return self.base is not None and self.rows == 1 and self.cols == 1 and not self.dims

    @property
    def is_vector(self) -> bool:
        """``vec2`` … ``vec4`` over any scalar."""
        return self.rows > 1 and self.cols == 1 and not self.dims

    @property
    def is_matrix(self) -> bool:
        """``mat2`` … ``mat4x3``, ``dmat2`` …"""
        return self.cols > 1 and not self.dims

    @property
    def is_float(self) -> bool:
        """A scalar, vector or matrix of ``float``."""
        return self.base == "float" and not self.dims

    @property
    def is_numeric(self) -> bool:
        """A scalar, vector or matrix of numbers (not ``bool``)."""
        return self.base is not None and self.base != "bool" and not self.dims

    @property
    def is_struct(self) -> bool:
        """A struct, or an interface block seen as one."""
        return self.struct is not None and not self.dims

    @property
    def is_void(self) -> bool:
        """``void``."""
        return self is VOID

    @property
    def is_opaque(self) -> bool:
        """A sampler or another handle, not an array of them (see :attr:`holds_opaque`)."""
        return self.base is None and self.struct is None and not self.dims and self is not VOID

    @property
    def holds_opaque(self) -> bool:
        """Is it opaque, or an array or struct with something opaque inside?"""
        if self.struct is not None:
            return self.struct.holds_opaque
        return self.base is None and self is not VOID

    @property
    def holds_array(self) -> bool:
        """Is it an array, or a struct with an array inside?"""
        if self.struct is not None and not self.dims:
            return self.struct.holds_array
        return bool(self.dims)

    @property
    def bases(self) -> frozenset[str | None]:
        """The scalar types of what is inside; ``None`` for something opaque."""
        return frozenset((self.base,)) if self.struct is None else self.struct.bases

    @property
    def slots(self) -> int:
        """Number of locations that a variable of this type takes (section 4.3.8.1)."""
        if self.struct is not None:
            one = self.struct.slots
        else:
            # A location has room for four floats: dvec3 and dvec4 take two.
            one = self.cols * (2 if self.base == "double" and self.rows > 2 else 1)
        return one * prod(size or 1 for size in self.dims)

    @property
    def is_unsized(self) -> bool:
        """Is it an array with an unknown size?"""
        return None in self.dims

    @property
    def element(self) -> Type:
        """What an index yields: array element, matrix column or vector component.

        Raises ``TypeError`` for a type that cannot be indexed.
        """
        if self._element is not None:
            return self._element
        if self.base is not None and self.cols > 1:
            return vector(self.base, self.rows)
        if self.base is not None and self.rows > 1:
            return vector(self.base, 1)
        raise TypeError(f"{self} has no elements")

    @property
    def components(self) -> int | None:
        """Number of scalars inside; ``None`` for opaque, unsized and ``void`` types."""
        if self.struct is not None:
            one = self.struct.components
        else:
            one = None if self.base is None else self.rows * self.cols
        sizes = [n for n in self.dims if n is not None]
        return None if one is None or len(sizes) < len(self.dims) else one * prod(sizes)

    @property
    def components_or_one(self) -> int:
        """:attr:`components`, or 1 where there is no such number (for cost estimates)."""
        return self.components or 1


def array_of(element: Type, size: int | None) -> Type:
    """``element[size]``; ``None`` for an unsized array. Of an array: one more outer dimension."""
    # The element keeps its arrays, so that equal array types are one object.
    array = element._arrays.get(size)
    if array is None:
        dims = (size, *element.dims)
        array = replace(element, dims=dims, _arrays={}, _element=element)
        element._arrays[size] = array
    return array


def struct_type(name: str, fields: dict[str, Type]) -> Type:
    """A new struct type, different from all others."""
    return Type(name, struct=StructType(name, fields))


def vector(base: str, n: int) -> Type:
    """The vector of ``n`` (1 to 4) components of scalar ``base``; for 1 the scalar itself."""
    return _SHAPES[base, 1, n]


def matrix(base: str, cols: int, rows: int) -> Type:
    """``mat{cols}x{rows}`` over ``float`` or ``double``."""
    return _SHAPES[base, cols, rows]


def builtin_type(name: str) -> Type | None:
    """The built-in type called ``name`` (of any version), or ``None``."""
    return _BY_NAME.get(name)


def _numeric_types() -> dict[str, Type]:
    types = {name: Type(name, name) for name in SCALARS}
    for base, prefix in _PREFIX.items():
        for n in (2, 3, 4):
            name = f"{prefix}vec{n}"
            types[name] = Type(name, base, rows=n)
    for base in FLOATS:
        for cols in (2, 3, 4):
            for rows in (2, 3, 4):
                long = f"{_PREFIX[base]}mat{cols}x{rows}"
                name = long.split("x")[0] if cols == rows else long
                types[name] = types[long] = Type(name, base, rows, cols)
    return {**types, **_explicit_names(types)}


def _explicit_names(types: dict[str, Type]) -> dict[str, Type]:
    """``f32vec2``, which is ``vec2`` (GL_EXT_shader_explicit_arithmetic_types)."""
    others: dict[str, Type] = {}
    for base, (scalar, prefix) in _EXPLICIT.items():
        others[scalar] = types[base]
        own = _PREFIX[base]
        shapes = ("vec", "mat") if base in FLOATS else ("vec",)
        for name, kind in types.items():
            if kind.base == base and name.startswith(tuple(own + shape for shape in shapes)):
                others[prefix + name.removeprefix(own)] = kind
    return others


def _opaque_types() -> dict[str, Type]:
    names = [
        f"{prefix}{sort}{shape}"
        for sort in ("sampler", "image", "texture")
        for prefix in ("", "i", "u")
        for shape in _SHAPES_OF_ALL
    ]
    names += ["sampler" + shape + "Shadow" for shape in _SHADOW_SHAPES]
    names += ["atomic_uint", "samplerExternalOES", "sampler", "samplerShadow"]
    names += [f"{prefix}subpassInput{sort}" for prefix in ("", "i", "u") for sort in ("", "MS")]
    return {name: Type(name) for name in names}


VOID = Type("void")
_BY_NAME = {**_numeric_types(), **_opaque_types(), "void": VOID}
_SHAPES = {(t.base, t.cols, t.rows): t for t in _BY_NAME.values() if t.base is not None}

FLOAT = _BY_NAME["float"]
INT = _BY_NAME["int"]
UINT = _BY_NAME["uint"]
BOOL = _BY_NAME["bool"]
DOUBLE = _BY_NAME["double"]
INT64 = _BY_NAME["int64_t"]
UINT64 = _BY_NAME["uint64_t"]
HALF = _BY_NAME["float16_t"]
INT16 = _BY_NAME["int16_t"]
UINT16 = _BY_NAME["uint16_t"]
