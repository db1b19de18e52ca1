"""trace_test.py DE1SIM COUNTER DEMO FOLDER [CASE...] - traces of a part, and of a failure

COUNTER and DEMO are ELFs: key_counter and the demo.
"""
import collections
import json
import pathlib
import re
import shutil
import subprocess
import sys
import unittest

DE1SIM, COUNTER, DEMO, FOLDER = *sys.argv[1:4], pathlib.Path(sys.argv[4])
MB = 1 << 20
FAILS = """name: fails
version: 1
steps:
  - wait-serial: ready
  - press: {keypad: "1", for: 80ms}
  - delay: 20ms
  - expect-hex: "    77"
  - delay: 50ms
"""
KEY = """name: a key
version: 1
steps:
  - delay: 1ms
  - press: {key: 0, for: 10ms}
"""


def changes(fst):
    """Of each signal that was traced, by its path: [(picoseconds, value), ...]."""
    text = subprocess.run(["fst2vcd", fst], capture_output=True, text=True, check=True).stdout
    scope, paths, moves, now = [], collections.defaultdict(list), collections.defaultdict(list), 0
    for line in text.splitlines():
        words = line.split()
        if line.startswith("$scope"):
            scope.append(words[2])
        elif line.startswith("$upscope"):
            scope.pop()
        elif line.startswith("$var"):
            paths[words[3]].append(".".join(scope + [words[4]]))
        elif line.startswith("#"):
            now = int(line[1:])
        elif line[:1] == "b":
            moves[words[1]].append((now, words[0][1:]))
        elif line[:1] in ("0", "1", "x", "z"):
            moves[line[1:]].append((now, line[0]))
    return {path: moves[key] for key, all in paths.items() for path in all}


def span(fst):
    """When the first and the last signal moves, in seconds."""
    lines = subprocess.run(["sh", "-c", "fst2vcd \"$1\" | grep '^#' | sed -n '1p;$p'", "sh", fst],
                           capture_output=True, text=True, check=True).stdout.split()
    return [int(line[1:]) * 1e-12 for line in lines]


def times(lines):
    return [float(line.split()[0]) for line in lines.splitlines() if not line.startswith("#")]


class Trace(unittest.TestCase):
    def setUp(self):
        self.folder = FOLDER / self.id().split(".")[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def run_(self, scenario, *words):
        (self.folder / "s.yaml").write_text(scenario)
        return subprocess.run([DE1SIM, "run", "s.yaml", "--quiet", *words], cwd=self.folder,
                              capture_output=True, text=True)

    def read(self, name):
        return (self.folder / name).read_text()

    def report(self, out="out"):
        report = json.loads(self.read(f"{out}/report.json"))
        del report["wall"]
        return report

    def missed(self):
        [missed] = [e for e in self.report()["expectations"] if not e["met"]]
        return missed

    def test_a_part_has_what_the_whole_has_at_that_time(self):
        """The clocks before it were left out, and that is not seen."""
        words = ("--elf", COUNTER, "--duration", "1100us", "--trace")
        self.run_(KEY, *words, "whole.fst", "--out", "whole")
        self.run_(KEY, *words, "part.fst", "--trace-from", "950us", "--trace-to", "1050us",
                  "--out", "part")
        self.assertEqual(self.report("whole"), self.report("part"))
        whole, part = changes(self.folder / "whole.fst"), changes(self.folder / "part.fst")
        self.assertEqual(set(whole), set(part))
        begin, end = 950_000_000, 1_050_000_000
        self.assertAlmostEqual(len(part["TOP.clk_i"]), 5000, delta=2)
        self.assertGreater(len(part["TOP.key_ni"]), 1)  # the key goes down
        for path, moves in part.items():
            self.assertLessEqual(moves[-1][0], end)
            self.assertGreaterEqual(moves[0][0], begin)
            at_begin = max((move for move in whole[path] if move[0] <= moves[0][0]),
                           key=lambda move: move[0])
            self.assertEqual(moves[0][1], at_begin[1], path)
            self.assertEqual(moves[1:], [m for m in whole[path] if moves[0][0] < m[0] <= end], path)

    def test_a_failure_is_run_again(self):
        done = self.run_(FAILS, "--trace-failure", "20ms")
        self.assertEqual(done.returncode, 1, done.stderr)
        failed = self.missed()
        end = failed["time_s"]
        self.assertRegex(failed["detail"],
                         r'HEX shows ".*"; see out/failure/waves.fst, out/failure/waves.bus.txt$')
        self.assertIn("out/failure/waves.fst", done.stderr)
        self.assertIn("out/failure/waves.fst", self.read("out/junit.xml"))
        fst = self.folder / "out/failure/waves.fst"
        self.assertLess(fst.stat().st_size, 5 * MB)
        for found, expected in zip(span(fst), (end - 0.02, end)):
            self.assertAlmostEqual(found, expected, delta=1e-7)
        bus = self.read("out/failure/waves.bus.txt")
        self.assertGreater(len(times(bus)), 100)
        self.assertGreaterEqual(min(times(bus)), end - 0.02)
        self.assertLessEqual(max(times(bus)), end)
        self.assertIn(" AUDIO_FIFOSPACE ", bus)
        # The first run's own files are as without.
        self.run_(FAILS, "--out", "plain")
        plain, again = self.report("plain"), self.report()
        del plain["expectations"], again["expectations"]
        self.assertEqual(plain, again)

    def test_a_failed_program_leaves_its_calls(self):
        done = self.run_(FAILS, "--elf", DEMO, "--trace-failure", "2ms")
        self.assertIn("out/failure/waves.calls.txt", done.stderr)
        end = self.missed()["time_s"]
        calls, bus = (self.read(f"out/failure/waves.{name}.txt") for name in ("calls", "bus"))
        self.assertLessEqual(max(times(calls)), end)
        self.assertEqual(times(calls), sorted(times(calls)))
        self.assertLessEqual(len(times(calls)), 1000)
        self.assertEqual(len(times(calls)), 1000)
        self.assertRegex(calls, r"(?m)^0\.\d{9}  +app::Mixer::add.* <- app::Mixer::mix")
        self.assertTrue(all(end - 0.002 <= time <= end for time in times(bus)), bus)

    def test_a_run_that_passes_is_not_run_again(self):
        done = self.run_(FAILS.replace('"    77"', '"     1"'), "--trace-failure", "20ms")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertFalse((self.folder / "out/failure").exists())

    def test_a_projects_failure(self):
        (self.folder / "top.v").write_text(
            "module top(input CLOCK_50, output [9:0] LEDR); reg [9:0] n;\n"
            "always @(posedge CLOCK_50) n <= n + 1; assign LEDR = 0; endmodule\n")
        done = self.run_('name: x\nversion: 1\nsteps:\n  - delay: 3ms\n'
                         '  - expect-leds: "1111111111"\n', "--project", ".",
                         "--trace-failure", "100us")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(self.report()["expectations"][0]["detail"],
                         r"; see out/failure/waves.fst$")
        [count] = [moves for path, moves in changes(self.folder / "out/failure/waves.fst").items()
                   if re.search(r"\.n$", path)]
        self.assertAlmostEqual(count[0][0] * 1e-12, 2.9e-3, delta=1e-7)
        self.assertAlmostEqual(count[-1][0] * 1e-12, 3e-3, delta=1e-7)
        self.assertAlmostEqual(len(count), 5000, delta=2)

    def test_what_cannot_be(self):
        for message, *words in (
                ("--trace-from: needs --trace FILE", "--trace-from", "1ms"),
                ("--trace-to: needs --trace FILE", "--trace-to", "1ms"),
                ("--trace-to: expected a time after --trace-from", "--trace", "x.fst",
                 "--trace-from", "2ms", "--trace-to", "2ms"),
                ('--trace-from: expected a time such as 500ms or 10s, got "2"', "--trace-from",
                 "2"),
                ("--trace-failure: and --trace exclude each other", "--trace-failure", "1ms",
                 "--trace", "x.fst")):
            done = self.run_(FAILS, *words)
            self.assertEqual((done.returncode, done.stderr),
                             (2, f"de1sim: {message} (see de1sim --help)\n"))
            self.assertEqual([p.name for p in self.folder.iterdir()], ["s.yaml"])

    def test_a_second_run_that_fails_says_why(self):
        (self.folder / "out/failure").mkdir(parents=True)
        (self.folder / "out/failure/audio.wav").mkdir()
        (self.folder / "out/failure/audio.wav/x").write_text("in the way")
        done = self.run_(FAILS, "--trace-failure", "20ms")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, "; no waveforms: de1sim: .*audio.wav")


unittest.main(argv=sys.argv[:1] + sys.argv[5:])
