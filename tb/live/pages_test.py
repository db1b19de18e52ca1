"""pages_test.py DE1SIM FOLDER PROGRAMS - the pages of other boards in Chromium; leaves pictures."""
import json
import pathlib
import shutil

from selenium.webdriver.common.by import By

from chromium import FOLDER, PROGRAMS, Chromium, run

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = PROGRAMS.parents[1] / "examples"


class Pages(Chromium):
    def texts(self, selector):
        """Of what is shown."""
        return [one.text or one.get_attribute("title")
                for one in self.page.find_elements(By.CSS_SELECTOR, selector) if one.is_displayed()]

    def move(self, selector, value):
        self.page.execute_script(
            "const range = document.querySelector(arguments[0]); range.value = arguments[1];"
            "range.dispatchEvent(new Event('input', {bubbles: true}));", selector, value)

    def pictures(self):
        return int(self.find("#monitor").get_attribute("data-shown"))

    def picture(self, name):
        self.page.execute_script("window.scrollTo(0, 0)")
        self.page.save_screenshot(str(FOLDER / f"{name}.png"))

    def open_details(self):
        for summary in self.page.find_elements(By.CSS_SELECTOR, "summary"):
            if summary.is_displayed():
                summary.click()

    def numbered(self, name, count):
        return [f"{name}{n}" for n in reversed(range(count))]

    def test_the_de10_lite_has_its_own_controls(self):
        scenario = FOLDER / "of_a_de10_lite.yaml"
        scenario.write_text(f"name: bubble\nversion: 1\nboard: DE10-Lite\n"
                            f"program: {json.dumps(str(EXAMPLES / 'bubble/bubble.nios-v.elf'))}\n"
                            "steps:\n  - delay: 1ms\n")
        self.open(scenario)
        self.until(lambda: self.find("#name").text == "DE10-Lite")
        self.open_details()
        self.assertEqual(self.texts("#keys button"), self.numbered("KEY", 2))
        self.assertEqual(self.texts("#ledr div"), self.numbered("LEDR", 10))
        self.assertEqual(self.texts("#voltages label"), [f"Arduino_A{n}" for n in range(6)])
        self.assertEqual(self.texts("#headers p"), ["GPIO, in steps GPIO_0 (outputs bold)",
                                                    "ARDUINO_IO (outputs bold)"])
        self.assertEqual(len(self.texts("#headers td")), 36 + 16)
        self.assertEqual(self.texts("#terminals h2"), ["JTAG UART 0", "JTAG UART 1"])
        for absent in "#volume", "#mouse", "#focus", "#hex circle":
            self.assertEqual(self.find(absent).is_displayed(), absent == "#hex circle", absent)
        self.assertNotIn("Underruns", self.find("#figures").text)
        before = self.pictures()
        self.move("[data-way=right]", 20)
        self.move("[data-channel='0']", 2.5)
        self.until(lambda: self.pictures() > before)
        self.picture("de10_lite")
        saved = self.saved()
        self.assertIn('{"tilt-board":{"right":20,"towards":0}}', saved)
        self.assertIn('{"set-voltage":{"channel":0,"volts":2.5}}', saved)
        self.drop(b"name: another board\nversion: 1\nsteps:\n  - delay: 1ms\n")
        self.until(lambda: self.find("#name").text == "DE1-SoC")
        self.assertEqual(self.texts("#keys button"), [*self.numbered("KEY", 4), "HPS_KEY"])
        self.assertTrue(self.find("#volume").is_displayed())
        self.assertFalse(self.find("#hex circle").is_displayed())
        self.assertEqual(self.texts("#voltages label"), [f"CH{n}" for n in range(8)])

    def test_the_de10_standard_has_an_lcd_and_one_header(self):
        self.open(EXAMPLES / "lcd/lcd_on_de10_standard.yaml")
        self.until(lambda: self.page.find_elements(By.CSS_SELECTOR, "#parts img"))
        self.picture("de10_standard")
        self.open_details()
        self.assertEqual(self.find("#name").text, "DE10-Standard")
        self.assertEqual(self.texts("#parts p"), ["HPS LCD"])
        self.assertEqual(self.texts("#headers p"), ["GPIO, in steps GPIO_0 (outputs bold)"])
        self.assertTrue(self.find("#volume").is_displayed())

    def test_the_de10_nano_has_eight_leds_and_no_digits(self):
        copy = FOLDER / "boards"
        shutil.rmtree(copy, ignore_errors=True)
        shutil.copytree(REPOSITORY / "rtl/examples/boards", copy)
        self.open(copy / "de10_nano.yaml")
        self.until(lambda: self.find("#name").text == "DE10-Nano")
        self.assertEqual(self.texts("#keys button"), [*self.numbered("KEY", 2), "HPS_KEY"])
        self.assertEqual(self.texts("#switches button"), self.numbered("SW", 4))
        self.assertEqual(self.texts("#ledr div"), self.numbered("LED", 8))
        self.until(lambda: self.find("#ledr").get_attribute("aria-label") ==
                   "LED7 to LED0: 10000001")
        self.assertFalse(self.find("#hex svg").is_displayed())
        self.picture("de10_nano")
        self.open_details()
        self.assertEqual(self.texts("#headers p"), ["GPIO_0 (outputs bold)",
                                                    "GPIO_1 (outputs bold)",
                                                    "ARDUINO_IO (outputs bold)"])


if __name__ == "__main__":
    run()
