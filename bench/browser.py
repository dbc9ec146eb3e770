"""Headless Chromium, as Debian's packages ``chromium`` and ``chromium-driver`` bring it."""

from __future__ import annotations

import shutil
from base64 import b64decode
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

if TYPE_CHECKING:
    from selenium.webdriver import Chrome

BROWSER, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")

MISSING = None if BROWSER and DRIVER else "chromium and chromium-driver are not installed"
"""What keeps a browser from being opened, if anything."""

# In a container Chromium finds neither a sandbox nor much shared memory.
_FLAGS = "--headless=new", "--no-sandbox", "--hide-scrollbars", "--disable-dev-shm-usage"

DRAWN = "return Number(document.documentElement.dataset.drawn || 0)"
"""When all plots of a page have been drawn, in ms since the navigation began; 0 before that."""


@contextmanager
def open_browser() -> Iterator[Chrome]:
    """A browser without a network. Nothing may be called where :data:`MISSING` is not None."""
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    assert BROWSER is not None and DRIVER is not None
    options = webdriver.ChromeOptions()
    options.binary_location = BROWSER
    for flag in _FLAGS:
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    browser = webdriver.Chrome(options=options, service=Service(DRIVER))
    try:
        browser.execute_cdp_cmd("Network.enable", {})
        offline = {"offline": True, "latency": 0, "downloadThroughput": 0, "uploadThroughput": 0}
        browser.execute_cdp_cmd("Network.emulateNetworkConditions", offline)
        yield browser
    finally:
        browser.quit()


def set_window(browser: Chrome, width: int, theme: Literal["light", "dark"] = "light") -> None:
    """Make the window so wide (CSS pixels; a phone's below 600) and the system light or dark."""
    features = [{"name": "prefers-color-scheme", "value": theme}]
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
    metrics = {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": width < 600}
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", metrics)


def open_page(browser: Chrome, page: Path) -> float:
    """Open a report from its file and wait until it is drawn; returns what :data:`DRAWN` says."""
    from selenium.webdriver.support.ui import WebDriverWait

    browser.get(page.resolve().as_uri())
    drawn: Any = WebDriverWait(browser, 60).until(lambda one: one.execute_script(DRAWN))
    return float(drawn)


def picture_of(browser: Chrome, path: Path, width: int, height: int | None = None) -> None:
    """Write the page as a PNG file, from its top down to ``height``, or to its end."""
    end = browser.execute_script("return document.documentElement.scrollHeight")
    clip = {"x": 0, "y": 0, "width": width, "height": height or end, "scale": 1}
    asked = {"captureBeyondViewport": True, "clip": clip}
    path.write_bytes(b64decode(browser.execute_cdp_cmd("Page.captureScreenshot", asked)["data"]))
