"""browser_test.py DE1SIM FOLDER PROGRAMS - `de1sim live` as a person has it: in Chromium."""
import json
import subprocess

from selenium import webdriver
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from chromium import DE1SIM, FOLDER, PROGRAMS, Chromium, run

COLOURED = """
const c = document.getElementById("monitor");
const d = c.getContext("2d").getImageData(0, 60, c.width, c.height - 60).data;
let n = 0;
for (let i = 0; i < d.length; i += 4) n += d[i] + d[i + 1] + d[i + 2] > 100;
return n;
"""


class Page(Chromium):
    def setUp(self):
        self.open()

    def frames(self):
        return int(self.find("#status").text.split(" frames")[0].split()[-1])

    def tap(self, key):
        button = self.find(f'[aria-label="keypad {key}"]')
        shown = self.hex()
        webdriver.ActionChains(self.page).click_and_hold(button).perform()
        self.until(lambda: self.hex() != shown)
        webdriver.ActionChains(self.page).release().perform()

    def hex(self):
        return self.find("#hex").get_attribute("aria-label").split(": ")[1]

    def test_the_board_has_what_a_de1_soc_has(self):
        """As in its manual; the Arduino header is other boards'."""
        def count(selector):
            return self.page.execute_script(
                "return document.querySelectorAll(arguments[0]).length", selector)
        self.until(lambda: count("#headers > [hidden]") == 1)
        self.assertEqual(self.find("#headers > [hidden]").get_attribute("data-wire"),
                         "ARDUINO_IO[0]")
        self.assertEqual([count(f"#{group} > :not([hidden])")
                          for group in ("ledr", "hex", "switches", "keys", "headers")],
                         [10, 6, 10, 5, 2])

    def test_shapes_are_seen_heard_and_kept(self):
        black = self.page.execute_script(COLOURED)
        self.page.execute_script(
            "const v = document.getElementById('volume'); v.value = 50;"
            "v.dispatchEvent(new Event('input'));")
        self.tap("1")
        self.tap("2")
        self.assertEqual(self.hex(), "     2")
        self.until(lambda: self.page.execute_script(COLOURED) > black + 50)
        self.until(lambda: int(self.find("#volume").get_attribute("data-heard") or 0) > 800)
        self.find("#pause").click()
        self.until(lambda: "paused" in self.find("#status").text)
        before = self.frames()
        self.find("#frame").click()
        self.until(lambda: self.frames() == before + 1)
        self.page.save_screenshot(str(FOLDER / "page.png"))
        self.find("#mark").click()
        self.until(lambda: "marked" in self.find("#message").text)
        figures = dict(self.page.execute_script(
            "return [...document.querySelectorAll('#figures div')]"
            ".map((row) => [...row.children].map((part) => part.textContent.trim()));"))
        self.assertRegex(figures["Bus per frame"], r"^[1-9]\d* reads, [1-9]\d* writes, \d+ bursts$")
        self.assertEqual(figures["Samples recorded"], "128, 128 of 128")
        self.assertIn("640 x 480", figures["Signal"])
        self.assertNotIn("Program", figures)  # the demo is not an ARM's
        self.find("#save").click()
        self.until(lambda: "saved" in self.find("#message").text)
        again = subprocess.run([DE1SIM, "run", self.board.out / "live.yaml", "--quiet",
                                "--out", self.folder / "again"], capture_output=True, text=True)
        self.assertEqual(again.returncode, 0, again.stdout + again.stderr)

    def drop_program(self, program):
        self.drop(program.read_bytes())
        self.until(lambda: self.page.execute_script(
            "return [...document.querySelectorAll('#figures div')]"
            ".some((row) => row.textContent.includes('Program'))"))

    def test_a_program_that_is_dropped_runs(self):
        self.drop_program(PROGRAMS / "leds_and_rectangle.elf")
        self.until(lambda: self.page.execute_script(COLOURED) > 1000)

    def test_a_key_moves_the_box_of_a_program_for_nios_v(self):
        def is_yellow(x, y):
            red, green, blue, _ = self.page.execute_script(
                "return [...document.getElementById('monitor').getContext('2d')"
                ".getImageData(arguments[0], arguments[1], 1, 1).data]", x, y)
            return red > 200 and green > 200 and blue < 50

        self.drop_program(PROGRAMS.parents[1] / "examples/course/course.nios-v.elf")
        self.until(lambda: is_yellow(20, 20) and not is_yellow(120, 100))
        self.find('[aria-label="KEY0"]').click()  # over at once, in a simulation that is slow
        self.until(lambda: is_yellow(120, 100) and not is_yellow(20, 20))
        lamps = self.find("#ledr").get_attribute("aria-label")
        self.assertEqual(lamps, "LEDR9 to LEDR0: 0000000001")
        self.page.save_screenshot(str(FOLDER / "nios_v.png"))

    def test_parts_of_a_scenario_have_their_place(self):
        self.drop(b"""name: parts
version: 1
parts:
  - led: {name: open, pin: "GPIO_1[0]"}
  - switch: {name: mode, pin: "GPIO_1[1]"}
  - button: {name: go, pin: "GPIO_1[2]"}
  - terminal: {name: modem, rx: "GPIO_1[3]", tx: "GPIO_1[4]"}
  - lt24: GPIO_1
steps:
  - delay: 1ms
""")
        self.until(lambda: self.page.find_elements(By.CSS_SELECTOR, "#part-lt24 img"))
        self.find("#type-modem")
        lit = self.find("#part-open .leds").get_attribute("aria-label")
        self.assertEqual(lit, "led open: #")  # by the pull-up of its pin
        self.assertEqual(self.page.execute_script(
            "return document.querySelector('#part-lt24 img').naturalWidth"), 240)
        self.find("#part-mode button").click()
        self.find("#part-go button").click()
        self.until(lambda: "3 steps" in self.find("#status").text)
        self.page.save_screenshot(str(FOLDER / "parts.png"))
        saved = self.saved()
        self.assertIn('{"set-switch":{"level":"high","switch":"mode"}}', saved)
        self.assertIn('{"hold-button":"go"}', saved)
        self.assertIn('{"release-button":"go"}', saved)

    def test_waveforms_are_written_of_what_was_played(self):
        self.tap("3")
        self.find("#length").clear()
        self.find("#length").send_keys("5")
        self.find("#waves").click()
        self.until(lambda: "waveforms: " in self.find("#message").text)
        self.assertTrue((self.board.out / "waves-1" / "waves.fst").exists())

    def test_a_film_plays(self):
        scenario = self.folder / "film.yaml"
        scenario.write_text("name: film\nversion: 1\nsteps:\n  - delay: 500ms\n")
        for kind in "mp4", "webm":
            film = self.folder / f"film.{kind}"
            done = subprocess.run([DE1SIM, "run", scenario, "--quiet", "--video", film, "--out",
                                   self.folder / kind], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.page.get(film.as_uri())
            look = "const v = document.querySelector('video');" \
                   "return [v.readyState, v.videoWidth, v.videoHeight, v.duration, v.currentTime]"
            self.until(lambda: self.page.execute_script(look)[4] > 0.1)
            ready, width, height, seconds, _ = self.page.execute_script(look)
            self.assertGreaterEqual(ready, 2)
            self.assertEqual((width, height), (1280, 960))
            self.assertAlmostEqual(seconds, 0.5, delta=0.06)

    def test_keys_go_to_the_board_by_keyboard_alone(self):
        button = self.find('[aria-label="keypad 4"]')
        self.page.execute_script("arguments[0].focus()", button)
        webdriver.ActionChains(self.page).key_down(Keys.SPACE).perform()
        self.until(lambda: self.hex() == "     1")
        webdriver.ActionChains(self.page).key_up(Keys.SPACE).perform()
        self.find("#monitor").click()
        webdriver.ActionChains(self.page).send_keys("a", Keys.ARROW_LEFT, Keys.F1).perform()
        self.until(lambda: "8 steps" in self.find("#status").text)  # 3 keys, down and up
        for line in "serial", "jtag-0", "jtag-1":
            self.find(f"#type-{line}").send_keys("hello", Keys.ENTER)
        self.until(lambda: "11 steps" in self.find("#status").text)
        self.assertEqual(self.find("#printed-serial").text, "ready")
        self.assertEqual(self.find("#printed-jtag-0").text, "")

    def test_the_mouse_is_the_boards_while_it_is_locked_to_the_picture(self):
        self.find("#mouse").click()
        canvas = self.find("#monitor")
        webdriver.ActionChains(self.page).move_to_element(canvas).click().perform()
        self.until(lambda: self.page.execute_script(
            "return document.pointerLockElement === document.getElementById('monitor')"))
        webdriver.ActionChains(self.page).move_by_offset(30, 10).move_by_offset(40, 0).perform()
        self.until(lambda: self.moved_in_what_is_saved() >= 70)  # the browser sends when it draws
        self.assertIn('{"hold-mouse":"left"}', self.saved())

    def moved_in_what_is_saved(self):
        moves = [json.loads(line[4:])["move-mouse"] for line in self.saved().splitlines()
                 if line.startswith('  - {"move-mouse"')]
        return sum(move["right"] for move in moves)


if __name__ == "__main__":
    run()
