"""The page of a tuning as a reader has it: in headless Chromium, from a file, without a network."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from bench.browser import MISSING, open_browser, open_page, set_window
from shadercache.report.tuning_page.tuned_texts import FamilyTexts, TunedTexts
from shadercache.report.tuning_page.tuning_page import TunedPictures, tuning_page
from shadercache.tuning.front import predicted_front

from .conftest import PERIODS, Made, made_pictures, made_tuning

if TYPE_CHECKING:
    from selenium.webdriver import Chrome
    from selenium.webdriver.remote.webelement import WebElement

pytestmark = [
    pytest.mark.skipif(MISSING is not None, reason=str(MISSING)),
    pytest.mark.xdist_group("browser"),
]


@pytest.fixture(scope="module")
def browser() -> Iterator[Chrome]:
    with open_browser() as opened_one:
        yield opened_one


@pytest.fixture
def quiet(browser: Chrome) -> Iterator[None]:
    """Nothing is complained of."""
    browser.get_log("browser")
    yield
    assert browser.get_log("browser") == []


@pytest.fixture(scope="module")
def page(made: Made, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("page") / "page.html"
    path.write_bytes(made.page(made_pictures([((1, 3),), ((1, 12),), ((0, 4),)])))
    return path


@pytest.fixture
def shown(browser: Chrome, page: Path, quiet: None) -> Chrome:
    """The page of the made-up tuning, just opened."""
    set_window(browser, 1280)
    open_page(browser, page)
    return browser


def show(browser: Chrome, path: Path, data: bytes) -> None:
    """Open another page."""
    path.write_bytes(data)
    set_window(browser, 1280)
    open_page(browser, path)


def found(browser: Chrome, selector: str) -> WebElement:
    return browser.find_element("css selector", selector)


def text(browser: Chrome, selector: str) -> str:
    told: str = found(browser, selector).get_attribute("textContent") or ""
    return told


def run(browser: Chrome, script: str, *arguments: Any) -> Any:
    return browser.execute_script(f"return {script}", *arguments)


def settle(browser: Chrome) -> None:
    """Wait until all that is done later is done."""
    from selenium.webdriver.support.ui import WebDriverWait

    WebDriverWait(browser, 20).until(lambda one: run(one, "waiting.size === 0 && !running"))


def drag(browser: Chrome, element: WebElement, x: int) -> None:
    """Take hold of what is at the bound now, and let go ``x`` pixels farther to the right."""
    from selenium.webdriver import ActionChains

    browser.execute_script("arguments[0].scrollIntoView({block: 'center'})", element)
    settle(browser)
    at = run(browser, "Number(byId('bound').value) / STEPS")
    offset = round((at - 0.5) * run(browser, "byId('plane-over').getBoundingClientRect().width"))
    chain = ActionChains(browser)
    if element.get_attribute("id") == "bound":
        chain = chain.move_to_element_with_offset(element, offset, 0)
    else:
        chain = chain.move_to_element(element)
    chain.click_and_hold().move_by_offset(x // 2, 0).move_by_offset(x - x // 2, 0)
    chain.release().perform()
    settle(browser)


def look(browser: Chrome) -> dict[str, Any]:
    """What the page shows of the choice."""
    settle(browser)
    marks = browser.find_elements("css selector", "#source mark")
    return {
        "plan": run(browser, "choice.plan && choice.plan.parts"),
        "bound": run(browser, "choice.bound"),
        "marked": "".join((one.get_attribute("textContent") or "") for one in marks),
        "numbers": text(browser, "#details"),
        "emitted": text(browser, "#emitted"),
        "readout": text(browser, "#readout"),
    }


@pytest.mark.parametrize("width", [1280, 390])
@pytest.mark.parametrize("theme", ["light", "dark"])
def test_curves_are_drawn(
    browser: Chrome, page: Path, quiet: None, width: int, theme: Any, made: Made
) -> None:
    set_window(browser, width, theme)
    open_page(browser, page)
    # A line for each algorithm, in which those of its families stand one after another; the front.
    lines = [line.get_attribute("d") for line in browser.find_elements("css selector", ".js-line")]
    assert sum(line.count("M") for line in lines) >= len(made.families)
    assert len(browser.find_elements("css selector", "#plane .errorbar")) >= 4
    assert run(browser, "document.documentElement.scrollWidth") == width
    rail, plane = found(browser, ".track").rect, found(browser, "#plane-over").rect
    assert abs(rail["x"] - plane["x"]) < 1 and abs(rail["width"] - plane["width"]) < 1
    ground = found(browser, "body").value_of_css_property("background-color")
    bright = sum(map(int, ground[ground.index("(") + 1 : -1].split(",")[:3])) > 380
    assert bright == (theme == "light")


def test_the_models_are_those_of_tuning(shown: Chrome, made: Made) -> None:
    for number, family in enumerate(made.families):
        for period in (2, 3, 5, 7, 13, 14, 48, 100):
            told = run(
                shown,
                "[familyShare(arguments[0], arguments[1]), familyError(arguments[0], arguments[1]),"
                " hastyError(arguments[0], arguments[1])]",
                number,
                period,
            )
            error, hasty = family.error_at(period), family.hasty_error_at(period)
            expected = [family.share(period), error, hasty]
            assert told == pytest.approx(expected, rel=1e-12)
    assert {family.error.follows for family in made.families if family.error} == {True, False}


def front_of(browser: Chrome) -> set[tuple[tuple[int, int], ...]]:
    parts = run(browser, "predictedFront(() => false)")
    return {tuple(sorted((number, period) for number, period in one)) for one in parts}


def expected_front(made: Made) -> set[tuple[tuple[int, int], ...]]:
    numbers = {id(family): number for number, family in enumerate(made.families)}
    front = predicted_front(made.families, PERIODS)
    return {tuple(sorted((numbers[id(one)], n) for one, n in plan.parts)) for plan in front}


def test_the_front_is_that_of_tuning(shown: Chrome, made: Made) -> None:
    assert front_of(shown) == expected_front(made)


def test_plans_of_several_shaders_are_combined(
    browser: Chrome, quiet: None, colonnade: Made, tmp_path: Path
) -> None:
    made = colonnade
    groups = len(made.found["groups"])
    assert groups > 1
    told = tuple(FamilyTexts({"it.frag": "void main() {}\n"}, "none") for _ in made.families)
    own = tuple({one["fragment"]: "void main() {}\n"} for one in made.found["groups"])
    show(
        browser,
        tmp_path / "page.html",
        tuning_page(made.found, TunedPictures(), TunedTexts(own, told)),
    )
    front = expected_front(made)
    assert front_of(browser) == front
    several = next(list(map(list, plan)) for plan in front if len(plan) == groups)
    browser.execute_script("choice.choosePlan(arguments[0])", several)
    settle(browser)
    plan = made.plan(*several)
    assert run(browser, "choice.plan.predicted.share") == pytest.approx(plan.share)
    assert run(browser, "choice.plan.predicted.error") == pytest.approx(plan.error)
    assert run(browser, "choice.plan.predicted.hasty") == pytest.approx(plan.hasty_error)
    tabs = browser.find_elements("css selector", "#source-name button")
    assert [tab.text for tab in tabs] == [one["fragment"] for one in made.found["groups"]]
    tabs[-1].click()
    assert tabs[-1].get_attribute("aria-selected") == "true"


@pytest.mark.parametrize("held", ["#bound", "#grip"])
def test_dragging_the_bound_changes_all_that_is_shown(shown: Chrome, made: Made, held: str) -> None:
    before = look(shown)
    assert before["plan"] == [[1, 12]], "it begins with what gains the most"
    seen = {str(before["plan"]): before}
    width = found(shown, "#plane-over").size["width"]
    for step in (-0.5, 0.3, 0.25):
        drag(shown, found(shown, held), round(step * width))
        now = look(shown)
        assert now["plan"] is not None
        seen[str(now["plan"])] = now
        [[number, period]] = now["plan"]
        value = made.families[number].value
        assert "".join(now["marked"].split()) == "".join(
            "".join(n.text.split()) for n in value.nodes
        )
        assert (
            f"every {period} frames" in now["numbers"]
            and f"every {period} frames" in now["readout"]
        )
        fitting = run(
            shown, "picks.filter(({ need }) => need <= choice.bound).map(({ share }) => share)"
        )
        assert run(shown, "choice.plan.share") <= min(fitting) / 0.96
    assert len(seen) > 2
    for key in ("marked", "numbers", "emitted", "readout"):
        assert len({one[key] for one in seen.values()}) > 1, f"{key} stays"


def test_with_a_larger_bound_nothing_gets_slower_by_much(shown: Chrome) -> None:
    speeds = run(
        shown,
        "Array.from({ length: STEPS + 1 }, (_, at) =>"
        " pickWithin(10 ** (range[0] + (at / STEPS) * (range[1] - range[0]))))"
        ".filter((plan) => plan).map(({ share }) => 1 / share)",
    )
    assert len(speeds) > 100
    fastest = 0.0
    for speed in speeds:
        assert speed >= 0.95 * fastest
        fastest = max(fastest, speed)


def test_the_slider_stands_at_the_answers_for_the_bounds_that_were_asked(
    shown: Chrome, made: Made
) -> None:
    ticks = shown.find_elements("css selector", "#ticks button")
    assert [tick.text for tick in ticks] == [".0005", ".005", ".02"]
    for tick, answer in zip(ticks, made.found["answers"], strict=True):
        shown.execute_script("arguments[0].click()", tick)
        now = look(shown)
        assert run(shown, "boundAt(Number(byId('bound').value))") == answer["bound"]
        if answer["proven"] is None:
            assert now["plan"] is None and "is no faster" in now["numbers"]
            assert "leave it alone" in now["readout"] and not now["marked"]
            assert "nothing is emitted" in now["emitted"] or "void main" in now["emitted"]
            continue
        ratio = made.found["proven"][answer["proven"]]["speedup"]
        assert f"{ratio['median']:.2f}×" in now["readout"]
        assert "proven on unseen frames" in now["readout"]
        told = f"{ratio['median']:.2f}× [{ratio['low']:.2f}–{ratio['high']:.2f}]"
        assert told in now["numbers"]


def test_what_was_not_measured_says_so(shown: Chrome) -> None:
    cells = (
        "[...document.querySelectorAll('#details .beside td.none')].map((one) => one.textContent)"
    )
    shown.execute_script("choice.choosePlan([[0, 4]])")  # drawn at full length alone
    settle(shown)
    assert run(shown, cells) == ["not measured"] * 2
    assert "measured, not proven" in text(shown, "#details")
    shown.execute_script("choice.choosePlan([[5, 7]])")
    settle(shown)
    assert set(run(shown, cells)) == {"not measured"}
    assert "predicted, not measured" in text(shown, "#details")
    assert not found(shown, "#undrawn").get_attribute("hidden")
    shown.execute_script("choice.choosePlan([[1, 3]])")
    settle(shown)
    assert run(shown, cells) == ["not measured"] * 3, "it was drawn on unseen frames alone"


def test_pictures_follow_the_plan(shown: Chrome) -> None:
    shown.execute_script("choice.choosePlan([[1, 3]])")
    settle(shown)
    first = found(shown, "#over").get_attribute("src")
    shown.execute_script("choice.choosePlan([[0, 4]])")
    settle(shown)
    assert found(shown, "#over").get_attribute("src") != first
    found(shown, "#layers input[value=difference]").click()
    assert "RMSE .012" in text(shown, "#legend")
    found(shown, "#layers input[value=hits]").click()
    assert "hit: reused 75.0 %" in text(shown, "#legend")
    shown.execute_script("choice.choosePlan([[5, 7]])")
    settle(shown)
    assert text(shown, "#over-tag") == "payload"
    assert found(shown, "#layers input[value=cached]").get_attribute("disabled")
    shown.execute_script("choice.choosePlan([[1, 3]])")
    settle(shown)
    assert text(shown, "#over-tag") == "hit map", "the layer that was chosen comes back"


def test_of_what_was_not_drawn_the_nearest_period_is_shown(shown: Chrome) -> None:
    for period, nearest in ((2, 3), (5, 3), (8, 12), (48, 12)):
        shown.execute_script("choice.choosePlan([[1, arguments[0]]])", period)
        settle(shown)
        assert text(shown, "#over-tag") == f"cached, every {nearest} frames"
        assert f"with a refresh every {nearest} frames" in text(shown, "#undrawn")
    shown.execute_script("choice.choosePlan([[1, 12]])")
    settle(shown)
    assert text(shown, "#over-tag") == "cached" and found(shown, "#undrawn").get_attribute("hidden")


def test_a_curve_tells_what_it_is_and_a_click_chooses_it(shown: Chrome) -> None:
    from selenium.webdriver import ActionChains

    place = run(
        shown,
        "(() => { const number = 7, one = curves.find((curve) => curve.number === number).points"
        ".find(({ period }) => period === 8), area = byId('plane-over').getBoundingClientRect();"
        " window.scrollTo(0, area.top + scrollY - 100);"
        " const now = byId('plane-over').getBoundingClientRect();"
        " return [Math.round(now.left + planeAxes.across(one.x) * now.width),"
        " Math.round(now.top + (1 - planeAxes.along(one.y)) * now.height)]; })()",
    )
    actions = ActionChains(shown)
    actions.w3c_actions.pointer_action.move_to_location(place[0] + 3, place[1])
    actions.w3c_actions.pointer_action.move_to_location(*place)
    actions.perform()
    settle(shown)
    card = text(shown, "#card")
    assert "every 8 frames" in card and "predicted, not measured" in card
    actions = ActionChains(shown)
    actions.w3c_actions.pointer_action.click()
    actions.perform()
    assert look(shown)["plan"] == [[7, 8]]


def test_keys_move_the_bound(shown: Chrome) -> None:
    from selenium.webdriver import Keys

    slider = found(shown, "#bound")
    slider.send_keys(Keys.HOME)
    low = run(shown, "choice.bound")
    slider.send_keys(Keys.ARROW_RIGHT * 30)
    assert run(shown, "choice.bound") > low
    assert (slider.get_attribute("aria-valuetext") or "").startswith("RMSE ")
    slider.send_keys(Keys.END)
    assert (
        run(shown, "choice.plan.share") <= min(run(shown, "picks.map(({ share }) => share)")) / 0.96
    )


def test_the_table_has_every_value_and_marks_what_follows_no_model(
    shown: Chrome, made: Made
) -> None:
    shown.execute_script("byId('numbers').open = true")
    settle(shown)
    rows = shown.find_elements("css selector", "#table tbody tr")
    values = sum(len(one["values"]) for one in made.found["groups"])
    assert len(rows) == len(made.families) + values - 3
    told = text(shown, "#table")
    wrong = sum(not family.error.follows for family in made.families if family.error)
    assert (
        told.count("not followed") == wrong and told.count("not drawn: 70 % foretold") == values - 3
    )
    found(shown, "#table th:nth-child(4) button").click()
    cells = shown.find_elements("css selector", "#table tbody td:nth-child(4)")
    shares = [float(cell.text.rstrip(" %")) for cell in cells if cell.text]
    assert shares == sorted(shares), "the other way round than at first"
    found(shown, "#table tbody td button").click()
    settle(shown)
    assert run(shown, "choice.pinned")


def test_nothing_to_show_is_told(browser: Chrome, quiet: None, made: Made, tmp_path: Path) -> None:
    answers = [one | {"proven": None, "why": "there is no value"} for one in made.found["answers"]]
    empty = made.having(families=[], finalists=[], proven=[], answers=answers)
    show(browser, tmp_path / "page.html", empty.page())
    assert "No value was drawn" in text(browser, "#plane")
    assert "leave it alone" in look(browser)["readout"]
    assert "original" in text(browser, "#absent")


def test_a_psnr_has_an_axis_of_decibels(
    browser: Chrome, quiet: None, made: Made, tmp_path: Path
) -> None:
    other = made_tuning(made.linker, (60.0, 40.0), "psnr", values=1)
    show(browser, tmp_path / "page.html", other.page())
    ticks = run(browser, "byId('plane')._fullLayout.xaxis.ticktext")
    assert "40 dB" in ticks
    assert [tick.text for tick in browser.find_elements("css selector", "#ticks button")] == [
        "60 dB",
        "40 dB",
    ]
