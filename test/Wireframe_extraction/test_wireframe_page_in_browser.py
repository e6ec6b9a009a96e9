#!/usr/bin/env python3
"""Tests the page of extract_wireframe --html in Chromium: that it draws, and does what is chosen.

usage: test_wireframe_page_in_browser.py CHROMIUM EXTRACT_WIREFRAME MAKE_CLOUD [options of unittest]

With the variable WIREFRAME_PAGE_PICTURES set, pictures of the page are left in that folder.
"""

import os
import pathlib
import time

from headless_browser import Browser
from program_test import Program_test, main


# how many pixels of the view are neither its background nor near to it
COUNT_PIXELS = """(() => {
  const view = wireframe.view;
  view.renderer.render(view.scene, view.camera);
  const { width, height } = view.canvas, gl = view.renderer.getContext();
  const pixels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let count = 0;
  for (let i = 0; i < pixels.length; i += 4)
    if (Math.abs(pixels[i] - 246) + Math.abs(pixels[i + 1] - 248) + Math.abs(pixels[i + 2] - 251) > 60)
      ++count;
  return count;
})()"""


class Browser_test(Program_test):
    def page_of(self, name, *arguments):
        self.make_cloud(self.folder / name, *arguments)
        self.run_tool(name, "--html", name + ".html", "--quiet")
        return self.folder / (name + ".html")

    def open(self, page):
        browser = Browser(self.chromium)
        self.addCleanup(browser.__exit__)
        browser.open(page)
        browser.wait_for("window.wireframe !== undefined && wireframe.view !== null")
        browser.frames(3)
        return browser

    def keep_picture(self, browser, name):
        if "WIREFRAME_PAGE_PICTURES" in os.environ:
            folder = pathlib.Path(os.environ["WIREFRAME_PAGE_PICTURES"])
            folder.mkdir(parents=True, exist_ok=True)
            (folder / (name + ".png")).write_bytes(browser.screenshot())

    def press(self, browser, *ids):
        for name in ids:
            browser.evaluate(f"document.getElementById('{name}').click()")
        browser.frames()

    def choose(self, browser, name, value):
        browser.evaluate(f"""(() => {{
            const element = document.getElementById('{name}');
            element.value = '{value}';
            element.dispatchEvent(new Event('input'));
        }})()""")
        browser.frames()

    def test_page(self):
        browser = self.open(self.page_of("a <b> & c.ply", "slotted_plate", "--points", 8000, "--field", "def"))
        self.keep_picture(browser, "page")
        self.assertEqual(browser.evaluate("document.getElementById('title').textContent"), "a <b> & c.ply")
        self.assertIn("a <b> & c.ply", browser.evaluate("document.title"))
        self.check_layers(browser)
        self.check_hover(browser)
        self.check_filter(browser)
        self.check_table(browser)
        self.check_view(browser)
        self.check_run(browser)
        self.assertEqual(browser.errors, [])
        self.assertEqual([url for url in browser.requests if not url.startswith(("file:", "data:", "blob:"))], [])

    def check_layers(self, browser):
        layers = browser.evaluate("[...document.querySelectorAll('#layers input')].map(box => box.id)")
        self.assertEqual(len(layers), 9)
        shown = browser.evaluate("[...document.querySelectorAll('#layers input:checked')].map(box => box.id)")
        self.press(browser, *shown)
        self.assertEqual(browser.evaluate(COUNT_PIXELS), 0)   # now all are off
        for layer in layers:
            self.press(browser, layer)
            self.assertGreater(browser.evaluate(COUNT_PIXELS), 30, layer)
            self.keep_picture(browser, layer)
            self.press(browser, layer)
        self.press(browser, *shown)

    def check_hover(self, browser):
        self.press(browser, "layer-cloud")
        place = browser.evaluate("""(() => {
            const curve = wireframe.data.curves.find(curve => curve.type === 'arc');
            const { left, top } = document.getElementById('canvas').getBoundingClientRect();
            const { x, y } = wireframe.view.placeOf(curve);
            return { x: x + left, y: y + top, index: curve.index, support: curve.support };
        })()""")
        browser.move(place["x"], place["y"])
        browser.wait_for("!document.getElementById('hint').hidden")
        text = browser.evaluate("document.getElementById('hint').innerText")
        self.keep_picture(browser, "hover")
        for words in (f"Curve {place['index']}: arc", "length", "radius", "rms residual", "largest",
                      f"{place['support']} points"):
            self.assertIn(words, text)
        self.assertTrue(browser.evaluate("wireframe.view.highlight.visible"))
        browser.move(*browser.evaluate("""(() => {
            const box = document.getElementById('canvas').getBoundingClientRect();
            return [box.left + 5, box.top + 5];
        })()"""))
        browser.wait_for("document.getElementById('hint').hidden")
        self.assertFalse(browser.evaluate("wireframe.view.highlight.visible"))
        self.press(browser, "layer-cloud")

    def rows(self, browser):
        return browser.evaluate("""[...document.querySelectorAll('#curves tbody tr')].map(
            row => wireframe.data.curves[Number(row.cells[0].textContent)])""")

    def check_filter(self, browser):
        every = browser.evaluate("wireframe.data.curves")
        self.assertEqual(len(self.rows(browser)), len(every))
        for measure in ("rms", "max"):
            self.choose(browser, "filter-measure", measure)
            for side, is_shown in (("below", lambda value, limit: value <= limit),
                                   ("above", lambda value, limit: value >= limit)):
                self.choose(browser, "filter-side", side)
                self.assertEqual(len(self.rows(browser)), len(every))
                self.choose(browser, "filter", 400)
                limit = 0.16 * max(curve[measure] for curve in every)
                expected = [curve["index"] for curve in every if is_shown(curve[measure], limit)]
                self.assertTrue(0 < len(expected) < len(every))
                self.assertEqual([curve["index"] for curve in self.rows(browser)], expected)
                self.assertEqual(browser.evaluate("wireframe.view.shownCurves.map(curve => curve.index)"), expected)
        self.choose(browser, "filter-side", "below")
        self.press(browser, "type-arc")
        self.assertEqual([curve["index"] for curve in self.rows(browser)],
                         [curve["index"] for curve in every if curve["type"] != "arc"])
        self.press(browser, "type-arc")
        for verdict, is_doubtful in (("doubtful", True), ("clear", False), ("all", None)):
            self.choose(browser, "filter-verdict", verdict)
            self.assertEqual([curve["index"] for curve in self.rows(browser)],
                             [curve["index"] for curve in every if is_doubtful in (None, bool(curve["doubts"]))])
        for colour in ("residual", "index", "verdict", "type"):
            self.choose(browser, "curve-colour", colour)

    def check_table(self, browser):
        for column, name in enumerate(("index", "type", "length", None, "rms", "max", "support")):
            if name is None:
                continue
            orders = []
            for _ in range(2):
                browser.evaluate(f"document.querySelectorAll('#curves th')[{column}].click()")
                orders.append([curve[name] for curve in self.rows(browser)])
            names = {"bspline": "B-spline"}   # as they are read
            ordered = sorted(orders[0], key=lambda value: names.get(value, value))
            self.assertIn(orders[0], (ordered, ordered[::-1]))
            self.assertEqual(orders[1], orders[0][::-1])
        before = browser.evaluate("wireframe.view.controls.target.toArray()")
        browser.evaluate("document.querySelector('#curves tbody tr').click()")
        browser.frames()
        self.keep_picture(browser, "selected")
        index = browser.evaluate("wireframe.state.selected.index")
        self.assertEqual(index, self.rows(browser)[0]["index"])
        self.assertNotEqual(browser.evaluate("wireframe.view.controls.target.toArray()"), before)
        self.assertEqual(browser.evaluate("document.querySelectorAll('#curves tr.is-selected').length"), 1)
        browser.evaluate("window.dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape' }))")
        self.assertTrue(browser.evaluate("wireframe.state.selected === null"))

    def check_view(self, browser):
        def camera():
            return browser.evaluate("[...wireframe.view.camera.position.toArray(), "
                                    "...wireframe.view.controls.target.toArray()]")
        self.press(browser, "view-front")
        front = camera()
        self.assertLess(abs(front[0]), 1e-6)
        self.press(browser, "view-isometric")
        isometric = camera()
        self.assertNotEqual(front, isometric)
        x, y = browser.evaluate("""(() => {
            const box = document.getElementById('canvas').getBoundingClientRect();
            return [box.left + box.width / 2, box.top + box.height / 2];
        })()""")
        browser.drag(x, y, x + 80, y + 40)
        turned = camera()
        self.assertNotEqual(turned[:3], isometric[:3])
        self.assertEqual(turned[3:], isometric[3:])
        browser.mouse("mouseWheel", x, y, deltaX=0, deltaY=-240)
        browser.frames(4)
        self.assertNotEqual(camera(), turned)

    def check_run(self, browser):
        self.press(browser, "tab-run")
        text = browser.evaluate("document.getElementById('panel-run').innerText")
        self.keep_picture(browser, "run")
        for words in ("Points", "Residuals", "reading", "--corner-reach", "--maximum-gap"):
            self.assertIn(words, text)
        self.press(browser, "tab-curves")

    def test_large_cloud(self):
        """However slow the computer, a million points can be turned, and more of them come at rest."""
        browser = self.open(self.page_of("large.ply", "slotted_plate", "--points", 1000000, "--field", "exact",
                                          "--sampling", "uniform"))   # which are made in a moment
        self.assertEqual(browser.evaluate("wireframe.view.numberOfPoints"), 1000000)
        browser.wait_for("!wireframe.view.isBusy && wireframe.view.hasDrawn")
        for _ in range(5):   # by then it is known how many can be drawn
            browser.drag(650, 450, 700, 480, steps=4)
        begin = time.monotonic()
        browser.drag(650, 450, 700, 480, steps=10)
        seconds = time.monotonic() - begin
        moving = browser.evaluate("wireframe.view.mostPoints.motion")
        browser.wait_for("!wireframe.view.isMoving && !wireframe.view.isBusy && !wireframe.view.frame")
        at_rest = browser.evaluate("wireframe.view.drawnPoints")
        self.keep_picture(browser, "large")
        print(f"1000000 points: a drag of 10 steps takes {seconds:.1f} s with {moving:.0f} of them, at rest {at_rest}")
        self.assertLess(seconds, 30)
        self.assertGreaterEqual(at_rest, min(100000, moving))
        self.assertIn(f"{at_rest:,}", browser.evaluate("document.getElementById('point-count').textContent"))
        self.assertEqual(browser.errors, [])


if __name__ == "__main__":
    main("chromium", "tool", "cloud_maker")
