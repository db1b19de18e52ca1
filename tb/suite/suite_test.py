"""suite_test.py DE1SIM FOLDER [CASE...] - de1sim test: which run, what is told, what stays"""
import base64
import json
import pathlib
import re
import signal
import subprocess
import time
import xml.etree.ElementTree as xml

import jsonschema

from folder import DE1SIM, HERE, Folder, black_png, run

PROGRAMS = pathlib.Path(DE1SIM).resolve().parent.parent / "tb/programs"
READY = "wait-serial: ready", "wait-frame: 3"


class Suite(Folder):
    def test_all_that_are_found_run(self):
        self.three()
        (self.folder / "s" / "ci.yaml").write_text("jobs:\n  build: {}\n")  # somebody else's
        self.scenario("s/.hidden/not")
        self.scenario("s/out/not")
        (self.folder / "s" / "out" / "report.json").write_text("{}")
        done = self.suite("s", code=1)
        self.assertEqual(self.codes(), {"s/good": 0, "s/deep/good": 0, "s/bad": 1})
        self.assertIn("2 of 3 scenarios passed", done.stdout)
        lines = done.stderr.splitlines()
        self.assertEqual(sorted(line.split()[-1] for line in lines[:3]), sorted(self.codes()))
        self.assertEqual(lines[3:], ["", "s/bad.yaml: all steps done",
                                     '  line 5: expect LEDs 1111111111',
                                     '    LEDR shows 0000000000'])
        self.assertTrue((self.folder / "test-results/runs/s/deep/good/report.json").exists())

    def test_junit_has_a_suite_per_scenario(self):
        self.three()
        (self.folder / "s" / "broken.yaml").write_text("name: x\nversion: 2\n")
        self.suite("s", code=2)
        self.check_junit()
        root = xml.parse(self.folder / "test-results/junit.xml").getroot()
        suites = {suite.get("name"): suite for suite in root}
        self.assertEqual(set(suites), {"s/good", "s/deep/good", "s/bad", "s/broken"})
        self.assertEqual(suites["s/deep/good"].get("failures"), "0")
        self.assertEqual(suites["s/bad"].find("testcase/failure").get("message"),
                         "LEDR shows 0000000000")
        self.assertIn("version", suites["s/broken"].find("testcase/error").text)

    def test_a_golden_picture_that_differs(self):
        """Both are on the page; --update-goldens mends it, and touches nothing else."""
        self.scenario("s/picture", *READY, "expect-frame: {equals: golden.png}", head="")
        self.scenario("s/other", *READY, head="")
        black_png(self.folder / "s" / "golden.png")
        self.suite("s", code=1)
        index = (self.folder / "test-results/index.html").read_text()
        for what in ("expected", "actual", "difference"):
            [name] = re.findall(rf'data-what="{what}" alt="{what}" src="([^"]*)"', index)
            self.assertTrue((self.folder / "test-results" / name).exists(), name)
        self.check_junit()
        junit = (self.folder / "test-results/junit.xml").read_text()
        [actual] = re.findall(r"\[\[ATTACHMENT\|(.*_actual.png)\]\]", junit)
        self.assertTrue((self.folder / "test-results" / actual).exists())
        before = {p: p.read_bytes() for p in (self.folder / "s").iterdir()}
        done = self.suite("s", "--update-goldens")
        self.assertIn("2 of 2 scenarios passed, 1 golden pictures renewed", done.stdout)
        self.assertEqual((self.folder / "test-results/index.html").read_text().count("data-what="),
                         index.count("data-what="))
        changed = [p.name for p, old in before.items() if p.read_bytes() != old]
        self.assertEqual(changed, ["golden.png"])
        self.assertEqual(len(list((self.folder / "s").iterdir())), 3)
        self.suite("s")

    def test_a_golden_picture_that_is_not_there_yet(self):
        self.scenario("s/picture", *READY, "expect-frame: {equals: golden.png}", head="")
        self.suite("s", code=2)
        done = self.suite("s", "--update-goldens")
        self.assertIn("1 of 1 scenarios passed, 1 golden pictures renewed", done.stdout)
        self.assertTrue((self.folder / "s" / "golden.png").exists())
        self.suite("s")

    def test_gradescope_and_classroom(self):
        """Points, and the first difference as a person sees it, by the format's description."""
        self.scenario("s/good", head="duration: 2ms\npoints: 3")
        self.scenario("s/bad", 'expect-leds: "1111111111"',
                      head="duration: 2ms\npoints: 2\nvisibility: after-due-date")
        self.scenario("s/picture", *READY, "expect-frame: {equals: golden.png}", head="")
        black_png(self.folder / "s" / "golden.png")
        self.suite("s", "--gradescope", "grades.json", code=1)
        grades = json.loads((self.folder / "grades.json").read_text())
        jsonschema.validate(grades, json.loads((HERE / "gradescope.schema.json").read_text()))
        bad, good, picture = grades["tests"]
        self.assertEqual([(t["name"], t["score"], t["max_score"]) for t in grades["tests"]],
                         [("s/bad", 0, 2), ("s/good", 3, 3), ("s/picture", 0, 1)])
        self.assertEqual((bad["visibility"], good["visibility"]), ("after_due_date", "visible"))
        self.assertIn("LEDR shows 0000000000", bad["output"])
        self.assertEqual(picture["output"].count("data:image/png;base64,"), 2)
        self.suite("s", "--classroom", "result.txt", code=1)
        line, = (self.folder / "result.txt").read_text().splitlines()
        result = json.loads(base64.b64decode(line, validate=True))
        jsonschema.validate(result, json.loads((HERE / "classroom.schema.json").read_text()))
        self.assertEqual((result["status"], result["max_score"]), ("fail", 6))
        self.assertEqual([(t["name"], t["status"], t["score"]) for t in result["tests"]],
                         [("s/bad", "fail", 0), ("s/good", "pass", 3), ("s/picture", "fail", 0)])
        self.assertIn("LEDR shows 0000000000", result["tests"][0]["message"])
        done = self.suite("s", "--gradescope", "no/such/folder.json", code=2)
        self.assertIn("no/such/folder.json", done.stderr)

    def test_rerun_failed(self):
        self.three()
        self.suite("s", code=1)
        self.scenario("s/bad")
        done = self.suite("s", "--rerun-failed")
        self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertIn("3 of 3", done.stdout)
        done = self.suite("s", "--rerun-failed")
        self.assertIn("3 of 3", done.stdout)
        self.assertEqual(done.stderr, "")

    def test_filter_and_list(self):
        self.three()
        self.assertEqual(self.suite("s", "--list").stdout.split(),
                         ["s/bad", "s/deep/good", "s/good"])
        self.assertEqual(self.suite("s", "--list", "--filter", "good").stdout.split(),
                         ["s/deep/good", "s/good"])
        self.assertEqual(self.suite("s", "--list", "--filter", "s/g*").stdout.split(), ["s/good"])
        self.assertFalse((self.folder / "test-results").exists())

    def test_fail_fast(self):
        self.scenario("s/bad", 'expect-leds: "1111111111"')
        for n in range(5):
            self.scenario(f"s/long{n}", head="duration: 2s")
        begin = time.monotonic()
        done = self.suite("s/bad.yaml", "s", "--fail-fast", "--jobs", "6", code=1)
        self.assertIn("s/bad.yaml", done.stderr)
        self.assertEqual(len(self.results()["missing"]), 5)
        self.assertIn("s/long3: has no result", done.stderr)
        self.assertLess(time.monotonic() - begin, 15)
        self.check_junit()

    def test_a_scenario_that_takes_too_long(self):
        self.scenario("s/long", head="duration: 1000s")
        done = self.suite("s", "--time-limit", "1", code=1)
        self.assertIn("s/long.yaml: it did not end within 1 s", done.stderr)

    def test_an_interruption_keeps_what_there_is(self):
        self.scenario("s/a")
        self.scenario("s/long", head="duration: 1000s")
        process = subprocess.Popen([DE1SIM, "test", "s", "--jobs", "2"], cwd=self.folder,
                                   stderr=subprocess.PIPE, text=True)
        self.assertIn("s/a", process.stderr.readline())
        process.send_signal(signal.SIGINT)
        rest = process.communicate(timeout=30)[1]
        self.assertEqual(process.returncode, 130, rest)
        self.assertEqual(self.codes(), {"s/a": 0})
        self.assertEqual(self.results()["missing"], ["s/long"])

    def test_the_program_and_the_options_are_the_scenarios(self):
        self.scenario("s/project/led", 'expect-leds: "0000000101"', head="project: .")
        (self.folder / "s/project/top.v").write_text(
            "module top(output [9:0] LEDR); assign LEDR = 5; endmodule\n")
        self.scenario("s/native", head="cpu: native\naudio-rate: 48000\nfpga-memory: bridge\n"
                                       "duration: 20ms")
        self.scenario("s/arm", head="cpu: arm\nduration: 2ms")
        done = self.suite("s", code=2)
        self.assertEqual(self.codes(), {"s/arm": 2, "s/native": 0, "s/project/led": 0})
        self.assertIn("--cpu: arm needs a program", done.stderr)
        self.assertIn('"rate_hz": 48000',
                      (self.folder / "test-results/runs/s/native/report.json").read_text())

    def test_a_program_for_nios_v_is_one_like_others(self):
        for name in ("ok", "bad"):
            self.scenario(f"s/{name}", "delay: 1ms",
                          f'expect-leds: "{"0000011110" if name == "ok" else "1111111111"}"',
                          head=f"program: {PROGRAMS}/nios_v_sums.elf")
        self.suite("s", "--trace-failure", "1100us", code=1)
        self.assertEqual(self.codes(), {"s/ok": 0, "s/bad": 1})
        self.assertIn("square <- add_squares", (
            self.folder / "test-results/runs/s/bad/failure/waves.calls.txt").read_text())

    def test_the_board_is_the_scenarios(self):
        for board in ("DE10-Lite", "DE1-SoC"):
            self.scenario(f"s/{board}", "press: {key: 2}",
                          head=f"program: {PROGRAMS}/nios_v_sums.elf\nboard: {board}")
        done = self.suite("s", code=2)
        self.assertEqual(self.codes(), {"s/DE10-Lite": 2, "s/DE1-SoC": 0})
        self.assertIn("expected a step for what the DE10-Lite has", done.stderr)

    def test_a_failure_is_traced(self):
        self.scenario("s/bad", "delay: 1ms", 'expect-leds: "1111111111"', head="")
        done = self.suite("s", "--trace-failure", "100us", code=1)
        self.assertIn("see test-results/runs/s/bad/failure/waves.fst", done.stderr)
        self.assertIn("runs/s/bad/failure/waves.fst",
                      (self.folder / "test-results/index.html").read_text())

    def test_what_cannot_be(self):
        self.scenario("s/a")
        (self.folder / "empty").mkdir()
        for message, *words in (
                ("none: expected a scenario or a folder of them, got nothing", "none"),
                ("empty: expected scenarios (.yaml) in this folder, got none", "empty"),
                ('--filter: no scenario has "x" in its name', "s", "--filter", "x"),
                ('--shard: expected I/N with I from 1 to N, got "3/2" (see de1sim --help)', "s",
                 "--shard", "3/2"),
                ("test-results/results.json: is not there", "s",
                 "--rerun-failed"),
                ("PATH is required (see de1sim --help)",)):
            done = self.suite(*words, code=2)
            self.assertEqual(done.stderr, f"de1sim: {message}\n")
        self.assertFalse((self.folder / "test-results").exists())


class Shards(Folder):
    def twelve(self):
        for n in range(12):
            steps = ['expect-leds: "1111111111"'] if n == 7 else []
            self.scenario(f"s/n{n}", *steps, head=f"duration: {1 + 10 * n}ms")

    def test_are_parts_of_about_the_same_length(self):
        self.twelve()
        parts = [self.suite("s", "--list", "--shard", f"{n}/3").stdout.split() for n in (1, 2, 3)]
        self.assertEqual(sorted(sum(parts, [])), sorted(f"s/n{n}" for n in range(12)))
        lengths = [sum(1 + 10 * int(name[3:]) for name in part) for part in parts]
        self.assertLess(max(lengths) - min(lengths), 110)

    def test_joined_are_as_if_run_here(self):
        self.twelve()
        self.suite("s", "--out", "local", code=1)
        for n in (1, 2, 3):
            self.suite("s", "--shard", f"{n}/3", "--out", f"part{n}",
                       code=1 if "s/n7" in self.suite("s", "--list", "--shard",
                                                      f"{n}/3").stdout.split() else 0)
        done = self.de1sim("merge", "part1", "part2", "part3", "--out", "merged", code=1)
        self.assertIn("11 of 12 scenarios passed", done.stdout)
        local, merged = self.results("local"), self.results("merged")
        for one in local["scenarios"] + merged["scenarios"]:
            self.assertGreater(one.pop("wall_s"), 0)
            one.pop("folder")
            one["said"] = re.sub(r"(local|part\d)/", "", one["said"])
        self.assertEqual([re.sub("in [0-9.]+ s", "", str(one)) for one in local["scenarios"]],
                         [re.sub("in [0-9.]+ s", "", str(one)) for one in merged["scenarios"]])
        self.check_junit("merged")

    def test_a_missing_one_is_reported(self):
        self.twelve()
        for n in (1, 3):
            self.suite("s", "--shard", f"{n}/3", "--out", f"part{n}",
                       code=1 if "s/n7" in self.suite("s", "--list", "--shard",
                                                      f"{n}/3").stdout.split() else 0)
        second = self.suite("s", "--list", "--shard", "2/3").stdout.split()
        done = self.de1sim("merge", "part1", "part3", "--out", "merged", code=1)
        self.assertIn("shard 2/3 is missing\n", done.stderr)
        self.assertEqual(self.results("merged")["missing"], sorted(second))

    def test_of_other_scenarios_are_refused(self):
        self.twelve()
        self.suite("s", "--filter", "n1", "--shard", "1/2", "--out", "part1")
        self.suite("s", "--filter", "n2", "--shard", "2/2", "--out", "part2")
        done = self.de1sim("merge", "part1", "part2", code=2)
        self.assertIn("part2: expected a part of the same scenarios as in part1, got others",
                      done.stderr)


run()
