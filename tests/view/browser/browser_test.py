#!/usr/bin/env python3
"""Opens the page of quadrille view in a real browser, without a screen, and uses it.

usage: browser_test.py BIN_FOLDER CHROMIUM CHROMEDRIVER SCREENSHOTS_FOLDER
"""

import json
import os
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

# A loaded machine without a graphics card may take long; nothing else depends on time.
PATIENCE_S = 120
SCENES = 3
HOSTILE_FRAME = '<img src=x onerror="document.title=\'hacked\'">'


def quadrille(bin_folder, *arguments):
    return subprocess.run([os.path.join(bin_folder, "quadrille"), *arguments], check=True,
                          capture_output=True, text=True).stdout


def write_hostile_cloud(scene, path):
    """A cloud whose frame is named by somebody who means harm: an LCM log of a Drake message."""
    def text(value):
        raw = value.encode() + b"\0"
        return struct.pack(">i", len(raw)) + raw

    with open(scene, "rb") as file:
        event = file.read()
    head = struct.calcsize(">IqqII")
    magic, number, utime, channel_size, data_size = struct.unpack_from(">IqqII", event)
    channel = event[head:head + channel_size]
    data = event[head + channel_size:head + channel_size + data_size]
    name_at = 16
    (name_size,) = struct.unpack_from(">i", data, name_at)
    data = data[:name_at] + text(HOSTILE_FRAME) + data[name_at + 4 + name_size:]
    with open(path, "wb") as file:
        file.write(struct.pack(">IqqII", magic, number, utime, channel_size, len(data)) + channel + data)


class View:
    """A running quadrille view."""

    def __init__(self, bin_folder, log):
        self.process = subprocess.Popen(
            [os.path.join(bin_folder, "quadrille"), "view", "--in-log", log, "--port", "0"],
            stdout=subprocess.PIPE, text=True)
        self.address = re.search(r"http://\S+", self.process.stdout.readline()).group(0)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.send_signal(signal.SIGTERM)
        assert self.process.wait(PATIENCE_S) == 0, "view ends with 0 after SIGTERM"


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

    def open(self, address):
        self.browser.get("about:blank")
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


def objects_of(plan):
    """The ids that the page lists, from what `quadrille plan` finds in the same cloud."""
    curved = [d["id"] for d in plan["detections"] if d["type"] != "plane"]
    return sorted(curved + [box["id"] for box in plan["boxes"]])


def listed(page):
    return sorted(int(item.get_attribute("data-object")) for item in page.all("#list .item"))


def check_objects(page, plan):
    expect(listed(page), objects_of(plan), "objects listed")
    planes = [d["id"] for d in plan["detections"] if d["type"] == "plane"]
    expect(len(page.all("#planes .item")), len(planes), "planes listed")
    labels = [label for label in page.all(".label") if label.is_displayed()]
    expect(len(labels), len(objects_of(plan)), "labels shown")


def check_labels_apart(page):
    """No label lies over another."""
    spots = [label.rect for label in page.all(".label") if label.is_displayed()]
    for i, a in enumerate(spots):
        for b in spots[i + 1:]:
            over = (a["x"] < b["x"] + b["width"] and b["x"] < a["x"] + a["width"] and
                    a["y"] < b["y"] + b["height"] and b["y"] < a["y"] + a["height"])
            assert not over, f"labels over each other: {a} {b}"


def check_choice(page, plan):
    """A click on an object in the list, and one on it in the scene, show its grasps."""
    best = plan["grasps"][0]["target"]
    grasps = [g for g in plan["grasps"] if g["target"] == best]
    page.all(f'#list [data-object="{best}"]')[0].click()
    expect(len(page.all("tr.grasp")), min(len(grasps), 20), "grasps listed")
    score = page.all("tr.grasp td:nth-child(2)")[0].text
    expect(score, f"{grasps[0]['score']:.2f}", "score of the best grasp")
    assert page.all(".reason p"), "refusals come with what helps"
    page.photograph("chosen")
    page.press(Keys.ESCAPE)
    expect(page.all('#list [aria-pressed="true"]'), [], "nothing is chosen after Escape")


def check_click_in_scene(page, plan):
    """Clicks over the stage until each object that can be seen was chosen, as a hand would."""
    canvas = page.all("#canvas")[0]
    width, height = canvas.size["width"], canvas.size["height"]
    chosen = set()
    for row in range(2, 18):
        for column in range(2, 18):
            page.browser.execute_script(
                "const [canvas, x, y] = arguments;"
                "canvas.dispatchEvent(new MouseEvent('click', {clientX: x, clientY: y, bubbles: true}));",
                canvas, width * column / 20, height * row / 20)
            for item in page.all('#list [aria-pressed="true"]'):
                chosen.add(int(item.get_attribute("data-object")))
    assert chosen, "a click in the scene chooses an object"
    assert chosen <= set(objects_of(plan)), chosen
    page.press(Keys.ESCAPE)


def check_timeline(page, plans):
    page.press(Keys.ARROW_RIGHT)
    page.wait_for_frame(1)
    check_objects(page, plans[1])
    page.all("#forward")[0].click()
    page.wait_for_frame(2)
    check_objects(page, plans[2])
    page.photograph("third_cloud")
    expect(len(page.all("#marks rect.known")), SCENES, "marks of clouds that were looked at")
    page.all("#back")[0].click()
    page.wait_for_frame(1)
    page.all("#play")[0].click()
    page.wait_for_frame(0)
    page.all("#play")[0].click()


def check_layers_and_theme(page):
    page.all("#layer-unknown")[0].click()
    expect(page.all("#layer-unknown")[0].get_attribute("aria-pressed"), "true", "layer of unknown space")
    page.photograph("unknown")
    page.all("#layer-unknown")[0].click()
    for colour in ("depth", "normal", "object"):
        page.all(f"#colour-{colour}")[0].click()
        page.photograph("by_" + colour)
    theme = "document.documentElement.dataset.theme"
    before = page.browser.execute_script("return " + theme)
    page.press("t")
    page.wait_for(f"{theme} !== '{before}'", "light becomes dark")
    page.photograph("dark" if before == "light" else "light")


def check_link(page, plan):
    """A copied link shows the same cloud, object and colours from the same side."""
    best = plan["grasps"][0]["target"]
    page.all(f'#list [data-object="{best}"]')[0].click()
    page.press("v")
    page.wait_for(f"location.hash.includes('object={best}') && location.hash.includes('camera=')",
                  "the address holds the view")
    time.sleep(1)  # until the address has been brought up to date: it waits for a pause
    link = page.browser.current_url
    page.open(link)
    page.wait_for("document.querySelector('#list [aria-pressed=\"true\"]') !== null", "the link restores the choice")
    time.sleep(1)
    expect(page.browser.current_url, link, "the view restored from a link")


def check_hostile_name(page, bin_folder, log, folder):
    hostile = os.path.join(folder, "hostile.lcm")
    write_hostile_cloud(log, hostile)
    with View(bin_folder, hostile) as view:
        page.open(view.address)
        page.wait_for_frame(0)
        assert HOSTILE_FRAME in page.all("#source")[0].text, "the name is shown as text"
        expect(page.all("#panel img, #stage img"), [], "no markup is made of a name")
        expect(page.browser.title, "quadrille", "nothing of a name is run")
        page.check_console()


def main():
    bin_folder, chromium, driver, screenshots = sys.argv[1:]
    os.makedirs(screenshots, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        os.environ["HOME"] = folder
        scenes = [os.path.join(folder, f"scene{i}.ply") for i in range(SCENES)]
        for seed, scene in enumerate(scenes, start=2):
            quadrille(bin_folder, "scene", scene, "--family", "medium", "--seed", str(seed))
        log = os.path.join(folder, "scenes.lcm")
        quadrille(bin_folder, "log", log, *scenes)
        lines = quadrille(bin_folder, "plan", log, "--gripper", "franka", "--json", "-").splitlines()
        plans = [json.loads(line) for line in lines]
        browser = open_browser(chromium, driver)
        try:
            page = Page(browser, screenshots)
            with View(bin_folder, log) as view:
                page.open(view.address)
                page.wait_for_frame(0)
                page.photograph("log")
                check_objects(page, plans[0])
                check_labels_apart(page)
                check_choice(page, plans[0])
                check_click_in_scene(page, plans[0])
                check_timeline(page, plans)
                check_layers_and_theme(page)
                check_link(page, plans[0])
                page.check_console()
            check_hostile_name(page, bin_folder, log, folder)
        finally:
            browser.quit()
    print(f"browser_test: all is well; pictures in {screenshots}")


if __name__ == "__main__":
    main()
