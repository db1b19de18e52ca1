"""faults_test.py DE1SIM FOLDER [CASE...] - what a run leaves behind whatever becomes of it.

Each file is whole or not there, and what went wrong is said in one line: the table
in tb/README.md.
"""
import json
import pathlib
import resource
import shutil
import signal
import struct
import subprocess
import sys
import time
import unittest
import xml.etree.ElementTree

DE1SIM, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
STEPS = ("name: s\nversion: 1\nduration: {}\nsteps:\n  - wait-serial: ready\n"
         "  - press: {{keypad: [\"1\", \"2\"], for: 20ms}}\n")
PASSED, WRONG, INTERRUPTED = 0, 2, 130


def is_whole(path):
    """Whether a file of a run can be read to its end by others."""
    data = path.read_bytes()
    if path.suffix == ".png":
        return data.startswith(b"\x89PNG\r\n\x1a\n") and data.endswith(b"IEND\xaeB`\x82")
    if path.suffix == ".wav":
        return struct.unpack("<I", data[4:8])[0] == len(data) - 8
    if path.suffix == ".json":
        return json.loads(data)["format"] > 0
    if path.suffix == ".xml":
        return xml.etree.ElementTree.fromstring(data).tag == "testsuites"
    if path.suffix == ".html":
        return data.rstrip().endswith(b"</html>")
    if path.suffix == ".webm":
        return subprocess.run(["ffmpeg", "-v", "error", "-xerror", "-i", path, "-f", "null", "-"],
                              stdin=subprocess.DEVNULL, capture_output=True).returncode == 0
    if path.suffix == ".fst":
        return subprocess.run(["fst2vcd", path], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL).returncode == 0
    return path.suffix == ".txt"


class Faults(unittest.TestCase):
    def setUp(self):
        self.folder = FOLDER / self.id().split(".")[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        self.out = self.folder / "out"
        self.steps("100ms")

    def steps(self, duration):
        (self.folder / "s.yaml").write_text(STEPS.format(duration))

    def command(self, *words):
        return [DE1SIM, "run", "s.yaml", "--quiet", *(words or ("--frames", "all"))]

    def de1sim(self, *words, limits=None, under=()):
        """`limits`: {resource: most}; `under`: a command that starts it."""
        shutil.rmtree(self.out, ignore_errors=True)

        def limit():
            for what, most in (limits or {}).items():
                resource.setrlimit(what, (most, most))
        return subprocess.run([*under, *self.command(*words)], cwd=self.folder, text=True,
                              capture_output=True, timeout=300, preexec_fn=limit)

    def files(self):
        return {path.relative_to(self.out): path for path in self.out.rglob("*") if path.is_file()
                and path.name != ".lock"}

    def all_whole(self, note):
        for name, path in self.files().items():
            self.assertNotEqual(path.suffix, ".part", f"{name}, {note}")
            self.assertTrue(is_whole(path), f"{name} is not whole, {note}")

    def in_one_line(self, done, note):
        self.assertEqual(done.returncode, WRONG, f"{note}: {done.stdout}{done.stderr}")
        self.assertEqual(len(done.stderr.splitlines()), 1, f"{note}: {done.stderr}")
        self.assertTrue(done.stderr.startswith("de1sim: "), f"{note}: {done.stderr}")
        self.all_whole(note)

    def test_a_disk_that_is_full_at_any_of_the_files(self):
        """No file may grow to the length that one of them has, for each in turn."""
        more = ("--frames", "all", "--html", "out/page.html", "--video", "out/film.webm",
                "--trace", "out/waves.fst")
        self.steps("25ms")
        done = self.de1sim(*more)
        self.assertEqual(done.returncode, PASSED, done.stderr)
        sizes = {name: path.stat().st_size for name, path in self.files().items()}
        self.assertTrue({"page.html", "film.webm", "waves.fst", "audio.wav", "console.txt",
                         "report.json", "junit.xml"} <= {str(name) for name in sizes}, sizes)
        for name, size in sorted(sizes.items(), key=lambda item: -item[1]):
            if name.parent == pathlib.Path("frames") and name.name > "frame_000002":
                continue
            with self.subTest(file=name):
                most = size * 9 // 10 if name.suffix == ".fst" else size - 1  # its size varies
                done = self.de1sim(*more, limits={resource.RLIMIT_FSIZE: most})
                self.in_one_line(done, f"no file over {most} bytes")
                large = [other for other, bytes_ in sizes.items() if bytes_ >= size * 0.98]
                self.assertTrue(any(other.name in done.stderr for other in large), done.stderr)
                self.assertNotIn(name, self.files())

    def test_a_folder_that_cannot_be_written_to(self):
        (self.folder / "file").write_text("x")
        for out in "file", "file/out", "/proc/de1sim":
            done = self.de1sim("--out", out)
            self.in_one_line(done, out)
            self.assertIn(out, done.stderr)
        self.assertEqual((self.folder / "file").read_text(), "x")

    def test_ended_by_a_signal_at_any_time(self):
        """From the program's first millisecond on to behind its last."""
        self.steps("300ms")
        begin = time.monotonic()
        self.assertEqual(self.de1sim().returncode, PASSED)
        whole_s = time.monotonic() - begin
        seen = set()
        for sent in signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGKILL:
            for part in range(12):
                shutil.rmtree(self.out, ignore_errors=True)
                process = subprocess.Popen(self.command(), cwd=self.folder, text=True,
                                           stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
                time.sleep(whole_s * part / 11)
                process.send_signal(sent)
                said = process.communicate(timeout=60)[1]
                note = f"{sent.name} after {part}/11 of the run"
                self.assertIn(process.returncode, (PASSED, INTERRUPTED, -sent), f"{note}: {said}")
                seen.add(process.returncode)
                if sent != signal.SIGKILL:
                    self.all_whole(note)
                    if process.returncode == INTERRUPTED:
                        report = json.loads((self.out / "report.json").read_text())
                        self.assertEqual(report["end"], "interrupted")
                else:
                    for name, path in self.files().items():
                        self.assertTrue(path.suffix == ".part" or is_whole(path), f"{name}, {note}")
        self.assertTrue({INTERRUPTED, -signal.SIGKILL} <= seen, seen)

    def test_too_few_descriptors(self):
        refused = 0
        for count in (*range(3, 24), 32):
            done = self.de1sim("--frames", "last", limits={resource.RLIMIT_NOFILE: count})
            if "shared librar" in done.stderr:  # it has not begun
                continue
            if done.returncode != PASSED:
                self.in_one_line(done, f"{count} descriptors")
                refused += 1
        self.assertGreater(refused, 0)
        self.assertEqual(done.returncode, PASSED, done.stderr)

    def test_too_little_memory(self):
        codes = set()
        for mib in 60, 120, 240, 480, 720, 960, 1200, 1320, 1500, 6000:
            done = self.de1sim("--frames", "last", limits={resource.RLIMIT_AS: mib << 20})
            if "shared librar" in done.stderr:
                continue
            if done.returncode != PASSED:
                self.in_one_line(done, f"{mib} MiB")
                self.assertIn("memory", done.stderr)
            codes.add(done.returncode)
        self.assertEqual(codes, {PASSED, WRONG})

    def test_a_clock_that_is_set_back(self):
        """By a day a second, with libfaketime."""
        done = self.de1sim(under=("faketime", "-f", "-1d x-86400"))
        self.assertEqual(done.returncode, PASSED, done.stderr)
        self.all_whole("faketime")


unittest.main(argv=sys.argv[:1] + sys.argv[3:])
