# SPDX-License-Identifier: Apache-2.0
"""One of our pages in a browser, and what a test wants of it."""

import os


class Page:
    """A page of the folder, and questions about it."""

    def __init__(self, browser, folder):
        self.browser = browser
        self.folder = folder

    def open(self, name, fragment="", width=1000, height=640, **more):
        self.browser.set_size(width, height, **more)
        self.browser.open(f"file://{os.path.abspath(self.folder)}/{name}{fragment}")

    def open_viewer(self, name, fragment="", **more):
        self.open(name, fragment, **more)
        self.wait("viewer.pictures.actual !== null")
        self.settle()

    def wait(self, expression):
        self.browser.wait_until(expression)

    def get(self, expression):
        return self.browser.evaluate(expression)

    def settle(self):
        """Until what was asked for is drawn."""
        self.get("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def expect(self, expression, expected):
        actual = self.get(expression)
        if actual != expected:
            raise AssertionError(f"{expression} is {actual!r}, expected {expected!r}")

    def expect_near(self, expression, expected, tolerance):
        actual = self.get(expression)
        if not abs(actual - expected) <= tolerance:
            raise AssertionError(f"{expression} is {actual!r}, expected {expected!r} +- {tolerance}")

    def expect_color(self, place, expected):
        """On the canvas, at a place of the window; None in the colour is for any."""
        self.settle()
        actual = self.color(place)
        if any(e is not None and abs(a - e) > 1 for a, e in zip(actual, expected)):
            raise AssertionError(f"colour at {place} is {actual}, expected {expected}")

    def color(self, place):
        return self.get("(() => { const box = viewer.view.canvas.getBoundingClientRect();"
                        f"const x = {place[0]} - box.left, y = {place[1]} - box.top;"
                        "const r = viewer.view.ratio;"
                        "return [...viewer.view.canvas.getContext('2d')"
                        ".getImageData(x * r, y * r, 1, 1).data].slice(0, 3); })()")

    def place_of_pixel(self, x, y, pane=0):
        """Of the middle of a pixel, in the window."""
        return self.get("(() => { const v = viewer.view, box = v.canvas.getBoundingClientRect();"
                        f"const o = v.origin(v.panes[{pane}]);"
                        f"return [box.left + (o.x + ({x} + 0.5) * v.zoom) / v.ratio,"
                        f"box.top + (o.y + ({y} + 0.5) * v.zoom) / v.ratio]; }})()")

    def middle_of(self, selector):
        return self.get(f"(() => {{ const e = document.querySelector({selector!r});"
                        "e.scrollIntoView({block: 'nearest'});"
                        "const b = e.getBoundingClientRect();"
                        "return [b.left + b.width / 2, b.top + b.height / 2]; })()")

    def click(self, selector):
        self.browser.click(*self.middle_of(selector))

    def expect_text(self, selector, expected):
        self.expect(f"document.querySelector({selector!r}).textContent", expected)

    def key(self, *keys):
        for key in keys:
            self.browser.key(key)
        self.settle()

    def expect_no_overflow(self):
        self.expect("document.documentElement.scrollWidth > window.innerWidth", False)

    def screenshot(self, name):
        self.settle()
        self.browser.screenshot(os.path.join(self.folder, name))
