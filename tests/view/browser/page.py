"""What the tests of quadrille's pages share: the command, quadrille view, and a real browser without a screen."""

import os
import subprocess
import sys
import time

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from running_view import PATIENCE_S, View  # noqa: E402, F401

def quadrille(bin_folder, *arguments):
    return subprocess.run([os.path.join(bin_folder, "quadrille"), *arguments], check=True,
                          capture_output=True, text=True).stdout


def open_browser(chromium, driver):
    options = webdriver.ChromeOptions()
    options.binary_location = chromium
    for argument in ("--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
                     "--enable-unsafe-swiftshader", "--window-size=1500,940", "--hide-scrollbars"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    return webdriver.Chrome(service=Service(driver), options=options)


class Page:
    def __init__(self, browser, screenshots):
        self.browser, self.screenshots = browser, screenshots

    def leave(self):
        self.browser.get("about:blank")

    def open(self, address):
        self.leave()
        self.browser.get(address)

    def wait_for(self, script, what):
        end = time.monotonic() + PATIENCE_S
        while time.monotonic() < end:
            value = self.browser.execute_script("return " + script)
            if value:
                return value
            time.sleep(0.05)
        raise AssertionError("did not happen: " + what)

    def wait_for_frame(self, frame):
        self.wait_for(f"document.body.dataset.frame === '{frame}'", f"cloud {frame} is shown")

    def all(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def each(self, selector, expression):
        """What a script's expression makes of each `item`. All are read at once, since a new scene may replace them."""
        return self.browser.execute_script(
            f"return Array.from(document.querySelectorAll(arguments[0]), (item) => {expression});", selector)

    def press(self, key):
        self.browser.find_element(By.TAG_NAME, "body").send_keys(key)

    def photograph(self, name):
        # Two pictures are drawn after a change: one of the scene, one with the labels in place.
        self.browser.execute_async_script(
            "const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(done));")
        self.browser.save_screenshot(os.path.join(self.screenshots, name + ".png"))

    def check_console(self):
        bad = [entry for entry in self.browser.get_log("browser")
               if entry["level"] == "SEVERE" or "console-api" in entry["source"]]
        assert not bad, bad


def expect(actual, expected, what):
    assert actual == expected, f"{what}: {actual!r} instead of {expected!r}"
