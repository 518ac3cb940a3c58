# SPDX-License-Identifier: Apache-2.0
"""Checks of a report of many cases; viewer_page_test.py runs them."""


def list_puts_failures_first_and_filters(page):
    page.open("many.html")
    titles = "[...document.querySelectorAll('#cases li:not([hidden]) .case-title')].map(t => t.textContent)"
    page.expect(f"{titles}.slice(0, 5)",
                ["</script><script>injected = 1</script>", "sizes/other", "non-finite/100% nan + inf",
                 "glass/no reference yet", "museum/night"])
    page.expect("typeof injected", "undefined")
    page.expect(f"{titles}.length", 31)
    page.wait("document.querySelectorAll('#cases li:first-child canvas').length === 3")
    page.expect_no_overflow()
    page.screenshot("list.png")
    page.key("/")
    page.browser.type("case-1 sph")
    page.expect(f"{titles}.length", 11)
    page.expect_text("#count", "11 of 31 shown")
    page.get("document.querySelector('#search').value = ''")
    page.click("button[data-verdict=refused]")
    page.expect(titles, ["sizes/other", "non-finite/100% nan + inf"])


def links_back_and_neighbours_work(page):
    page.open("many.html")
    page.get("document.querySelector('#cases li:nth-child(3) a').scrollIntoView()")
    page.click("#cases li:nth-child(3) .case-title")
    page.wait("viewer.pictures.actual !== null")
    page.expect_text("#case-name", "non-finite/100% nan + inf")
    page.key("a")
    page.expect_color(page.place_of_pixel(0, 0), [255, 0, 255])
    page.key("j")
    page.wait("viewer.entry.name === 'glass/no reference yet' && viewer.pictures.actual !== null")
    page.expect("[...document.querySelectorAll('#modes button:enabled')].map(b => b.dataset.mode)",
                ["actual"])
    page.screenshot("missing.png")
    page.get("history.back()")
    page.wait("viewer.entry.name === 'non-finite/100% nan + inf'")
    page.key("Escape")
    page.wait("!document.querySelector('#list-page').hidden")
    page.get("history.back()")
    page.wait("document.querySelector('#list-page').hidden")
    address = page.get("location.hash")
    page.open_viewer("many.html", address)
    page.expect_text("#case-name", "non-finite/100% nan + inf")
    page.expect("viewer.mode", "actual")


def sizes_may_differ(page):
    page.open_viewer("many.html", "#case=sizes%2Fother&mode=side")
    page.expect("[viewer.view.width, viewer.view.height]", [120, 72])
    page.browser.move(*page.place_of_pixel(110, 10, 1))
    page.settle()
    page.expect("document.querySelector('#readout-actual').cells[1].textContent", "")
    page.expect("document.querySelector('#readout-expected').cells[1].textContent", "0.50000")
