"""How many expressions are offered and refused, and what the refused ones cost."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from shadercache.analysis.refusals import Code
from shadercache.compiler import Analysis, analyse
from shadercache.source import Source
from tests.conftest import Golden

from .__main__ import MOST, main, row_of, static_rows, summary
from .folder import folder_costs
from .offers import programs, refused_cost

HEAD = """#version 330
in vec3 p;
in vec2 uv;
out vec4 color;
float wave(vec3 q) { return sin(q.x * 3.0) * cos(q.y * 2.0) + sin(q.z + cos(q.x)); }
"""
VERTEX = """#version 330
in vec3 a;
out vec3 p;
out vec2 uv;
void main() { p = a; uv = a.xy; gl_Position = vec4(a, 1.0); }
"""


def analysis_of(body: str) -> Analysis:
    text = f"{HEAD}void main() {{ {body} }}"
    return analyse(Source("test.frag", text), Source("test.vert", VERTEX))


def test_counts_of_the_corpus_and_the_cases(golden: Golden) -> None:
    rows, lines = [], []
    every: Counter[str] = Counter()
    for name, analysis in static_rows():
        if analysis is None:
            lines.append(f"{name}: refused as a whole")
            continue
        nodes = analysis.nodes
        counts = Counter(node.refusal.code.code if node.refusal else "offered" for node in nodes)
        rows.append(row_of(name, refused_cost(analysis), None))
        share = rows[-1]["static_refused"] / rows[-1]["static"]
        lines.append(f"{name}: {_told(counts)}; refused cost {share:.1%}")
        every += counts
    found = summary(rows)
    lines.append(f"all: {_told(every)}; refused cost {found['static']:.1%}")
    golden(Path(__file__).with_name("counts.txt"), "".join(f"{line}\n" for line in lines))
    assert found["static"] <= MOST
    missing = {code.code for code in Code} - every.keys()
    assert missing == {"SC317"}, "codes that no shader shows"


def _told(counts: Counter[str]) -> str:
    return ", ".join(f"{code} {counts[code]}" for code in sorted(counts, reverse=True))


def test_what_nothing_offered_needs_is_refused_cost() -> None:
    cost = refused_cost(analysis_of("color = vec4(wave(p) + dFdx(wave(p.yxz)));"))
    assert set(cost.codes) == {"SC312", "SC315"}
    assert 0.4 * cost.total < cost.cost < 0.6 * cost.total
    cost = refused_cost(analysis_of("color = vec4(wave(p) + dFdx(p.x));"))
    assert set(cost.codes) == {"SC312"}
    assert 0.0 < cost.cost < 0.2 * cost.total


def test_a_loop_whose_sum_is_offered_is_not_refused() -> None:
    loop = "float s = 0.0; for (int i = 0; i < 4; i++) s += wave(p * float(i));"
    assert refused_cost(analysis_of(f"{loop} color = vec4(s * wave(p));")).cost == 0.0
    kept = refused_cost(analysis_of(f"{loop} color = vec4(s * dFdx(p.x)) + wave(p);"))
    assert kept.cost < 0.1 * kept.total
    alone = refused_cost(analysis_of(f"{loop.replace('wave(p', 'dFdx(p.x')} color = vec4(s);"))
    assert alone.cost > 0.5 * alone.total


def test_the_program_of_the_offers_computes_them_and_nothing_else() -> None:
    body = "float a = dFdx(wave(p.yxz)); color = vec4(a * a * wave(p));"
    text = programs(analysis_of(body))["offers"]["original.frag"]
    assert "wave(p)" in text
    assert "dFdx" not in text
    assert "yxz" not in text


def test_a_folder_of_shaders(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    body = "color = vec4(wave(p) + dFdx(wave(p.yxz)));"
    (tmp_path / "half.frag").write_text(f"{HEAD}void main() {{ {body} }}")
    (tmp_path / "half.vert").write_text(VERTEX)
    (tmp_path / "wrong.frag").write_text("#version 330\nvoid main() { none(); }\n")
    (tmp_path / "unfit.frag").write_text(f"{HEAD}void main() {{ color = vec4(uv, p.xy); }}")
    (tmp_path / "unfit.vert").write_text(VERTEX.replace("out vec2 uv", "vec2 uv"))
    found = {item.name: item for item in folder_costs(tmp_path, 1)}
    root = tmp_path.name
    assert found[f"{root}/half.frag"].cost == refused_cost(analysis_of(body))
    assert found[f"{root}/wrong.frag"].code == "SC201"
    assert found[f"{root}/unfit.frag"].code == "SC406"
    assert main(["--static", "--shaders", str(tmp_path)]) == 0
    told = capsys.readouterr().out
    assert "SC312: " in told
    assert f"{root}/wrong.frag (SC201)" in told


def test_a_folder_without_shaders_is_told(tmp_path: Path) -> None:
    assert main(["--shaders", str(tmp_path)]) == 1
    with pytest.raises(SystemExit):
        main(["--shaders", str(tmp_path / "none")])
