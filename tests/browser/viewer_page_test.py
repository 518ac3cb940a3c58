# SPDX-License-Identifier: Apache-2.0
"""viewer_page_test.py BROWSER FOLDER: uses the pages of make_pages as people would, with mouse,
fingers and keys, and looks at what they then show. Pictures of them are left in FOLDER."""

import os
import sys
import time

from browser import Browser
from list_checks import (links_back_and_neighbours_work, list_puts_failures_first_and_filters,
                         sizes_may_differ)
from page import Page

BLUE_ACTUAL, BLUE_EXPECTED = 137, 188  # sRGB codes of 0.25 and 0.5
WORST = (70, 50)
READOUT = ("[...document.querySelectorAll('#readout tbody tr')]"
           ".map(row => [...row.cells].map(cell => cell.textContent))")


def side_by_side_shows_both(page):
    page.open_viewer("one.html")
    page.expect("viewer.mode", "side")
    page.expect("viewer.view.panes.length", 2)
    page.expect_color(page.place_of_pixel(40, 30, 0), [None, None, BLUE_ACTUAL])
    page.expect_color(page.place_of_pixel(40, 30, 1), [None, None, BLUE_EXPECTED])
    page.expect_text("#case-verdict", "failed")
    page.expect_text("#facts tr.failed th", "rmse")
    page.expect_no_overflow()
    page.screenshot("side.png")


def slider_follows_mouse_and_keys(page):
    page.open_viewer("one.html")
    page.click("button[data-mode=slider]")
    page.expect("viewer.mode", "slider")
    left, right = page.place_of_pixel(20, 60), page.place_of_pixel(75, 60)
    page.expect_color(left, [None, None, BLUE_ACTUAL])
    page.expect_color(right, [None, None, BLUE_EXPECTED])
    handle = page.middle_of("#split")
    beyond_right = [right[0] + 20, handle[1]]
    page.browser.drag(handle, beyond_right)
    page.expect_color(right, [None, None, BLUE_ACTUAL])
    page.expect_near("viewer.split * document.querySelector('#stage').clientWidth", beyond_right[0], 1)
    before = page.get("viewer.split")
    page.key("ArrowLeft")
    page.expect_near("viewer.split", before - 0.02, 1e-9)
    page.expect_near("Number(document.querySelector('#split').getAttribute('aria-valuenow'))",
                     100 * (before - 0.02), 0.5)
    page.browser.drag(page.middle_of("#split"), [5, handle[1]])
    page.expect_color(left, [None, None, BLUE_EXPECTED])
    page.screenshot("slider.png")


def blink_swaps_stops_and_changes_period(page):
    page.open_viewer("one.html")
    page.key("b")
    page.expect("viewer.mode", "blink")
    middle = page.place_of_pixel(40, 30)
    seen = set()
    deadline = time.monotonic() + 3
    while len(seen) < 2 and time.monotonic() < deadline:
        seen.add(page.color(middle)[2])
    if seen != {BLUE_ACTUAL, BLUE_EXPECTED}:
        raise AssertionError(f"blinking shows blue of {seen}")
    page.get("document.querySelector('#period').focus()")
    page.key("ArrowLeft")
    page.expect("viewer.period", 400)
    page.expect_text("#period-value", "400 ms")
    page.get("document.querySelector('#canvas').focus()")
    page.key(" ")
    shown = page.get("viewer.showsExpected")
    time.sleep(0.5)
    page.expect("viewer.showsExpected", shown)
    page.key("b")
    page.expect("viewer.showsExpected", not shown)
    page.expect_color(middle, [None, None, BLUE_ACTUAL if shown else BLUE_EXPECTED])


def difference_is_scaled_and_signed(page):
    page.open_viewer("one.html")
    page.key("d")
    middle = page.place_of_pixel(40, 30)
    page.expect_color(middle, [0, 0, 255])
    page.get("document.querySelector('#scale').focus()")
    page.key("ArrowUp")
    page.expect("viewer.scale", 2)
    page.expect_color(middle, [0, 0, BLUE_EXPECTED])
    page.click("#signed")
    page.expect("viewer.signed", True)
    page.settle()
    red, _, blue = page.color(middle)
    if not blue > red > 0:
        raise AssertionError(f"less than expected is shown with red {red} and blue {blue}")
    red, _, blue = page.color(page.place_of_pixel(*WORST))
    if not red > blue:
        raise AssertionError(f"more than expected is shown with red {red} and blue {blue}")
    page.screenshot("difference.png")


def zoom_stays_at_the_pointer(page):
    page.open_viewer("one.html")
    page.key("a")
    fitted = page.get("viewer.view.zoom")
    place = page.place_of_pixel(20, 15)
    page.browser.wheel(*place, -400)
    page.wait(f"viewer.view.zoom > 1.5 * {fitted}")
    page.settle()
    after = page.place_of_pixel(20, 15)
    if max(abs(a - b) for a, b in zip(place, after)) > 2:
        raise AssertionError(f"the pixel at {place} went to {after}")
    page.expect_text("#readout-where", "x 20, y 15; FLIP 0.251")
    for key, zoom in (("1", 1), ("+", 2), ("+", 4), ("-", 2), ("f", fitted)):
        page.key(key)
        page.expect("viewer.view.zoom", zoom)
    for _ in range(4):
        page.key("+")
    middle = page.place_of_pixel(48, 36)
    zoom = page.get("viewer.view.zoom")
    for part in (-0.45, 0.45):  # a pixel is a square of one colour
        corner = [coordinate + part * zoom for coordinate in middle]
        page.expect_color(corner, [165, 145, BLUE_ACTUAL])
    page.screenshot("zoom.png")


def drag_and_fingers_move_the_picture(page):
    page.open_viewer("one.html")
    page.key("a")
    start = page.place_of_pixel(48, 36)
    page.browser.drag(start, [start[0] + 60, start[1] + 40])
    page.settle()
    moved = page.place_of_pixel(48, 36)
    if max(abs(moved[0] - start[0] - 60), abs(moved[1] - start[1] - 40)) > 1.5:
        raise AssertionError(f"dragged by (60, 40), went from {start} to {moved}")
    zoom = page.get("viewer.view.zoom")
    x, y = start
    page.browser.touch("touchStart", (x - 50, y), (x + 50, y))
    for half in (60, 80, 100):
        page.browser.touch("touchMove", (x - half, y), (x + half, y))
    page.browser.touch("touchEnd")
    page.settle()
    page.expect_near("viewer.view.zoom", 2 * zoom, 0.1 * zoom)


def exposure_brightens(page):
    page.open_viewer("one.html")
    page.key("a")
    middle = page.place_of_pixel(40, 30)
    page.expect_color(middle, [None, None, BLUE_ACTUAL])
    page.key("]", "]")
    page.expect("viewer.exposure", 1)
    page.expect_color(middle, [None, None, BLUE_EXPECTED])
    page.get("document.querySelector('#exposure').focus()")
    page.key("ArrowRight", "ArrowRight")
    page.expect_text("#exposure-value", "+2 EV")
    page.expect_color(middle, [None, None, 255])
    page.click("#exposure-reset")
    page.expect_color(middle, [None, None, BLUE_ACTUAL])


def readout_tells_linear_values(page):
    page.open_viewer("one.html")
    page.browser.move(*page.place_of_pixel(12, 20))
    page.settle()
    page.expect_text("#readout-where", "x 12, y 20; FLIP 0.251")
    page.expect(READOUT, [["actual", "0.093750", "0.15625", "0.25000"],
                       ["expected", "0.093750", "0.15625", "0.50000"],
                       ["difference", "+0.000", "+0.000", "-0.2500"]])
    page.browser.key("ArrowRight", shift=True)
    page.settle()
    page.expect("viewer.pixel", {"x": 13, "y": 20})
    page.click("#worst")
    page.expect("viewer.pixel", {"x": WORST[0], "y": WORST[1]})
    page.expect("viewer.view.zoom >= 16", True)
    page.settle()
    page.expect("document.querySelector('#readout-difference').cells[3].textContent", "+7.500")


def flip_is_a_heat_map(page):
    page.open_viewer("one.html")
    page.key("h")
    page.expect("viewer.mode", "flip")
    page.expect_color(page.place_of_pixel(*WORST), [252, 253, 191])
    page.expect_color(page.place_of_pixel(40, 30), [80, 18, 123])
    page.screenshot("flip.png")


def display_images_are_told_in_codes(page):
    page.open_viewer("display.html")
    page.expect("document.querySelector('#exposure-options').hidden", True)
    page.browser.move(*page.place_of_pixel(30, 40))
    page.settle()
    page.expect(READOUT, [["actual, 8 bits", "60", "120", "128"], ["expected, 8 bits", "60", "120", "132"],
                       ["difference", "+0", "+0", "-4"]])
    page.expect_color(page.place_of_pixel(30, 40, 1), [60, 120, 132])
    page.key("d")
    page.expect_color(page.place_of_pixel(40, 30), [0, 0, 16])


def looks_right_elsewhere(page):
    for name, size in (("phone", {"width": 400, "height": 800, "phone": True}),
                       ("dark", {"width": 1200, "height": 800, "dark": True})):
        page.open_viewer("one.html", **size)
        page.expect_no_overflow()
        page.screenshot(f"one-{name}.png")
        page.get("document.querySelector('details').open = true")
        page.get("document.querySelector('details').scrollIntoView({block: 'end'})")
        page.expect_no_overflow()
        page.screenshot(f"facts-{name}.png")
        page.open("many.html", **size)
        page.wait("document.querySelectorAll('#cases li:first-child canvas').length === 3")
        page.expect_no_overflow()
        page.screenshot(f"list-{name}.png")


def says_what_an_old_browser_lacks(page):
    script = page.browser.call("Page.addScriptToEvaluateOnNewDocument",
                               source="delete window.DecompressionStream")
    page.open("one.html")
    page.expect("document.querySelector('#problem').hidden", False)
    page.expect("document.querySelector('#problem').textContent.includes('DecompressionStream')", True)
    page.expect_text("#facts td", "0.14434")
    page.browser.call("Page.removeScriptToEvaluateOnNewDocument", identifier=script["identifier"])


CHECKS = (
    side_by_side_shows_both, slider_follows_mouse_and_keys, blink_swaps_stops_and_changes_period,
    difference_is_scaled_and_signed, zoom_stays_at_the_pointer, drag_and_fingers_move_the_picture,
    exposure_brightens, readout_tells_linear_values, flip_is_a_heat_map,
    display_images_are_told_in_codes, list_puts_failures_first_and_filters,
    links_back_and_neighbours_work, sizes_may_differ, looks_right_elsewhere,
    says_what_an_old_browser_lacks,
)


def run_check(check, page):
    """Whether it held; if not, says so and leaves a picture."""
    try:
        check(page)
        if page.browser.complaints:
            raise AssertionError(f"the page complains: {page.browser.complaints}")
        outside = [url for url in page.browser.requests if not url.startswith(("file:", "about:", "blob:"))]
        if outside:
            raise AssertionError(f"the page asks the network for {outside}")
        return True
    except (AssertionError, TimeoutError, RuntimeError) as problem:
        print(f"FAILED {check.__name__}: {problem}")
        page.browser.screenshot(os.path.join(page.folder, f"failed-{check.__name__}.png"))
        return False
    finally:
        page.browser.complaints.clear()


def main():
    program, folder = sys.argv[1:]
    begin = time.monotonic()
    browser = Browser(program)
    try:
        page = Page(browser, folder)
        failures = sum(not run_check(check, page) for check in CHECKS)
    finally:
        browser.close()
    print(f"{len(CHECKS) - failures} of {len(CHECKS)} checks held, {time.monotonic() - begin:.1f} s")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
