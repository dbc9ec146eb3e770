"""Each rewrite on its own: what goes in, what comes out."""

from __future__ import annotations

from verify_tree import verify_module

from shadercache.ast import nodes as n
from shadercache.ast.memo import Memo
from shadercache.ast.walk import walk
from shadercache.emit.printer import print_module, print_node
from shadercache.front.parse import parse
from shadercache.source import Source
from shadercache.transform.drop_parameters import drop_parameters
from shadercache.transform.drop_results import drop_results
from shadercache.transform.names import FreshNames, fresh_prefix
from shadercache.transform.proof.make_precise import make_precise
from shadercache.transform.proof.write_out_matrices import write_out_matrices
from shadercache.transform.rename import rename
from shadercache.transform.specialise import Cut, insert_clones, specialise
from shadercache.transform.split import split_declarations
from shadercache.transform.unique_names import make_names_unique
from shadercache.valid.validate import validate

HEAD = "#version 330\nuniform float u_a;\nin vec3 v_a;\nout vec4 color;\n"


def module_of(text: str) -> n.Module:
    return parse(Source("test.frag", HEAD + text))


def lines(module: n.Module) -> list[str]:
    return [line.strip() for line in print_module(module).splitlines()]


def test_split_declarations() -> None:
    module = split_declarations(
        module_of(
            "struct S { float x; } s, t[2];\n"
            "void main() { float a = 1.0, b = a; for (int i = 0, j = 1; i < j; i++) {} }"
        )
    )
    text = lines(module)
    assert "struct S {" in text and "S s;" in text and "S t[2];" in text
    assert "float a = 1.0;" in text and "float b = a;" in text
    assert any("int i = 0, j = 1;" in line for line in text)


def unique(text: str) -> str:
    module = module_of(text)
    facts = validate(module, Source("test.frag", HEAD + text))
    result = make_names_unique(module, facts)
    verify_module(result)
    return print_module(result)


def test_names_are_made_unique() -> None:
    text = unique(
        """float a;
        float f(float x) { return x; }
        float f(vec2 x) { float a = x.x; { float a = a + 1.0; x.y = a; } return a + x.y; }
        float mix(float a) { return a; }
        void main() { a = u_a; color = vec4(f(a) + f(vec2(a)) + mix(a)); }"""
    )
    assert "float f(float x)" in text
    assert "float f_1(vec2 x)" in text and "f_1(vec2(a))" in text
    assert "float mix_1(float" in text and "mix_1(a)" in text
    assert "float a_1 = x.x;" in text and "float a_2 = a_1 + 1.0;" in text
    assert "return a_1 + x.y;" in text


def test_prototypes_follow_their_functions() -> None:
    text = unique(
        """float f(float x); float f(vec2 x);
        void main() { color = vec4(f(u_a) + f(vec2(u_a))); }
        float f(float x) { return x; }
        float f(vec2 y) { return y.x; }"""
    )
    assert text.count("f_1(vec2") == 3


def test_unique_names_change_nothing_where_nothing_collides() -> None:
    text = "float f(float x) { float y = x; return y; }\nvoid main() { color = vec4(f(u_a)); }"
    module = module_of(text)
    facts = validate(module, Source("test.frag", HEAD + text))
    assert make_names_unique(module, facts) is module


def test_fresh_names() -> None:
    assert fresh_prefix("float a;", "int sc;") == "sc_"
    assert fresh_prefix("float sc_a; float sc1_b;", "#define X sc2_y") == "sc3_"
    names = FreshNames({"a", "a_1"})
    assert names.make("a") == "a_2"
    assert names.make("b") == "b"
    assert names.make("b") == "b_1"
    assert "__" not in names.make("c__d")


def test_rename() -> None:
    module = module_of("float f(float x) { return x; }\nvoid main() { color = vec4(f(u_a)); }")
    text = print_module(rename(module, {"f": "g", "u_a": "u_b", "x": "y"}))
    assert "float g(float y)" in text and "return y;" in text and "g(u_b)" in text
    assert "uniform float u_b;" in text


CALLS = """float inner(float x) { float y = x * 2.0; return y + sin(x); }
float outer(float x) { return inner(x) + inner(x + 1.0); }
void main() { color = vec4(outer(u_a)); }"""


def cut_at(module: n.Module, kind: str) -> list[str]:
    """Cut ``sin(x)`` in the second call of ``inner``; the module's lines."""
    calls = {print_node(item): item for item in walk(module) if isinstance(item, n.Call)}
    path = (calls["outer(u_a)"], calls["inner(x + 1.0)"])
    cut = Cut(path, calls["sin(x)"], "sc_payload", kind)  # type: ignore[arg-type]
    clones = specialise(module, (cut,), "sc_entry", FreshNames(()), "sc_")
    return lines(insert_clones(module, clones))


def test_specialise_use() -> None:
    text = cut_at(module_of(CALLS), "use")
    assert "return y + sc_payload;" in text
    assert "return inner(x) + sc_inner(x + 1.0);" in text
    assert "color = vec4(sc_outer(u_a));" in text
    assert "return inner(x) + inner(x + 1.0);" in text  # the original stays


def test_specialise_store() -> None:
    text = cut_at(module_of(CALLS), "store")
    at = text.index("sc_payload = sin(x);")
    assert text[at + 1] == "return y + sc_payload;"


def test_specialise_goal_cuts_everything_behind_it() -> None:
    text = cut_at(module_of(CALLS), "goal")
    at = text.index("void sc_inner(float x) {")
    assert text[at + 1 : at + 4] == ["float y = x * 2.0;", "sc_payload = sin(x);", "}"]
    assert text[text.index("void sc_outer(float x) {") + 1] == "sc_inner(x + 1.0);"
    assert text[text.index("void sc_entry() {") + 1] == "sc_outer(u_a);"


def test_an_inout_parameter_that_gives_a_written_variable_back_stays() -> None:
    module = module_of(
        """vec2 g;
        void f(inout vec2 x) { g.y = 1.0; }
        void h(inout vec2 x, inout vec2 y) { y.x = 2.0; }
        void k(inout vec2 x, vec2 y) { g.x = y.x; }
        void main() {
            vec2 a; vec2 b;
            f(g); h(a, a); h(a, b); k(b, b);
            color = vec4(a, b);
        }"""
    )
    text = print_module(drop_parameters(module, {"f", "h", "k"}, Memo()))
    assert "f(g);" in text and "h(a, a);" in text and "h(a, b);" in text
    assert "k(b);" in text, "nothing else writes to what it is given"


def test_drop_parameters() -> None:
    module = module_of(
        """float f(float x, float y) { return y; }
        float g(float x) { return 1.0; }
        void main() { float z = 1.0; color = vec4(f(u_a, z) + g(z++) + f(2.0, 3.0)); }"""
    )
    text = print_module(drop_parameters(module, {"f", "g"}, Memo()))
    assert "float f(float y)" in text and "f(z)" in text and "f(3.0)" in text
    assert "g(z++)" in text  # its argument has a side effect
    assert drop_parameters(module, (), Memo()) is module


def test_drop_parameters_that_are_only_handed_down() -> None:
    module = module_of(
        """float g(float x, float y);
        float early(float x) { return g(x, 2.0); }
        float f(float x) { return 1.0; }
        float g(float x, float y) { return f(x) + y; }
        void main() { color = vec4(g(u_a, 3.0) + early(u_a)); }"""
    )
    text = print_module(drop_parameters(module, {"f", "g"}, Memo()))
    assert "float g(float y);" in text and "return f() + y;" in text
    assert "g(3.0)" in text and "return g(2.0);" in text


def test_drop_parameters_that_only_pass_through() -> None:
    module = module_of(
        """void f(inout float x, out float y) {}
        void main() { float a = u_a; float b; f(a, b); color = vec4(a + b); }"""
    )
    text = print_module(drop_parameters(module, {"f"}, Memo()))
    assert "void f(out float y)" in text and "f(b);" in text


def test_drop_results() -> None:
    module = module_of(
        """float g;
        float f(float x) { if (x > 1.0) { g = x; return x * 2.0; } return g++; }
        vec3 used(float x) { g = x; return vec3(x); }
        float kept(float x) { g = x; return x; }
        void main() { f(u_a); f(2.0); float y = used(u_a).x; kept(y); color = vec4(g); }"""
    )
    text = print_module(drop_results(module, {"f", "used"}, Memo()))
    assert "void f(float x)" in text and "x * 2.0" not in text
    assert "    }\n    g++;\n}" in text
    assert "        return;\n" in text and "vec3 used(float x)" in text
    assert "float kept(float x)" in text  # not one of those that were asked for
    assert drop_results(module, {"used"}, Memo()) is module


def test_make_precise() -> None:
    module = make_precise(
        module_of(
            """float f(float x, out float y) { y = x; if (x > 1.0) return x * 2.0; return x; }
            void main() { float a; int i = 1; float b = f(u_a * 2.0 + 1.0, a);
                          color = vec4(a + b + float(i)); }"""
        ),
        "sc_",
        "fragment",
        Memo(),
    )
    text = lines(module)
    assert text[0] == "#version 400"
    assert "precise out vec4 color;" in text
    assert any("precise out float y" in line for line in text)
    assert "precise float a;" in text and "int i = 1;" in text
    assert any(line.startswith("precise float sc_exact_") and "x * 2.0" in line for line in text)
    assert any("u_a * 2.0 + 1.0;" in line and line.startswith("precise") for line in text)
    assert "invariant in vec3 v_a;" in text and "uniform float u_a;" in text
    verify_module(module)


def test_glsl_4_20_section_4_8_1_make_precise_leaves_inputs_alone() -> None:
    text = HEAD.replace("330", "420") + "void main() { color = vec4(v_a, 1.0); }"
    made = make_precise(parse(Source("test.frag", text)), "sc_", "fragment", Memo())
    assert lines(made)[0] == "#version 420"
    assert "in vec3 v_a;" in lines(made)


def test_make_precise_does_not_take_the_stored_payload_for_a_side_effect() -> None:
    module = make_precise(
        module_of(
            """float sc_payload;
            float f(float x) { return x; }
            float sc_f(float x) { sc_payload = x; return x; }
            void main() { color = vec4(f(sc_f(u_a * 2.0) * 3.0)); }"""
        ),
        "sc_",
        "fragment",
        Memo(),
    )
    text = lines(module)
    assert "precise float sc_exact_1 = u_a * 2.0;" in text
    assert "precise float sc_exact_2 = sc_f(sc_exact_1) * 3.0;" in text


def test_arithmetic_on_matrices_is_written_out_before_it_is_made_precise() -> None:
    module = module_of(
        """uniform mat3 u_m;
        void main() { mat3 m = u_m * 2.0; vec3 a = m * (v_a * 2.0) + 3.0 * v_a;
                      a *= inverse(m + u_m); color = vec4(a, 1.0); }"""
    )
    text = lines(
        make_precise(
            write_out_matrices(module, "sc_", "fragment", Memo()), "sc_", "fragment", Memo()
        )
    )
    assert "precise vec3 sc_exact_1 = v_a * 2.0;" in text
    assert "precise vec3 a = sc_mat3_times_vec3(m, sc_exact_1) + 3.0 * v_a;" in text
    assert "precise mat3 sc_exact_2 = sc_mat3_plus_mat3(m, u_m);" in text
    assert "precise mat3 sc_exact_3 = inverse(sc_exact_2);" in text
    assert "a = sc_vec3_times_mat3(a, sc_exact_3);" in text


def test_make_precise_leaves_conditional_arguments_where_they_are() -> None:
    module = make_precise(
        module_of(
            """float f(float x) { return x; }
            void main() { float a = u_a > 0.0 ? f(1.0 / u_a) : 0.0; color = vec4(a); }"""
        ),
        "sc_",
        "fragment",
        Memo(),
    )
    assert "f(1.0 / u_a)" in print_module(module)


def goals(text: str, *wanted: str) -> list[str]:
    """The lines of the clones with these goals: names of the calls on the path, an expression."""
    module = module_of(text)
    functions = {d.name: d for d in module.decls if isinstance(d, n.FunctionDef)}
    cuts: list[Cut] = []
    for number, (*names, shown) in enumerate(item.split(" > ") for item in wanted):
        path: list[n.Call] = []
        for name in names:
            body = functions[path[-1].name if path else "main"].body
            path += [c for c in walk(body) if isinstance(c, n.Call) and c.name == name][:1]
        body = functions[path[-1].name if path else "main"].body
        found = (e for e in walk(body) if isinstance(e, n.Binary) and print_node(e) == shown)
        cuts.append(Cut(tuple(path), next(found), f"sc_{number}", "goal"))
    clones = specialise(module, tuple(cuts), "sc_main", FreshNames(()), "sc_")
    made = (line.strip() for _, clone in clones.made for line in print_node(clone).splitlines())
    return [line for line in made if line != "}"]


TWO = """
float f(float x) { float a = x * 3.0; return a + 1.0; }
float g(float x) { float b = x * 4.0; return b - 1.0; }
void main() { float c = u_a * 2.0; c += f(c) + g(c); color = vec4(c * 5.0, g(f(c + 7.0)), c, 1.0); }
"""


def test_what_follows_the_last_goal_is_cut_off() -> None:
    made = goals(TWO, "u_a * 2.0", "g > x * 4.0")
    assert made[:2] == ["void sc_g(float x) {", "sc_1 = x * 4.0;"]
    assert made[2:] == ["void sc_main() {", "sc_0 = u_a * 2.0;", "float c = sc_0;", "sc_g(c);"]


def test_calls_to_the_last_goals_stand_alone() -> None:
    made = goals(TWO, "f > x * 3.0", "g > x * 4.0")
    assert made[-3:] == ["float c = u_a * 2.0;", "sc_f(c);", "sc_g(c);"]
    made = goals(TWO, "g > x * 4.0", "c * 5.0")
    assert "float sc_g(float x) {" in made, "what comes later needs its value"
    assert made[-2:] == ["c += f(c) + sc_g(c);", "sc_1 = c * 5.0;"]


def test_a_goal_in_an_argument_comes_first() -> None:
    text = TWO.replace("c += f(c) + g(c); ", "")
    assert goals(text, "g > x * 4.0", "c + 7.0")[-2:] == ["sc_1 = c + 7.0;", "sc_g(f(sc_1));"]
    made = goals(text, "g > x * 4.0", "f > x * 3.0")
    assert "float sc_f(float x) {" in made, "the other call needs its value"
    assert made[-1] == "sc_g(sc_f(c + 7.0));"
