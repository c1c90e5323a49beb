#!/usr/bin/python3
# SPDX-License-Identifier: MIT
# Debian's Python, for its package of Selenium.
"""The page of the report in headless Chromium, from a file URL, in the sizes of a desktop and of a phone: its pictures load, its
filters work, the comparator moves, nothing comes from a network. The page shows a few scenes, of which one is made to fail.

  page_test.py --scene-test PROGRAM --report PROGRAM --folder FOLDER
"""
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import unittest

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.wait import WebDriverWait

FAILING, SCENES = "fog.exp", "*fog_*:*multisampling_triangle*"


def make_page(scene_test, report, folder):
    """A page of some scenes; the record of one says that it fails, as its name does that script ends must not hurt."""
    shutil.rmtree(folder, ignore_errors=True)
    records = folder / "records"
    subprocess.run([scene_test, f"--gtest_filter={SCENES}"], check=True, stdout=subprocess.DEVNULL,
                   env={**os.environ, "CLEARPIPE_RECORDS": str(records), "CLEARPIPE_OUTPUT": str(folder)})
    failing = records / f"{FAILING}.json"
    record = json.loads(failing.read_text())
    record.update(good=False, note="</script><b>not a mark</b>")
    failing.write_text(json.dumps(record))
    page = folder / "index.html"
    status = subprocess.run([report, str(records), str(page)], stdout=subprocess.DEVNULL, check=False).returncode
    if status != 1:
        raise AssertionError(f"a failing record must give status 1, not {status}")
    return page


def open_browser(width, height):
    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium")
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars"):
        options.add_argument(argument)
    # Mobile emulation, for windows have a least width that is more than a phone's.
    options.add_experimental_option("mobileEmulation", {"deviceMetrics": {
        "width": width, "height": height, "pixelRatio": 1, "mobile": width < 800, "touch": width < 800}})
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)


class Page:
    """The tests, for one size of the window."""
    size = (0, 0)

    @classmethod
    def setUpClass(cls):
        cls.browser = open_browser(*cls.size)
        cls.browser.get(PAGE.as_uri())

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()

    def setUp(self):
        self.press("all")

    def one(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def all(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def press(self, which):
        self.one(f"[data-filter={which}]").click()

    def wait(self, condition):
        WebDriverWait(self.browser, 10).until(lambda _: condition())

    def script(self, text, *arguments):
        return self.browser.execute_script(text, *arguments)

    def names(self):
        return [heading.text.split()[0] for heading in self.all(".card h4")]

    def test_pictures_load(self):
        pictures = self.all(".card img")
        self.assertEqual(len(pictures), 3 * RECORDS)
        for picture in pictures:
            self.script("arguments[0].scrollIntoView()", picture)
            self.wait(lambda shown=picture: self.script("return arguments[0].complete && arguments[0].naturalWidth", shown) == 256)

    def test_pictures_are_the_scenes(self):
        colours = self.script("""
            const canvas = document.createElement('canvas'), context = canvas.getContext('2d');
            canvas.width = canvas.height = 256;
            context.drawImage(document.querySelector('.card img'), 0, 0);
            return new Set(new Uint32Array(context.getImageData(0, 0, 256, 256).data.buffer)).size;""")
        self.assertGreater(colours, 10)

    def test_chapters_are_in_the_specifications_order(self):
        self.assertEqual([h.text for h in self.all("main h2")], ["3 Rasterization"])
        self.assertEqual([h.text for h in self.all("main h3")], ["3.2.1 Multisampling", "3.8 Fog"])

    def test_filters(self):
        self.assertEqual(len(self.names()), RECORDS)
        self.press("failing")
        self.assertEqual(self.names(), [FAILING])
        self.assertEqual(self.one(".card").get_attribute("class"), "card bad")
        self.press("worst")
        self.assertEqual(self.names()[0], FAILING)
        self.assertEqual(len(self.names()), RECORDS)

    def test_search(self):
        search = self.one("#search")
        search.send_keys("EXP2")
        self.assertEqual(self.names(), ["fog.exp2"])
        search.send_keys("nowhere")
        self.assertTrue(self.one("#nothing").is_displayed())
        search.clear()
        search.send_keys("f", Keys.BACKSPACE)
        self.assertEqual(len(self.names()), RECORDS)

    def test_text_is_not_markup(self):
        self.press("failing")
        self.assertIn("</script><b>not a mark</b>", self.one(".card").text)

    def open_viewer(self):
        self.press("failing")
        self.one(".card .pictures").click()
        self.wait(lambda: self.one("#viewer").is_displayed())

    def close_viewer(self):
        self.one("#close").click()
        self.wait(lambda: not self.one("#viewer").is_displayed())

    def covered(self):
        """Where the upper picture begins, as a share of the stage."""
        return self.script("return parseFloat(getComputedStyle(document.getElementById('above')).clipPath.split(' ').pop())")

    def test_slider_moves(self):
        self.open_viewer()
        self.one("[data-mode=slider]").click()
        self.assertEqual(self.covered(), 50)
        self.script("slider.value = 200; slider.dispatchEvent(new Event('input'))")
        self.assertEqual(self.covered(), 20)
        stage = self.one("#stage")
        webdriver.ActionChains(self.browser).move_to_element(stage).click_and_hold().move_by_offset(
            stage.size["width"] // 4, 0).release().perform()
        self.assertAlmostEqual(self.covered(), 75, delta=2)
        self.close_viewer()

    def test_blink_alternates(self):
        self.open_viewer()
        self.one("[data-mode=blink]").click()
        first = self.one("#label-left").text
        self.wait(lambda: self.one("#label-left").text != first)
        self.wait(lambda: self.one("#label-left").text == first)
        self.one("[data-mode=difference]").click()
        self.assertIn("32", self.one("#label-left").text)
        self.close_viewer()

    def test_next_and_previous(self):
        self.one(".card .pictures").click()
        first = self.one("#viewer-name").text
        self.one("#next").click()
        second = self.one("#viewer-name").text
        self.assertNotEqual(first, second)
        self.one("#previous").click()
        self.assertEqual(self.one("#viewer-name").text, first)
        self.close_viewer()

    def test_fits_the_window(self):
        self.assertLessEqual(self.script("return document.documentElement.scrollWidth"), self.size[0])
        self.open_viewer()
        box = self.one("#viewer").rect
        self.assertLessEqual(box["x"] + box["width"], self.size[0])
        self.assertLessEqual(box["y"] + box["height"], self.size[1])
        self.close_viewer()

    def test_no_network_and_no_errors(self):
        requests = [json.loads(entry["message"])["message"] for entry in self.browser.get_log("performance")]
        urls = {r["params"]["request"]["url"].split(":", 1)[0] for r in requests if r["method"] == "Network.requestWillBeSent"}
        self.assertLessEqual(urls, {"file", "data"})
        self.assertEqual([e for e in self.browser.get_log("browser") if e["level"] == "SEVERE"], [])


class Desktop(Page, unittest.TestCase):
    size = (1280, 900)


class Phone(Page, unittest.TestCase):
    size = (360, 740)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--scene-test", required=True)
    parser.add_argument("--report", required=True)
    parser.add_argument("--folder", required=True, type=pathlib.Path)
    given = parser.parse_args()
    PAGE = make_page(given.scene_test, given.report, given.folder.resolve())
    RECORDS = len(list((given.folder / "records").glob("*.json")))
    unittest.main(argv=["page_test"], verbosity=2)
