"""run_test.py - faults of `de1sim run`; the table is in tb/README.md."""
import json
import pathlib
import resource
import shutil
import signal
import subprocess
import time

from faults import (DE1SIM, Faults, INTERRUPTED, MIB, PASSED, WRONG, has_not_begun, is_whole,
                    limited, new_files, run)


class Run(Faults):
    def setUp(self):
        super().setUp()
        self.steps("100ms")

    def command(self, *words):
        return [DE1SIM, "run", "s.yaml", "--quiet", *(words or ("--frames", "all"))]

    def de1sim(self, *words, limits=None, under=(), env=None):
        """`limits`: {resource: most}; `under`: a command that starts it."""
        shutil.rmtree(self.out, ignore_errors=True)
        return subprocess.run([*under, *self.command(*words)], cwd=self.folder, text=True, env=env,
                              capture_output=True, timeout=300, preexec_fn=limited(limits or {}))

    def test_a_disk_that_is_full_at_any_of_the_files(self):
        """No file may grow to the length that one of them has, for each in turn."""
        more = ("--frames", "all", "--html", "out/page.html", "--video", "out/film.webm",
                "--trace", "out/waves.fst", "--trace-to", "3ms")
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
        """From the program's first millisecond on to after its last."""
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
        self.steps("25ms")
        refused = 0
        for count in (*range(3, 24), 32):
            done = self.de1sim("--frames", "last", limits={resource.RLIMIT_NOFILE: count})
            if has_not_begun(done.stderr):
                continue
            if done.returncode != PASSED:
                self.in_one_line(done, f"{count} descriptors")
                refused += 1
        self.assertGreater(refused, 0)
        self.assertEqual(done.returncode, PASSED, done.stderr)

    def test_too_little_memory(self):
        codes = set()
        for mib in 60, 120, 240, 480, 720, 960, 1200, 1320, 1500, 6000:
            done = self.de1sim("--frames", "last", limits={resource.RLIMIT_AS: mib * MIB})
            if has_not_begun(done.stderr):
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

    def test_a_disk_without_inodes(self):
        """For so many new files there is room, then for none; each run gets a little further."""
        for count in range(40):
            done = self.de1sim("--frames", "last", "--html", "out/page.html",
                               env=new_files(count, self.folder))
            if done.returncode == PASSED:
                break
            self.in_one_line(done, f"{count} new files")
            self.assertIn("No space left", done.stderr)
        self.assertGreater(count, 5)
        self.assertEqual(done.returncode, PASSED)


run()
