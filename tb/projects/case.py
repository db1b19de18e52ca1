"""case.py - a project of a few lines in a folder of its own, and what de1sim makes of it.

A file of cases imports it, and ends with run(): NAME_test.py DE1SIM FOLDER [CASE...]
"""
import json
import pathlib
import shutil
import subprocess
import sys
import unittest

DE1SIM, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
GHDL = int(subprocess.run(["ghdl", "--version"], capture_output=True, text=True,
                          check=True).stdout.split()[1].split(".")[0])
LEDS = "module top(input [9:0] SW, output [9:0] LEDR); assign LEDR = {}; endmodule\n"


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = FOLDER / self.id().split(".")[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def write(self, **files):
        """top_v="..." becomes top.v; two underscores are a folder."""
        for name, text in files.items():
            path = self.folder / (name.replace("__", "/")[::-1].replace("_", ".", 1)[::-1])
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)

    def de1sim(self, *words):
        return subprocess.run([DE1SIM, *words], cwd=self.folder, capture_output=True, text=True)

    def refused(self, message, *words):
        done = self.de1sim(*(words or ("check", ".")))
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn(message, done.stderr)
        said = [line for line in done.stderr.splitlines() if line.startswith("de1sim: ")]
        self.assertEqual(len(said), 1, done.stderr)  # after the notes

    def checked(self, *lines):
        done = self.de1sim("check", ".")
        self.assertEqual(done.returncode, 0, done.stderr)
        for line in lines:
            self.assertIn(line, done.stdout)

    def plays(self, *steps, parts="", arguments=(), project="."):
        parts = parts and "parts:\n" + parts
        (self.folder / "s.yaml").write_text(f"name: s\nversion: 1\n{parts}steps:\n" +
                                            "".join(f"  - {step}\n" for step in steps))
        done = self.de1sim("run", "s.yaml", "--project", project, *arguments)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done

    def report(self):
        return json.loads((self.folder / "out" / "report.json").read_text())

    def leds(self, expected, switches=0, wait="1ms", project=".", top=""):
        held = [i for i in range(10) if switches >> i & 1]
        hold = [f"hold: {{switch: {held}}}"] if held else []
        return self.plays(*hold, f"delay: {wait}", f'expect-leds: "{expected:010b}"',
                          arguments=["--top", top] if top else [], project=project).stderr


def run():
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
