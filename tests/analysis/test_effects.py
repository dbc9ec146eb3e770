"""What functions read and write."""

from __future__ import annotations

from shadercache.analysis.effect_table import EffectTable
from shadercache.front.parse import parse
from shadercache.source import Source


def test_a_chain_of_20_000_calls() -> None:
    """Each link is looked at once, and none inside the look at another."""
    text = f"""#version 330
    in float v;
    out vec4 color;
    float half_of(float x) {{ return x * 0.5; }}
    void main() {{ color = vec4({" + ".join(["half_of(v)"] * 20_000)}); }}
    """
    table = EffectTable(parse(Source("test.frag", text)))
    assert table.linked("main").head.live_at_entry == {"v"}
