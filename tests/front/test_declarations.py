"""Declarations and statements: what tree each construct becomes."""

from __future__ import annotations

from pathlib import Path

import pytest

from shadercache.ast.nodes import (
    NO_QUALIFIERS,
    Block,
    BlockDecl,
    Case,
    Decl,
    DeclStmt,
    DoWhile,
    ExprStmt,
    For,
    FunctionDef,
    FunctionProto,
    If,
    Jump,
    Literal,
    Name,
    PrecisionDecl,
    QualifierDecl,
    Return,
    Stmt,
    Switch,
    VarDecl,
    While,
)
from shadercache.front.parse import parse
from shadercache.source import Source

SHADERS = Path(__file__).parent / "shaders"


def decl(text: str, version: str = "330") -> Decl:
    (node,) = parse(Source("test", f"#version {version}\n{text}")).decls
    return node


def variables(text: str, version: str = "330") -> VarDecl:
    node = decl(text, version)
    assert isinstance(node, VarDecl)
    return node


def statement(text: str) -> Stmt:
    node = decl(f"void main() {{ {text} }}")
    assert isinstance(node, FunctionDef)
    (inner,) = node.body.body
    return inner


# --- variables ------------------------------------------------------------------------------------


def test_several_names_with_sizes_and_initialisers() -> None:
    node = variables("float a, b[2] = float[2](0.0, 1.0), c[], d = 1.0;")
    assert node.qualifiers is NO_QUALIFIERS
    assert [name.name for name in node.declarators] == ["a", "b", "c", "d"]
    assert [len(name.dims) for name in node.declarators] == [0, 1, 1, 0]
    assert node.declarators[2].dims == (None,)
    assert [name.init is None for name in node.declarators] == [True, False, True, False]


def test_sizes_of_the_type_and_of_the_name_are_apart() -> None:
    node = variables("vec2[3] a[2];", "430")
    assert [getattr(size, "text", None) for size in node.type.dims] == ["3"]
    assert [getattr(size, "text", None) for size in node.declarators[0].dims] == ["2"]


@pytest.mark.parametrize(
    "words",
    [
        *("const", "in", "out", "uniform", "attribute", "varying", "centroid in", "flat in"),
        *("smooth out", "noperspective in", "invariant out", "invariant centroid out"),
        *("highp", "uniform mediump", "const lowp"),
    ],
)
def test_qualifiers_keep_their_order(words: str) -> None:
    node = variables(f"{words} vec4 v;")
    assert node.qualifiers.words == tuple(words.split())
    assert node.qualifiers.layout is None


@pytest.mark.parametrize("words", ["precise", "patch in", "sample in", "precise invariant out"])
def test_qualifiers_of_version_400(words: str) -> None:
    assert variables(f"{words} vec4 v;", "400").qualifiers.words == tuple(words.split())


def test_layout() -> None:
    node = variables("layout(location = 1 + 1, index = 0, shared, row_major) out vec4 v;")
    assert node.qualifiers.words == ("out",)
    assert node.qualifiers.layout is not None
    items = [(item.name, item.value is None) for item in node.qualifiers.layout]
    expected = [("location", False), ("index", False), ("shared", True), ("row_major", True)]
    assert items == expected


def test_several_layouts_become_one() -> None:
    node = variables("layout(location = 1) layout(index = 0) out vec4 v;", "420")
    assert node.qualifiers.layout is not None
    assert [item.name for item in node.qualifiers.layout] == ["location", "index"]


def test_precision() -> None:
    node = decl("precision mediump float;")
    assert isinstance(node, PrecisionDecl)
    assert (node.precision, node.type.name) == ("mediump", "float")


def test_qualifiers_alone() -> None:
    node = decl("invariant gl_Position, v_color;")
    assert isinstance(node, QualifierDecl)
    assert node.qualifiers.words == ("invariant",)
    assert node.names == ("gl_Position", "v_color")
    layout = decl("layout(origin_upper_left) in;")
    assert isinstance(layout, QualifierDecl)
    assert layout.names == ()


def test_semicolons_between_declarations_are_dropped() -> None:
    assert isinstance(decl(";; float a; ;"), VarDecl)


@pytest.mark.parametrize("kind", ["sampler2D", "isampler3D", "usamplerBuffer", "samplerCubeShadow"])
def test_opaque_types(kind: str) -> None:
    assert variables(f"uniform {kind} s;").type.name == kind


# --- structs and blocks ---------------------------------------------------------------------------


def test_struct() -> None:
    node = variables("struct S { float a, b[2]; const vec3[2] c; } s, t;")
    struct = node.type.struct
    assert struct is not None
    assert (struct.name, node.type.name) == ("S", "S")
    assert [[name.name for name in field.declarators] for field in struct.fields] == [
        ["a", "b"],
        ["c"],
    ]
    assert [name.name for name in node.declarators] == ["s", "t"]


def test_struct_without_a_name() -> None:
    struct = variables("struct { float a; } s;").type.struct
    assert struct is not None
    assert struct.name == ""


def test_struct_without_variables() -> None:
    assert variables("struct S { float a; };").declarators == ()


@pytest.mark.parametrize(
    ("text", "instance", "sizes"),
    [
        ("uniform B { vec4 a; };", None, 0),
        ("uniform B { vec4 a; } b;", "b", 0),
        ("uniform B { vec4 a; } b[2];", "b", 1),
        ("in B { vec4 a; } b[];", "b", 1),
    ],
)
def test_interface_block(text: str, instance: str | None, sizes: int) -> None:
    node = decl(text)
    assert isinstance(node, BlockDecl)
    assert (node.name, node.instance, len(node.dims)) == ("B", instance, sizes)
    assert len(node.fields) == 1


def test_interface_block_with_layout() -> None:
    node = decl("layout(std140) uniform B { layout(row_major) mat4 m; };")
    assert isinstance(node, BlockDecl)
    assert node.qualifiers.layout is not None
    assert node.fields[0].qualifiers.layout is not None


def test_storage_block_of_version_430() -> None:
    node = decl("layout(std430) readonly buffer B { float a[]; };", "430")
    assert isinstance(node, BlockDecl)


# --- functions ------------------------------------------------------------------------------------


@pytest.mark.parametrize("params", ["", "void", " void "])
def test_no_parameters(params: str) -> None:
    node = decl(f"float f({params});")
    assert isinstance(node, FunctionProto)
    assert node.params == ()


def test_parameters() -> None:
    node = decl("vec3[2] f(float, const in vec2 a, inout highp int b[3], out float[2]);")
    assert isinstance(node, FunctionProto)
    assert len(node.type.dims) == 1
    assert [param.name for param in node.params] == [None, "a", "b", None]
    assert [param.writes_back for param in node.params] == [False, False, True, True]
    assert [len(param.dims) for param in node.params] == [0, 0, 1, 0]
    assert len(node.params[3].type.dims) == 1


def test_function() -> None:
    node = decl("highp float f(float x) { return x; }")
    assert isinstance(node, FunctionDef)
    assert node.name == "f"
    assert node.proto.qualifiers.words == ("highp",)
    assert isinstance(node.body.body[0], Return)


def test_prototype_in_a_function() -> None:
    node = statement("float f(float x);")
    assert isinstance(node, DeclStmt)
    assert isinstance(node.decl, FunctionProto)


# --- statements -----------------------------------------------------------------------------------


def test_simple_statements() -> None:
    assert isinstance(statement(";"), ExprStmt)
    assert isinstance(statement("a;"), ExprStmt)
    assert isinstance(statement("{ a; b; }"), Block)
    assert isinstance(statement("float a;"), DeclStmt)
    assert isinstance(statement("precision highp int;"), DeclStmt)
    assert isinstance(statement("invariant a;"), DeclStmt)
    assert isinstance(statement("return;"), Return)
    assert isinstance(statement("return a, b;"), Return)


@pytest.mark.parametrize("word", ["break", "continue", "discard"])
def test_jumps(word: str) -> None:
    node = statement(f"{word};")
    assert isinstance(node, Jump)
    assert node.word == word


def test_else_belongs_to_the_nearest_if() -> None:
    outer = statement("if (a) if (b) c; else d;")
    assert isinstance(outer, If)
    assert outer.other is None
    assert isinstance(outer.then, If)
    assert outer.then.other is not None


def test_braces_give_else_to_the_outer_if() -> None:
    outer = statement("if (a) { if (b) c; } else d;")
    assert isinstance(outer, If)
    assert outer.other is not None


def test_else_if() -> None:
    node = statement("if (a) b; else if (c) d; else e;")
    assert isinstance(node, If)
    assert isinstance(node.other, If)
    assert isinstance(node.other.other, ExprStmt)


def test_switch() -> None:
    node = statement("switch (a) { case 1: case 2: b; break; default: c; }")
    assert isinstance(node, Switch)
    assert isinstance(node.selector, Name)
    kinds = [type(inner) for inner in node.body]
    assert kinds == [Case, Case, ExprStmt, Jump, Case, ExprStmt]
    assert isinstance(node.body[0], Case)
    assert isinstance(node.body[0].value, Literal)
    assert isinstance(node.body[4], Case)
    assert node.body[4].value is None
    empty = statement("switch (a) { }")
    assert isinstance(empty, Switch)
    assert empty.body == ()


@pytest.mark.parametrize(
    ("head", "kinds"),
    [
        (";;", (None, None)),
        ("; a;", (Name, None)),
        (";; b", (None, Name)),
        ("int i = 0; i; b", (Name, Name)),
        ("a; bool b = c; d", (VarDecl, Name)),
    ],
)
def test_for(head: str, kinds: tuple[type | None, type | None]) -> None:
    node = statement(f"for ({head}) {{ }}")
    assert isinstance(node, For)
    for part, kind in zip((node.condition, node.step), kinds, strict=True):
        assert part is None if kind is None else isinstance(part, kind)


def test_while_and_do() -> None:
    node = statement("while (bool go = a) b;")
    assert isinstance(node, While)
    assert isinstance(node.condition, VarDecl)
    again = statement("do a; while (b);")
    assert isinstance(again, DoWhile)
    assert isinstance(again.condition, Name)


# --- whole shaders --------------------------------------------------------------------------------


@pytest.mark.parametrize("path", sorted(SHADERS.iterdir()), ids=lambda path: path.name)
def test_shaders_with_every_construct(path: Path) -> None:
    module = parse(Source(path.name, path.read_text()))
    assert path.read_text().startswith(f"#version {module.version}")
    assert isinstance(module.decls[-1], FunctionDef)
