#!/usr/bin/env python3
"""Opens the page of quadrille view on a log in a real browser, and uses it.

usage: log_test.py BIN_FOLDER CHROMIUM CHROMEDRIVER SCREENSHOTS_FOLDER
"""

import json
import os
import struct
import sys
import tempfile
import time

from selenium.webdriver.common.keys import Keys

from page import Page, View, expect, open_browser, quadrille

SCENES = 3
HOSTILE_FRAME = '<img src=x onerror="document.title=\'hacked\'">'


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
    chosen = page.browser.execute_script("""
        const canvas = document.querySelector("#canvas"), chosen = new Set();
        for (let row = 2; row < 18; ++row) {
          for (let column = 2; column < 18; ++column) {
            const at = { clientX: canvas.clientWidth * column / 20, clientY: canvas.clientHeight * row / 20 };
            canvas.dispatchEvent(new MouseEvent("click", { ...at, bubbles: true }));
            for (const item of document.querySelectorAll('#list [aria-pressed="true"]')) chosen.add(item.dataset.object);
          }
        }
        return [...chosen].map(Number);""")
    assert chosen, "a click in the scene chooses an object"
    assert set(chosen) <= set(objects_of(plan)), chosen
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


def start_anew(page):
    page.open(page.browser.current_url.split("#")[0])
    page.wait_for_frame(0)


def check_link(page, plan):
    """A copied link shows the same cloud, object and colours from the same side."""
    start_anew(page)
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


def choose(page, menu, value):
    page.browser.execute_script(
        "const [menu, value] = arguments; menu.value = value; menu.dispatchEvent(new Event('change'));",
        page.all("#choice-" + menu)[0], value)


def check_choices(page, bin_folder, log):
    """Another gripper and another policy give the plan that `quadrille plan` makes with them."""
    start_anew(page)
    choose(page, "gripper", "wsg50")
    choose(page, "unknown", "free")
    plan = json.loads(quadrille(bin_folder, "plan", log + "#1", "--gripper", "wsg50", "--unknown", "free",
                                "--json", "-"))
    best = plan["grasps"][0]["target"]
    grasps = sum(1 for grasp in plan["grasps"] if grasp["target"] == best)
    item = f'#list [data-object="{best}"] .side'
    shown = "1 grasp" if grasps == 1 else f"{grasps} grasps"
    page.wait_for(f"document.querySelector('{item}')?.textContent === '{shown}'", "the other hand's grasps")
    page.wait_for("location.hash.includes('gripper=wsg50') && location.hash.includes('unknown=free')",
                  "the link holds what was chosen")
    page.photograph("other_gripper")
    choose(page, "clearance", "30")
    roomy = json.loads(quadrille(bin_folder, "plan", log + "#1", "--gripper", "wsg50", "--unknown", "free",
                                 "--min-clearance", "0.03", "--json", "-"))
    without = len(objects_of(roomy)) - len({grasp["target"] for grasp in roomy["grasps"]})
    page.wait_for(f"document.querySelectorAll('#list .side.none').length === {without}", "few grasps have so much room")


def check_poor_link(page):
    """A link that asks for what does not exist shows the scene all the same."""
    page.open(page.browser.current_url.split("#")[0] + "#gripper=claw&unknown=maybe&clearance=x&frame=99&object=77")
    page.wait_for_frame(SCENES - 1)
    expect(page.all("#choice-gripper")[0].get_attribute("value"), "franka", "the gripper of the command line")


def check_cut_log(page, bin_folder, log, folder):
    cut = os.path.join(folder, "cut.lcm")
    with open(log, "rb") as whole, open(cut, "wb") as file:
        file.write(whole.read()[:-100])
    with View(bin_folder, "--in-log", cut) as view:
        page.open(view.address)
        page.wait_for_frame(0)
        assert "cut short" in page.all("#source .warning")[0].text, "the page tells of the cut"
        page.check_console()


def check_hostile_name(page, bin_folder, log, folder):
    hostile = os.path.join(folder, "hostile.lcm")
    write_hostile_cloud(log, hostile)
    with View(bin_folder, "--in-log", hostile) as view:
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
            with View(bin_folder, "--in-log", log) as view:
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
                check_choices(page, bin_folder, log)
                check_poor_link(page)
                page.check_console()
            check_cut_log(page, bin_folder, log, folder)
            check_hostile_name(page, bin_folder, log, folder)
        finally:
            browser.quit()
    print(f"log_test: all is well; pictures in {screenshots}")


if __name__ == "__main__":
    main()
