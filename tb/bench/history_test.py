"""history_test.py FOLDER - the benchmarks' history, with a command that prints what they print."""
import json
import pathlib
import shutil
import subprocess
import sys
import time
import unittest

HERE, FOLDER = pathlib.Path(__file__).parent, pathlib.Path(sys.argv[1])
DAY_S = 24 * 3600


class History(unittest.TestCase):
    def setUp(self):
        self.folder = FOLDER / self.id().split(".")[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def keep(self, *days_and_ratios):
        lines = [json.dumps({"time": time.time() - days * DAY_S, "ratios": {"demo, arm": ratio}})
                 for days, ratio in days_and_ratios]
        (self.folder / "history.jsonl").write_text("\n".join(lines) + "\n")

    def bench(self, ratio, code=0):
        said = f"real time\\n  demo, arm      90.1 frames/s, 1.51 x real time; {ratio} of it (x)\\n"
        return subprocess.run([sys.executable, "-B", HERE / "history.py", self.folder, "--", "sh",
                               "-c", f"printf '{said}'; exit {code}"], capture_output=True,
                              text=True)

    def test_the_first_run_is_kept_and_drawn(self):
        done = self.bench(0.5)
        self.assertEqual(done.returncode, 0, done.stderr)
        (line,) = (self.folder / "history.jsonl").read_text().splitlines()
        self.assertEqual(json.loads(line)["ratios"], {"demo, arm": 0.5})
        self.assertIn("demo, arm", (self.folder / "history.svg").read_text())

    def test_what_is_slower_than_a_week_before_is_reported(self):
        self.keep((30, 0.9), (7.2, 0.50), (7, 0.52), (6.8, 0.1), (1, 0.9))
        self.assertEqual(self.bench(0.46).returncode, 0)
        done = self.bench(0.44)
        self.assertEqual(done.returncode, 1)
        self.assertIn("slower than last week: demo, arm: 0.44, last week 0.50", done.stdout)

    def test_a_command_that_fails_or_says_nothing(self):
        self.assertEqual(self.bench(0.5, code=1).returncode, 1)
        done = subprocess.run([sys.executable, "-B", HERE / "history.py", self.folder, "--",
                               "true"], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr),
                         (1, "history.py: the command has printed no ratio\n"))


unittest.main(argv=sys.argv[:1])
