"""Reports as a reader has them: in headless Chromium, from a file, without a network."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from msgspec import structs

from bench.browser import MISSING, open_browser, open_page, set_window
from shadercache.report.page.page_file import page_file
from shadercache.sweep.row import Row

from .conftest import Sourced

if TYPE_CHECKING:
    from selenium.webdriver import Chrome
    from selenium.webdriver.remote.webelement import WebElement

pytestmark = [
    pytest.mark.skipif(MISSING is not None, reason=str(MISSING)),
    pytest.mark.xdist_group("browser"),
]

PLOTS = "plane", "nodes", "periods", "curves"


@pytest.fixture(scope="module")
def browser() -> Iterator[Chrome]:
    with open_browser() as opened:
        yield opened


@pytest.fixture
def quiet(browser: Chrome) -> Iterator[None]:
    """Nothing is complained of."""
    browser.get_log("browser")
    yield
    assert browser.get_log("browser") == []


@pytest.fixture(scope="module")
def page(sourced: Sourced, made_rows: list[Row], tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("page") / "page.html"
    path.write_bytes(page_file(sourced(made_rows)))
    return path


@pytest.fixture
def opened(browser: Chrome, page: Path, quiet: None) -> Chrome:
    """The page of the made-up store, just opened."""
    set_window(browser, 1280)
    open_page(browser, page)
    return browser


def open_rows(browser: Chrome, sourced: Sourced, rows: Sequence[Row], folder: Path) -> None:
    """Open a page of other rows."""
    path = folder / "page.html"
    path.write_bytes(page_file(sourced(rows)))
    set_window(browser, 1280)
    open_page(browser, path)


def found(browser: Chrome, selector: str) -> WebElement:
    return browser.find_element("css selector", selector)


def count(browser: Chrome, selector: str) -> int:
    return len(browser.find_elements("css selector", selector))


def text(browser: Chrome, selector: str) -> str:
    told: str = found(browser, selector).get_attribute("textContent") or ""
    return told


def wait(browser: Chrome, script: str) -> Any:
    """What the script returns, once that is something."""
    from selenium.webdriver.support.ui import WebDriverWait

    return WebDriverWait(browser, 20).until(lambda one: one.execute_script(f"return {script}"))


def hover(browser: Chrome, point: WebElement) -> None:
    from selenium.webdriver import ActionChains

    # Scrolling hides the card, so it has to be over.
    browser.execute_async_script(
        "arguments[0].scrollIntoView({block: 'center'});"
        "const done = arguments[1]; requestAnimationFrame(() => requestAnimationFrame(done))",
        point,
    )
    # Plotly looks at what is under the pointer where it moves, not where it comes in.
    ActionChains(browser).move_to_element_with_offset(point, 1, 1).move_to_element(point).perform()


@pytest.mark.parametrize("width", [1280, 390])
@pytest.mark.parametrize("theme", ["light", "dark"])
def test_plots_are_drawn(
    browser: Chrome, page: Path, quiet: None, width: int, theme: Any, made_rows: list[Row]
) -> None:
    set_window(browser, width, theme)
    open_page(browser, page)
    results = sum(row.result is not None for row in made_rows)
    # Every configuration, the chosen one's ring, and the feet of the floor.
    assert count(browser, "#plane .points path") >= results + 1
    # Two values share a setting; of their six variants one has failed.
    assert count(browser, "#nodes .xy .points path") == 6 - 1
    assert count(browser, "#periods .points path") in (8, 12)
    assert count(browser, "#curves .points path") == 12
    for plot in PLOTS:
        assert found(browser, f"#{plot} .main-svg").size["width"] <= width
    assert browser.execute_script("return document.documentElement.scrollWidth") == width
    ground = found(browser, "body").value_of_css_property("background-color")
    bright = sum(map(int, ground[ground.index("(") + 1 : -1].split(",")[:3])) > 380
    assert bright == (theme == "light")


def test_axes_span_a_factor_and_points_are_labelled(opened: Chrome) -> None:
    across, along = opened.execute_script(
        "const {xaxis, yaxis} = document.getElementById('plane')._fullLayout;"
        "return [xaxis.range, yaxis.range]"
    )
    assert across[0] == 0 and across[1] > 100
    assert along[1] - along[0] >= 1
    labels = [one.text for one in opened.find_elements("css selector", "#plane .annotation")]
    assert {"original", "geometry alone", "half resolution"} <= set(labels)
    assert any(label.endswith(" · 32") for label in labels)
    key = [one.text for one in opened.find_elements("css selector", "#plane-key button")]
    assert {"front of caching", "floor", "1-pass", "2-pass", "3-pass", "peers"} <= set(key)


def test_a_point_shows_its_card_and_a_click_chooses_it(
    opened: Chrome, made_rows: list[Row]
) -> None:
    from selenium.webdriver import ActionChains

    point = opened.find_elements("css selector", "#plane .trace path.point")[-4]
    before = opened.execute_script("return choice.row.key")
    hover(opened, point)
    wait(opened, "!document.getElementById('card').hidden")
    card = found(opened, "#card")
    assert "as fast" in card.text and "RMSE" in card.text
    assert opened.execute_script("return document.querySelector('#card img').naturalWidth") > 0
    ActionChains(opened).click().perform()
    chosen = wait(opened, f"choice.row.key !== '{before}' && choice.row.key")
    row = next(row for row in made_rows if row.key == chosen)
    assert row.result is not None
    assert f"{row.result.times.ratio.median:.2f}×" in text(opened, "#details .big")
    payload = row.payload
    assert (payload.text if payload else row.label) in card.text


def test_where_a_frame_goes_is_drawn_part_by_part(opened: Chrome, made_rows: list[Row]) -> None:
    profiled = "choice.group.rows.findIndex((row) => row.profile && row.profile.length)"
    opened.execute_script(f"choice.chooseRow({profiled})")
    row = next(row for row in made_rows if row.result and row.result.times.profile)
    assert row.result is not None
    widths = opened.execute_script(
        "return [...document.querySelectorAll('#details .parts i')].map((one) => one.offsetWidth)"
    )
    parts = row.result.times.profile
    assert len(widths) == len(parts) and widths[-1] == 0, "less than nothing has no bar"
    longest = max(range(len(parts)), key=lambda at: parts[at].share.median)
    assert widths[longest] == max(widths) > 0
    assert all(part.name in text(opened, "#details .parts") for part in parts)


def test_the_slider_moves_by_keys_and_by_pointer(opened: Chrome) -> None:
    from selenium.webdriver import ActionChains, Keys

    slider = found(opened, "#slider")
    opened.execute_script("arguments[0].scrollIntoView({block: 'center'})", slider)

    def place() -> float:
        clip = found(opened, "#over").value_of_css_property("clip-path")
        return float(clip.rpartition(" ")[2].rstrip("%)"))

    assert place() == 50
    slider.send_keys(Keys.ARROW_RIGHT * 4)
    assert place() == 52
    slider.send_keys(Keys.HOME)
    assert place() == 0
    assert slider.get_attribute("aria-valuetext") == "0 % original"
    width = slider.size["width"]
    ActionChains(opened).move_to_element_with_offset(
        slider, -width // 2 + 8, 0
    ).click_and_hold().move_by_offset(round(0.75 * width), 0).release().perform()
    assert 70 < place() < 80


def test_layers_switch(opened: Chrome) -> None:
    from selenium.webdriver import Keys

    sources = []
    for _ in range(3):
        chosen = found(opened, "#layers input:checked")
        sources.append(found(opened, "#over").get_attribute("src"))
        assert text(opened, "#over-tag") in ("cached", "difference × 10", "hit map")
        chosen.send_keys(Keys.ARROW_RIGHT)
    assert len(set(sources)) == 3
    found(opened, "#layers input[value=hits]").click()
    assert "hit: reused 72.0 %" in text(opened, "#legend")
    assert found(opened, "#over").get_attribute("class") == "exact"
    opened.execute_script(
        "choice.chooseRow(choice.group.rows.findIndex((row) => row.layers && row.layers.age))"
    )
    assert text(opened, "#over-tag") == "hit map"  # it stays with the next row
    found(opened, "#layers input[value=age]").click()
    assert "frames ago" in text(opened, "#legend")


def test_the_cached_expression_is_marked(opened: Chrome) -> None:
    from selenium.webdriver.support.ui import Select

    labels = Select(found(opened, "#pick-label"))
    for number in range(3):
        labels.select_by_index(number)
        node = opened.execute_script("return choice.group.nodes[choice.row.node]")
        wait(opened, "waiting.size === 0")
        marked = "".join(
            one.get_attribute("textContent") or ""
            for one in opened.find_elements("css selector", "#source mark")
        )
        assert "".join(marked.split()) == "".join(node["text"].split())
    opened.execute_script(
        "choice.chooseRow(choice.group.rows.findIndex((row) => row.algorithm === '2-pass'))"
    )
    wait(opened, "waiting.size === 0")
    tabs = opened.find_elements("css selector", "#emitted-tabs button")
    names = [tab.get_attribute("textContent") for tab in tabs]
    assert {"2-pass.hit.frag", "2-pass.miss.frag", "source.vert"} <= set(names)
    assert text(opened, "#emitted .a").startswith("sc_")
    tabs[-1].click()
    assert tabs[-1].get_attribute("aria-selected") == "true"
    assert "a_position" in text(opened, "#emitted")


def test_the_theme_can_be_chosen(opened: Chrome) -> None:
    button, themes = found(opened, "#theme"), []
    for _ in range(3):
        button.click()
        shade = opened.execute_script("return document.documentElement.dataset.theme")
        themes.append((button.text, shade))
    assert themes == [
        ("Theme: dark", "dark"),
        ("Theme: light", "light"),
        ("Theme: auto", "light"),
    ]


def test_the_measure_of_the_error_can_be_chosen(opened: Chrome) -> None:
    found(opened, "#metric input[value=flip]").click()
    title = "document.getElementById('plane')._fullLayout.yaxis.title.text.startsWith('FLIP')"
    assert wait(opened, title)


def test_the_table_sorts(opened: Chrome, made_rows: list[Row]) -> None:
    found(opened, "#numbers summary").click()
    wait(opened, "document.querySelectorAll('#table tbody tr').length")
    assert count(opened, "#table tbody tr") == len(made_rows)
    head = found(opened, "#table th:nth-child(8) button")
    assert head.text == "RMSE"
    for order in ("descending", "ascending"):
        found(opened, "#table th:nth-child(8) button").click()
        assert found(opened, "#table th:nth-child(8)").get_attribute("aria-sort") == order
    cells = opened.find_elements("css selector", "#table tbody td:nth-child(8)")
    values = [float(cell.text) for cell in cells if cell.text]
    assert values == sorted(values)


def test_machines_are_never_in_one_picture(
    browser: Chrome, quiet: None, sourced: Sourced, made_rows: list[Row], tmp_path: Path
) -> None:
    from selenium.webdriver.support.ui import Select

    other = structs.replace(made_rows[0].machine, renderer="another", cores=64)
    moved = [structs.replace(row, machine=other) for row in made_rows[-6:]]
    open_rows(browser, sourced, [*made_rows[:-6], *moved], tmp_path)
    select = Select(found(browser, "#group"))
    assert [one.text.rpartition(", ")[2] for one in select.options] == ["2 cores", "64 cores"]
    first = count(browser, "#plane .trace path.point")
    select.select_by_index(1)
    wait(browser, "waiting.size === 0")
    assert count(browser, "#plane .trace path.point") < first
    assert "another" in text(browser, "#subtitle")
    assert browser.execute_script("return choice.group.rows.length") == 6


def test_a_sweep_in_which_everything_failed_says_so(
    browser: Chrome, quiet: None, sourced: Sourced, made_rows: list[Row], tmp_path: Path
) -> None:
    rows = [row for row in made_rows if row.failure]
    open_rows(browser, sourced, rows, tmp_path)
    assert "No configuration of this sweep has a result" in text(browser, "#summary")
    assert text(browser, "#plane") == "No configuration has a result."
    assert "SC606" in text(browser, "#details")
    assert "There is no picture" in text(browser, "#absent")


@pytest.mark.parametrize(
    ("kept", "words"),
    [({}, "The store holds no pictures"), ({"original": "gone"}, "The store holds no pictures")],
)
def test_pictures_that_are_missing_are_told(
    browser: Chrome,
    quiet: None,
    sourced: Sourced,
    made_rows: list[Row],
    tmp_path: Path,
    kept: dict[str, str],
    words: str,
) -> None:
    row = structs.replace(made_rows[-3], pictures=kept)
    open_rows(browser, sourced, [row], tmp_path)
    assert words in text(browser, "#absent")
    assert not found(browser, "#stage").is_displayed()
    assert text(browser, "#periods").startswith("This value was measured with one period only.")
