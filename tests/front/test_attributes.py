"""Attributes of loops and branches (GL_EXT_control_flow_attributes) are left out of the tree."""

from __future__ import annotations

import pytest

from shadercache.diagnostics import InputError
from shadercache.emit.printer import print_module
from shadercache.front.parse import parse
from shadercache.source import Source

ON = "#extension GL_EXT_control_flow_attributes : enable\n"


def printed(body: str, extension: str = ON) -> str:
    text = f"#version 450\n{extension}void main() {{ {body} }}\n"
    return print_module(parse(Source("test.frag", text)))


@pytest.mark.parametrize(
    ("hinted", "plain"),
    [
        ("[[unroll]] for (;;) ;", "for (;;) ;"),
        ("[[unroll, dependency_length(4)]] while (b) ;", "while (b) ;"),
        ("[[flatten]] if (b) ; else ;", "if (b) ; else ;"),
        ("[[branch]] switch (a[b[0]]) { }", "switch (a[b[0]]) { }"),
    ],
)
def test_hints_are_left_out(hinted: str, plain: str) -> None:
    assert printed(hinted) == printed(plain)


def test_a_whole_function_has_an_attribute() -> None:
    text = "#version 450\n#extension GL_EXT_subgroup_uniform_control_flow : enable\n"
    module = parse(Source("test.frag", f"{text}void main() [[subgroup_uniform_control_flow]] {{}}"))
    assert len(module.decls) == 1


@pytest.mark.parametrize(
    ("body", "extension"), [("[[unroll]] for (;;) ;", ""), ("[[unroll for (;;) ;", ON)]
)
def test_without_the_extension_or_end_it_is_a_mistake(body: str, extension: str) -> None:
    with pytest.raises(InputError) as caught:
        printed(body, extension)
    assert [item.code for item in caught.value.diagnostics] == ["SC103"]
