#!/usr/bin/env python3
"""Opens the page of quadrille view on a bus with a detector and a planner, and asks for grasps. Needs a network
in which LCM's multicast works, and no other LCM processes: run it with tools/private_network.

usage: live_test.py BIN_FOLDER CHROMIUM CHROMEDRIVER SCREENSHOTS_FOLDER
"""

import contextlib
import os
import signal
import subprocess
import sys
import tempfile
import time

from page import PATIENCE_S, Page, View, expect, open_browser, quadrille

URL = "udpm://239.255.76.67:7667?ttl=0"


@contextlib.contextmanager
def running(*command):
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        yield process
    finally:
        process.send_signal(signal.SIGTERM)
        process.wait(PATIENCE_S)


def play_until_shown(page, log):
    """Plays the log again and again: nobody knows when the processes have begun to listen."""
    end = time.monotonic() + PATIENCE_S
    while time.monotonic() < end:
        subprocess.run(["lcm-logplayer", "--lcm-url=" + URL, log], check=True, stdout=subprocess.DEVNULL)
        time.sleep(1)
        if page.all("#list .item"):
            return
    raise AssertionError("no objects came over the bus")


def click(page, selector):
    """New scenes replace what is in the panel at any time."""
    page.browser.execute_script("document.querySelector(arguments[0]).click()", selector)


def check_request(page):
    """The planner plans on requests alone: before one there is no grasp, after it those of one object."""
    objects = page.each("#list .item", "item.dataset.object")
    expect(len(page.all("#list .side.none")), len(objects), "objects without a grasp before a request")
    for number in objects:
        click(page, f'#list [data-object="{number}"]')
        click(page, "#ask")
        page.wait_for("document.querySelectorAll('#detail .reason, #detail tr.grasp').length > 0", "an answer")
        if page.all("tr.grasp"):
            break
    assert page.all("tr.grasp"), "one of the objects can be grasped"
    chosen, = page.each('#list [aria-pressed="true"] .side', "item.innerText")
    assert "grasp" in chosen and chosen != "no grasp", chosen
    others = page.each('#list [aria-pressed="false"] .side', "item.innerText")
    assert "not planned" in others, f"what was not asked for was not planned: {others}"
    assert "planned on request" in page.each("#asked", "item.innerText")[0], "the page says that this is an answer"
    page.photograph("live_asked")


def main():
    bin_folder, chromium, driver, screenshots = sys.argv[1:]
    os.makedirs(screenshots, exist_ok=True)
    program = lambda name: os.path.join(bin_folder, name)
    with tempfile.TemporaryDirectory() as folder:
        os.environ["HOME"] = folder
        scene, log = os.path.join(folder, "scene.ply"), os.path.join(folder, "scene.lcm")
        quadrille(bin_folder, "scene", scene, "--family", "tabletop", "--seed", "3")
        quadrille(bin_folder, "log", log, scene)
        browser = open_browser(chromium, driver)
        try:
            page = Page(browser, screenshots)
            with running(program("quadrille-detector"), "--lcm-url", URL), \
                    running(program("quadrille-grasp-planner"), "--on-request", "--unknown", "free",
                            "--deadline-ms", "0", "--lcm-url", URL):
                with View(bin_folder, "--lcm-url", URL, "--allow-requests") as view:
                    page.open(view.address)
                    play_until_shown(page, log)
                    page.photograph("live")
                    check_request(page)
                    page.check_console()
                    page.leave()
                with View(bin_folder, "--lcm-url", URL) as view:
                    page.open(view.address)
                    play_until_shown(page, log)
                    click(page, "#list .item")
                    expect(page.all("#ask"), [], "no way to ask without --allow-requests")
                    page.check_console()
                    page.leave()
        finally:
            browser.quit()
    print(f"live_test: all is well; pictures in {screenshots}")


if __name__ == "__main__":
    main()
