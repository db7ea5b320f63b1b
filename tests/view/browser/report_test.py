#!/usr/bin/env python3
"""Opens pages of --report-html in a real browser, from files, and uses them.

usage: report_test.py BIN_FOLDER CHROMIUM CHROMEDRIVER SCREENSHOTS_FOLDER SCAN SCAN
"""

import json
import os
import shutil
import sys
import tempfile

from selenium.webdriver.common.keys import Keys

from page import Page, expect, open_browser, quadrille

HOSTILE_NAME = "<img src=x onerror=alert(1)>.pcd"
MAX_BYTES = 5_000_000


def check_scene(page, plan):
    curved = [d["id"] for d in plan["detections"] if d["type"] != "plane"]
    expected = sorted(curved + [box["id"] for box in plan["boxes"]])
    listed = sorted(int(item.get_attribute("data-object")) for item in page.all("#list .item"))
    expect(listed, expected, "objects listed")


def check_plan(page, folder, bin_folder, scans):
    report = os.path.join(folder, "plan.html")
    lines = quadrille(bin_folder, "plan", *scans, "--gripper", "wsg50", "--report-html", report, "--json", "-")
    plans = [json.loads(line) for line in lines.splitlines()]
    assert os.path.getsize(report) < MAX_BYTES, os.path.getsize(report)
    page.open("file://" + report)
    page.wait_for_frame(0)
    check_scene(page, plans[0])
    page.photograph("report")
    page.press(Keys.ARROW_RIGHT)
    page.wait_for_frame(1)
    check_scene(page, plans[1])
    best = plans[1]["grasps"][0]
    page.all(f'#list [data-object="{best["target"]}"]')[0].click()
    expect(page.all("tr.grasp td:nth-child(2)")[0].text, f"{best['score']:.2f}", "score of the best grasp")
    page.photograph("report_chosen")
    titles = [title.text for title in page.all("#tables h2")]
    expect([title.lower() for title in titles], ["objects", "best grasps", "made by"], "tables")
    objects = sum(len(plan["detections"]) + len(plan["boxes"]) for plan in plans)
    rows = page.browser.execute_script("return document.querySelector('#tables table').rows.length")
    expect(rows, objects + 1, "rows of the table of objects, and its head")
    page.browser.execute_script("document.querySelector('#tables').scrollIntoView()")
    page.photograph("report_tables")
    page.check_console()


def check_hostile(page, folder, bin_folder, scan):
    """A file that is named by somebody who means harm."""
    hostile = os.path.join(folder, HOSTILE_NAME)
    shutil.copy(scan, hostile)
    report = os.path.join(folder, "detect.html")
    quadrille(bin_folder, "detect", hostile, "--report-html", report)
    page.open("file://" + report)
    page.wait_for_frame(0)
    assert HOSTILE_NAME in page.all("#source")[0].text, "the name is shown as text"
    assert HOSTILE_NAME in page.all("#tables")[0].text, "the name is shown in tables"
    expect(page.all("#panel img, #tables img, #stage img"), [], "no markup is made of a name")
    page.check_console()


def check_try(page, folder, bin_folder):
    scene, report = os.path.join(folder, "scene.ply"), os.path.join(folder, "try.html")
    quadrille(bin_folder, "scene", scene, "--family", "medium", "--seed", "1")
    tried = json.loads(quadrille(bin_folder, "try", scene, "--gripper", "wsg50", "--first", "--report-html", report,
                                 "--json", "-"))
    page.open("file://" + report)
    page.wait_for_frame(0)
    first = tried["grasps"][0]
    page.all(f'#list [data-object="{first["target"]}"]')[0].click()
    expect(page.all("tr.grasp td:nth-child(6)")[0].text, first["outcome"], "what came of the first grasp")
    sums = page.browser.execute_script("return document.querySelector('#tables table').rows[1].cells[1].textContent")
    expect(sums, f"{tried['summary']['all']['held']} of {tried['summary']['all']['tried']}", "how many were held")
    page.check_console()


def check_study(page, folder, bin_folder):
    table, report = os.path.join(folder, "study.csv"), os.path.join(folder, "study.html")
    quadrille(bin_folder, "study", "grasps", "--scenes", "2", "--seed", "5", "--gripper", "wsg50", "--try", "none",
              "--csv", table, "--report-html", report)
    page.open("file://" + report)
    page.wait_for_frame(0)
    page.press(Keys.ARROW_RIGHT)
    page.wait_for_frame(1)
    with open(table, encoding="utf-8") as file:
        grasps = len(file.readlines()) - 1
    title = page.browser.execute_script("return document.querySelector('#tables h2').textContent")
    assert f"2 scenes, {grasps} grasps" in title, title
    page.browser.execute_script("document.querySelector('#tables').scrollIntoView()")
    page.photograph("report_study")
    page.check_console()


def check_blind(page, folder, bin_folder, scan):
    """A browser without WebGL: the numbers are there, and the page says why there is no picture."""
    page.browser.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": """
        const get = HTMLCanvasElement.prototype.getContext;
        HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
          return kind.includes("webgl") ? null : get.call(this, kind, ...rest);
        };"""})
    report = os.path.join(folder, "blind.html")
    plan = json.loads(quadrille(bin_folder, "plan", scan, "--gripper", "wsg50", "--report-html", report, "--json", "-"))
    page.open("file://" + report)
    page.wait_for_frame(0)
    check_scene(page, plan)
    assert page.all("#blind")[0].is_displayed(), "the page says that it draws nothing"
    expect(page.all("#notice")[0].text, "", "nothing else is wrong")
    page.all("#list .item")[0].click()
    assert page.all("tr.grasp"), "grasps of what was chosen are listed"
    page.photograph("report_blind")


def main():
    bin_folder, chromium, driver, screenshots, *scans = sys.argv[1:]
    os.makedirs(screenshots, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        os.environ["HOME"] = folder
        browser = open_browser(chromium, driver)
        try:
            page = Page(browser, screenshots)
            check_plan(page, folder, bin_folder, scans)
            check_hostile(page, folder, bin_folder, scans[0])
            check_try(page, folder, bin_folder)
            check_study(page, folder, bin_folder)
            check_blind(page, folder, bin_folder, scans[1])
        finally:
            browser.quit()
    print(f"report_test: all is well; pictures in {screenshots}")


if __name__ == "__main__":
    main()
