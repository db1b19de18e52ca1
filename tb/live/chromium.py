"""chromium.py - the page of `de1sim live` in Chromium, as a person has it.

Exit code 77: Chromium is not installed.
"""
import base64
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

from selenium import webdriver
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.wait import WebDriverWait

from board import Board

if not (shutil.which("chromedriver") and shutil.which("chromium")):
    print("Chromium or its driver is not installed")
    sys.exit(77)

DE1SIM, FOLDER, PROGRAMS = sys.argv[1], *map(pathlib.Path, sys.argv[2:4])


class Chromium(unittest.TestCase):
    def setUp(self):
        FOLDER.mkdir(parents=True, exist_ok=True)

    def open(self, *words):
        """The page of `de1sim live WORDS`, with its first picture; the test's end closes it."""
        self.folder = FOLDER / self.id().split(".")[-1]
        self.board = Board(DE1SIM, self.folder, *words)
        self.addCleanup(self.board.__exit__)
        options = webdriver.ChromeOptions()
        for word in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                     "--disable-background-networking", "--disable-component-update",
                     "--remote-debugging-pipe", "--no-first-run", "--window-size=1400,1000",
                     "--autoplay-policy=no-user-gesture-required",
                     f"--user-data-dir={self.folder / 'profile'}"):
            options.add_argument(word)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.page = webdriver.Remote(self.driver(), options=options)
        self.addCleanup(self.page.quit)
        self.addCleanup(self.finds_no_errors)
        self.page.get(self.board.url)
        self.until(lambda: int(self.find("#monitor").get_attribute("data-shown") or 0) > 0)

    def driver(self):
        """Starts ChromeDriver; by its address, since a bare system does not know "localhost"."""
        driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=subprocess.PIPE, text=True)
        self.addCleanup(driver.stdout.close)
        self.addCleanup(driver.wait)
        self.addCleanup(driver.terminate)
        for line in driver.stdout:
            if found := re.search(r"started successfully on port (\d+)", line):
                return f"http://127.0.0.1:{found.group(1)}"
        raise RuntimeError("chromedriver does not start")

    def finds_no_errors(self):
        """In the page's console."""
        wrong = [entry["message"] for entry in self.page.get_log("browser")
                 if entry["level"] == "SEVERE"]
        self.assertEqual(wrong, [])

    def find(self, selector):
        return self.page.find_element(By.CSS_SELECTOR, selector)

    def until(self, met):
        """Waits long, since a browser on a busy machine takes seconds for what it does at once."""
        WebDriverWait(self.page, 120, 0.05).until(lambda _: met())

    def drop(self, content):
        self.page.execute_script("""
            const bytes = Uint8Array.from(atob(arguments[0]), (c) => c.charCodeAt(0));
            const dropped = new DataTransfer();
            dropped.items.add(new File([bytes], "dropped"));
            document.dispatchEvent(new DragEvent("drop", {dataTransfer: dropped}));""",
                                 base64.b64encode(content).decode())

    def saved(self):
        self.page.execute_script("document.getElementById('message').textContent = ''")
        self.find("#save").send_keys(Keys.ENTER)
        self.until(lambda: "saved" in self.find("#message").text)
        return (self.board.out / "live.yaml").read_text()


def run():
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
