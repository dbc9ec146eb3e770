"""The tables that the checker hands to the rest of the compiler."""

from __future__ import annotations

from sema.tools import checked, codes, initialisers

from shadercache.ast.nodes import (
    Call,
    Construct,
    Declarator,
    FunctionDef,
    FunctionProto,
    Index,
    Member,
    Module,
    Name,
)
from shadercache.ast.walk import EXPRESSIONS, walk
from shadercache.lang.builtins import Signature
from shadercache.sema.facts import Callee, Symbol
from shadercache.source import Source

SHADER = """#version 330
struct Ray { vec3 origin; vec3 direction; };
layout(std140) uniform Camera { mat4 view; vec4 eyes[2]; } u_camera;
uniform Globals { float time; };
uniform sampler2D u_map;
in vec2 v_uv;
layout(location = 0) out vec4 o_color;
const int COUNT = 2 + 1;
float total = 0.0;
float late(float x);
float twice(float x) { return x * 2.0; }
vec2 twice(vec2 x) { return x * 2.0; }
void grow(inout float x) { x = twice(x); total += late(x); }
void main() {
    Ray ray = Ray(vec3(v_uv, 0.0), vec3(1.0));
    float time2 = time;
    for (int i = 0; i < COUNT; ++i) { grow(time2); }
    vec2 d = twice(ray.origin.xy);
    vec4 c = texture(u_map, d) * u_camera.view * u_camera.eyes[1];
    { float total = 1.0; c.x = total; }
    o_color = c + vec4(total, gl_FragCoord.xyz);
}
float late(float x) { return x; }
"""


def uses(module: Module, name: str) -> list[Name]:
    return [node for node in walk(module) if isinstance(node, Name) and node.name == name]


def test_every_expression_has_a_type_and_every_name_a_symbol() -> None:
    module, facts = checked(SHADER)
    expressions = [node for node in walk(module) if isinstance(node, EXPRESSIONS)]
    assert len(expressions) > 60
    assert set(facts.types) == set(expressions)
    assert set(facts.symbols) == {node for node in expressions if isinstance(node, Name)}
    assert set(facts.calls) == {node for node in expressions if isinstance(node, Call)}


def test_types() -> None:
    module, facts = checked(SHADER)
    found = {name: str(facts.types[init]) for name, init in initialisers(module).items()}
    assert found == {
        "COUNT": "int",
        "total": "float",
        "ray": "Ray",
        "time2": "float",
        "i": "int",
        "d": "vec2",
        "c": "vec4",
    }
    members = {n.name: str(facts.types[n]) for n in walk(module) if isinstance(n, Member)}
    assert members == {"origin": "vec3", "xy": "vec2", "view": "mat4", "x": "float"} | {
        "eyes": "vec4[2]",
        "xyz": "vec3",
    }
    (index,) = (n for n in walk(module) if isinstance(n, Index))
    assert str(facts.types[index]) == "vec4"
    (ray,) = (n for n in walk(module) if isinstance(n, Construct) and n.type.name == "Ray")
    assert facts.types[ray].struct in facts.structs


def test_symbols() -> None:
    module, facts = checked(SHADER)

    def symbol(name: str, at: int = 0) -> Symbol:
        return facts.symbols[uses(module, name)[at]]

    kinds = {name: symbol(name).kind for name in ("u_map", "v_uv", "o_color", "COUNT", "total")}
    assert kinds == {
        "u_map": "uniform",
        "v_uv": "in",
        "o_color": "out",
        "COUNT": "const",
        "total": "global",
    }
    assert symbol("time2").kind == "local"
    assert not symbol("time2").is_global
    assert symbol("x").kind == "param"
    assert symbol("gl_FragCoord").kind == "builtin"
    assert symbol("gl_FragCoord").node is None
    assert symbol("u_camera").kind == "block"
    assert symbol("u_camera").qualifiers.has("uniform")
    time = symbol("time")
    assert time.kind == "uniform"
    assert time.block is not None
    assert time.block.name == "Globals"
    assert [symbol(n).writable for n in ("time2", "o_color", "x", "total")] == [True] * 4
    assert not any(symbol(n).writable for n in ("u_map", "v_uv", "COUNT", "time", "u_camera"))
    # The inner 'total' is another variable than the global one.
    assert symbol("total", 0) is symbol("total", 2)
    assert symbol("total", 1).kind == "local"


def test_declared_leads_to_the_symbols_of_the_uses() -> None:
    module, facts = checked(SHADER)
    for name in ("u_map", "time", "i", "d", "ray"):
        symbol = facts.symbols[uses(module, name)[0]]
        assert symbol.node is not None
        assert facts.declared[symbol.node] is symbol
    fields = [n for n in walk(module) if isinstance(n, Declarator) and n.name == "origin"]
    assert fields[0] not in facts.declared


def test_calls_lead_to_definitions_and_signatures() -> None:
    module, facts = checked(SHADER)
    by_name = {
        f"{f.name}/{f.proto.params[0].type.name}": f for f in facts.functions if f.name != "main"
    }
    found: dict[str, list[Callee]] = {}
    for call in (n for n in walk(module) if isinstance(n, Call)):
        found.setdefault(call.name, []).append(facts.calls[call])
    assert found["late"] == [by_name["late/float"]]
    assert found["twice"] == [by_name["twice/float"], by_name["twice/vec2"]]
    (texture,) = found["texture"]
    assert isinstance(texture, Signature)
    assert str(texture) == "vec4 texture(sampler2D, vec2)"
    assert texture.implicit_lod


def test_call_graph() -> None:
    module, facts = checked(SHADER)
    called = {f.name: [c.name for c in calls] for f, calls in facts.called.items() if calls}
    assert called == {"grow": ["twice", "late"], "main": ["grow", "twice", "texture"]}
    assert [f.name for f in facts.functions] == ["twice", "twice", "grow", "main", "late"]
    (proto,) = (d for d in module.decls if isinstance(d, FunctionProto))
    assert facts.prototypes[proto].name == "late"


def test_a_function_that_is_only_declared() -> None:
    module, facts = checked("#version 330\nfloat f(float x);\nvoid main() { float a = f(1.0); }\n")
    (callee,) = facts.calls.values()
    assert callee is module.decls[0]
    assert isinstance(callee, FunctionProto)
    assert [item.code for item in facts.warnings] == ["SC291"]
    assert not facts.prototypes


def test_a_call_before_the_definition_leads_to_it() -> None:
    _, facts = checked(
        "#version 330\nfloat f(float);\nvoid main() { float a = f(1.0); }\n"
        "float f(float x) { return x; }\n"
    )
    (callee,) = facts.calls.values()
    assert isinstance(callee, FunctionDef)
    assert not facts.warnings


def test_constants() -> None:
    module, facts = checked(SHADER)
    count = initialisers(module)["COUNT"]
    assert facts.constants[count] == 3
    assert facts.is_constant(count)
    (use,) = uses(module, "COUNT")
    assert facts.constants[use] == 3


def test_warnings() -> None:
    _, facts = checked(
        "#version 330\nfloat mix(int a, int b) { return 1.0; }\nfloat a__b;\n"
        "void main() { float x = mix(1.0, 2.0, 0.5); }\n"
    )
    assert [item.code for item in facts.warnings] == ["SC292", "SC290"]
    assert all(item.severity == "warning" for item in facts.warnings)


def test_a_checked_tree_may_be_checked_again() -> None:
    from shadercache.front.parse import parse
    from shadercache.valid.validate import validate

    source = Source("a.frag", SHADER)
    module = parse(source)
    first, second = validate(module, source), validate(module, source)
    assert first.types.keys() == second.types.keys()
    assert {str(t) for t in first.types.values()} == {str(t) for t in second.types.values()}


def test_stages() -> None:
    text = "#version 330\nvoid main() { gl_Position = vec4(1.0); }\n"
    assert codes(text, "vertex") == []
    assert codes(text, "fragment") == ["SC201"]
