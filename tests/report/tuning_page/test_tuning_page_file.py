"""The file of a tuning's page: what stands in it, and the commands that it names."""

from __future__ import annotations

import gzip
import json
import re
import shlex
from base64 import b64decode
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from shadercache.cli.app import main
from shadercache.diagnostics import UsageError
from shadercache.report.parts import page_parts
from shadercache.report.tuning_page import tuning_page as making
from shadercache.report.tuning_page.tuned_texts import texts_of
from shadercache.report.tuning_page.tuning_words import headline, left_out, verdicts, way_in_words
from shadercache.tuning.front import predicted_front, worth_a_look

from .conftest import PERIODS, Made, made_pictures, made_tuning


def element(page: bytes, name: str) -> str:
    """The text of a script element with an id."""
    found = re.search(rf'<script type="[^"]*" id="{name}">(.*?)</script>', page.decode(), re.S)
    assert found is not None
    return found[1]


def data_of(page: bytes) -> dict[str, Any]:
    data: dict[str, Any] = json.loads(element(page, "data"))
    return data


def test_a_page_is_one_file_with_all_that_it_needs(made: Made) -> None:
    page = made.page(made_pictures([((1, 3),), ((1, 12),)]))
    own = page.decode().replace(page_parts.plotly_script(), "")
    assert not re.search(r"""(?:src|href)=["']?(?!data:)\w|@import|url\(""", own)
    assert len(page) < 12_000_000
    data = data_of(page)
    assert data["tuning"] == made.found
    assert [shot["plan"] for shot in data["shots"]] == [[[1, 3]], [[1, 12]]]
    named = {name for shot in data["shots"] for name in shot["layers"].values()}
    assert named | set(data["payloads"].values()) == set(data["pictures"])
    texts = json.loads(gzip.decompress(b64decode(element(page, "texts"))))
    hashes = [*data["sources"], *(one["files"] for one in data["families"])]
    assert {hashed for files in hashes for hashed in files.values()} == set(texts)
    assert made.linker.analysis.fragment.text == texts[data["sources"][0]["dragon.frag"]]


def test_where_room_is_short_the_first_plans_have_pictures(
    made: Made, monkeypatch: pytest.MonkeyPatch
) -> None:
    pictures = made_pictures([((1, 3),), ((1, 12),), ((0, 4),)])
    sizes = [len(uri) for uri in data_of(made.page(pictures))["pictures"].values()]
    monkeypatch.setattr(making.PageParts, "room", lambda *_: sum(sizes) // 2)
    data = data_of(made.page(pictures))
    assert 0 < len(data["shots"]) < 3 and data["shots"][0]["plan"] == [[1, 3]]
    assert sum(len(uri) for uri in data["pictures"].values()) <= sum(sizes) // 2


def test_no_text_ends_the_script(made: Made) -> None:
    evil = "</script><script>alert(1)</script><!-- $data ${plotly}"
    found = made.found | {"title": evil}
    page = making.tuning_page(found, making.TunedPictures(), texts_of(found, made.linker))
    assert data_of(page)["tuning"]["title"] == evil
    assert b"<script>alert" not in page


def test_without_plotly_the_extra_is_named(made: Made, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(page_parts, "find_spec", lambda name: None)
    with pytest.raises(UsageError, match=r"plotly \[SC031\](.|\n)*shadercache\[report\]"):
        made.page()


@pytest.mark.parametrize("number", [0, 1, 2, 3])
def test_the_command_writes_what_the_page_shows(made: Made, number: int, tmp_path: Path) -> None:
    texts = texts_of(made.found, made.linker).families[number]
    words = shlex.split(texts.command)
    assert words[-2:] == ["-o", "cached"]
    assert main([*words[1:-1], str(tmp_path / "cached")]) == 0
    assert texts.files
    for name, text in texts.files.items():
        assert (tmp_path / "cached" / name).read_bytes().decode() == text


def test_the_words_say_what_was_chosen(made: Made) -> None:
    found = made.found
    gain = found["proven"][1]["speedup"]["median"]
    told = headline(found)
    assert f"Within an RMSE of .02, dragon is drawn *{gain:.2f}× as fast*" in told
    assert "refreshed every 12 frames" in told and told.endswith("For .0005 leave it alone.")
    alone, *chosen = verdicts(found)
    assert (
        alone["large"] == "leave it alone" and alone["text"] == "What is near enough is no faster."
    )
    worst = found["proven"][0]["worst"]
    assert f"{worst:.2g}".removeprefix("0") in chosen[0]["text"]
    assert any("may not be cached" in sentence for sentence in left_out(found))


def test_a_psnr_is_told_in_decibels(made: Made) -> None:
    found = made_tuning(made.linker, (60.0, 40.0), "psnr", values=1).found
    assert "Within a PSNR of 40 dB" in headline(found)
    assert [round(one["error"], 4) for one in verdicts(found)] == [0.001, 0.01]
    assert " dB on average" in list(verdicts(found))[1]["text"]


def test_where_nothing_was_chosen_it_says_so(made: Made) -> None:
    answers = [one | {"proven": None, "why": "it is slow"} for one in made.found["answers"]]
    found = made.having(answers=answers).found
    assert headline(found).startswith("*Leave dragon alone*")
    assert {one["large"] for one in verdicts(found)} == {"leave it alone"}


def test_what_is_proven_comes_first_among_the_pictures(made: Made) -> None:
    def ran(*parts: tuple[int, int]) -> SimpleNamespace:
        return SimpleNamespace(plan=made.plan(*parts))

    trials = SimpleNamespace(families=made.families)
    tuning = SimpleNamespace(
        drawings=SimpleNamespace(trials=trials, finalists=[ran((0, 4)), ran((1, 8))]),
        question=SimpleNamespace(
            space=SimpleNamespace(periods=PERIODS), bounds=[SimpleNamespace(error=0.005)]
        ),
        proven=[ran((1, 12)), ran((0, 4))],
    )
    plans = [plan for plan, _ in worth_a_look(tuning, made.linker.scene)]
    assert plans[:3] == [[[1, 12]], [[0, 4]], [[1, 8]]]
    keys = [tuple(map(tuple, plan)) for plan in plans]
    assert len(set(keys)) == len(keys) > 5
    front = predicted_front(made.families, PERIODS)
    numbers = {made.families.index(family) for plan in front for family, _ in plan.parts}
    first = [number for [[number, _]] in plans[: 3 + len(numbers - {0, 1})]]
    assert numbers <= set(first), "each family of the front once, before any of them twice"


def test_the_front_is_what_no_plan_beats(made: Made) -> None:
    front = predicted_front(made.families, PERIODS)
    every = [made.plan((number, period)) for number in range(12) for period in PERIODS]
    for plan in every:
        within = [one for one in front if one.hasty_error <= plan.hasty_error]
        assert plan.share >= 1.0 or min(one.share for one in within) <= plan.share
    assert [one.share for one in front] == sorted((one.share for one in front), reverse=True)


def test_what_has_no_such_variant_shows_what_draws_it(colonnade: Made) -> None:
    """Shaders of single objects are drawn by another algorithm where they have none by that."""
    group = len(colonnade.found["groups"]) - 1
    own = next(one for one in colonnade.found["families"] if one["group"] == group)
    chosen = own["configuration"]
    chosen = chosen | {"algorithm": "3-pass", "filter": chosen["filter"] | {"kind": "carried"}}
    found = colonnade.having(families=[own | {"configuration": chosen}]).found
    [texts] = texts_of(found, colonnade.linker).families
    assert texts.instead == "2-pass" and set(texts.files) >= {"2-pass.hit.frag", "2-pass.miss.frag"}
    assert "--passes 2 " in texts.command
    assert way_in_words(own, texts.instead).endswith("here drawn by two passes")
