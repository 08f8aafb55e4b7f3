"""The browser that the tests of pages drive: Debian's Chromium, without a network."""

import os
import sys
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from playwright.sync_api import TimeoutError, sync_playwright

BROWSER = "/usr/bin/chromium"
# WebGL by the processor: machines that run tests have no graphics.
OPTIONS = [
    "--no-sandbox",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--webgl-antialiasing-mode=none",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]


SUPERSCRIPTS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


def read_number(text):
    """The number that the page writes as 0.7, 3.2·10⁻⁵, 10⁴ or ∞."""
    text = text.strip().replace("−", "-")
    if text == "∞":
        return np.inf
    mantissa, _, power = text.rpartition("10")
    if power and all(c in "⁻⁰¹²³⁴⁵⁶⁷⁸⁹" for c in power):
        return float((mantissa.rstrip("·") or "1") + "e" + power.translate(SUPERSCRIPTS))
    return float(text)


class Watched:
    """A page, with what it complained of and what it asked for."""

    def __init__(self, page):
        self.page, self.complaints, self.requests = page, [], []
        # A busy machine without graphics takes its time.
        page.set_default_timeout(180_000)
        page.on("console", lambda message: self.complaints.append(message.text) if message.type == "error" else None)
        page.on("pageerror", lambda error: self.complaints.append(str(error)))
        page.on("request", lambda request: self.requests.append(request.url))

    def open(self, path):
        """Loads a file and waits until all pictures are drawn."""
        self.go(Path(path).resolve().as_uri())

    def go(self, address):
        """Loads an address and waits until all pictures are drawn."""
        self.page.goto(address)
        self.drawn()

    def drawn(self):
        """Waits until all pictures are drawn."""
        try:
            self.page.wait_for_function("document.body.dataset.drawn === 'all'")
        except TimeoutError:
            sys.exit(f"the page is not drawn: {self.complaints}")

    def screenshot(self, name):
        """Into the directory that STRIBECK_SCREENSHOTS names, if it does."""
        if directory := os.environ.get("STRIBECK_SCREENSHOTS"):
            self.page.screenshot(path=Path(directory) / f"{name}.png")

    def expect_peace(self):
        """No error, and nothing fetched."""
        assert self.complaints == [], self.complaints
        fetched = [url for url in self.requests if not url.startswith(("file://", "blob:", "data:"))]
        assert fetched == [], fetched


@contextmanager
def launched():
    """Chromium, for any number of pages."""
    if not Path(BROWSER).exists():
        sys.exit(f"{BROWSER} is not there; run ./scripts/prerequisites --tests, which names the package")
    with sync_playwright() as driver:
        chromium = driver.chromium.launch(executable_path=BROWSER, args=OPTIONS)
        yield chromium
        chromium.close()


@contextmanager
def window(chromium, width=1280, height=900, theme="light"):
    """A page with a window, storage and downloads of its own."""
    size = {"width": width, "height": height}
    context = chromium.new_context(viewport=size, color_scheme=theme, accept_downloads=True)
    yield Watched(context.new_page())
    context.close()
