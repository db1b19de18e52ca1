"""suite_test.py - faults of `de1sim test`; the table is in tb/README.md."""
import json
import resource
import shutil
import signal
import subprocess
import time

from faults import (DE1SIM, FAILED, Faults, INTERRUPTED, MIB, PASSED, WRONG, has_not_begun,
                    is_whole, limited, new_files, processes_in, run)


class Suite(Faults):
    def setUp(self):
        super().setUp()
        for name in "abc":
            self.steps("40ms", name)

    def command(self):
        return [DE1SIM, "test", "a.yaml", "b.yaml", "c.yaml", "--out", self.out, "--jobs", "2"]

    def de1sim(self, limits=None, under=(), env=None):
        shutil.rmtree(self.out, ignore_errors=True)
        return subprocess.run([*under, *self.command()], cwd=self.folder, text=True, env=env,
                              capture_output=True, timeout=300, preexec_fn=limited(limits or {}))

    def ends_well(self, done, note):
        """It has ended by itself, and has said what went wrong."""
        self.assertIn(done.returncode, (FAILED, WRONG), f"{note}: {done.stdout}{done.stderr}")
        self.assertRegex(done.stdout + done.stderr, r"(?m)^(de1sim: |FAILED)", note)
        self.assertNotIn("terminate", done.stderr, note)
        self.all_whole(note)

    def test_a_disk_that_is_full_at_any_of_the_files(self):
        self.assertEqual(self.de1sim().returncode, PASSED)
        names = "results.json", "junit.xml", "index.html"
        for name, size in [(name, (self.out / name).stat().st_size) for name in names]:
            most = size - 1
            with self.subTest(file=name):
                done = self.de1sim({resource.RLIMIT_FSIZE: most})
                self.ends_well(done, f"no file over {most} bytes")
                self.assertEqual(done.returncode, WRONG)
                self.assertIn("File too large", done.stdout + done.stderr)

    def test_a_disk_without_inodes(self):
        for count in range(60):
            done = self.de1sim(env=new_files(count, self.folder))
            if done.returncode == PASSED:
                break
            self.ends_well(done, f"{count} new files")
            self.assertIn("No space left", done.stdout + done.stderr)
        self.assertGreater(count, 3)
        self.assertEqual(done.returncode, PASSED)

    def test_a_folder_that_cannot_be_written_to(self):
        (self.folder / "file").write_text("x")
        for out in self.folder / "file", self.folder / "file" / "out", "/proc/de1sim":
            self.out = out
            done = subprocess.run(self.command(), cwd=self.folder, text=True, capture_output=True,
                                  timeout=60)
            self.assertEqual((done.returncode, done.stdout), (WRONG, ""), done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertIn(str(out), done.stderr)
        self.assertEqual((self.folder / "file").read_text(), "x")

    def test_ended_by_a_signal_at_any_time(self):
        """At once, when the first run begins, and from then on to after the last."""
        for name in "abc":
            self.steps("80ms", name)
        begin = time.monotonic()
        self.assertEqual(self.de1sim().returncode, PASSED)
        whole_s = time.monotonic() - begin
        seen = set()
        for sent in signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGKILL:
            for part in range(6):
                shutil.rmtree(self.out, ignore_errors=True)
                process = subprocess.Popen(self.command(), cwd=self.folder, text=True,
                                           stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
                while part and process.poll() is None and not (self.out / "runs").exists():
                    time.sleep(0.005)
                time.sleep(whole_s * max(part - 1, 0) / 4)
                process.send_signal(sent)
                said = process.communicate(timeout=60)[1]
                note = f"{sent.name} at time {part} of 5"
                at_once = part == 0 or sent == signal.SIGKILL
                self.assertIn(process.returncode,
                              (PASSED, INTERRUPTED, *((-sent,) if at_once else ())),
                              f"{note}: {said}")
                seen.add(process.returncode)
                end = time.monotonic() + 20
                while processes_in(self.folder) and time.monotonic() < end:
                    time.sleep(0.02)
                self.assertEqual(processes_in(self.folder), [], f"{note}: runs are left")
                self.all_whole(note, also=(".part",))
                if process.returncode == INTERRUPTED:
                    results = json.loads((self.out / "results.json").read_text())
                    self.assertEqual(len(results["scenarios"]) + len(results["missing"]), 3)
        self.assertTrue({INTERRUPTED, -signal.SIGKILL} <= seen, seen)
        self.assertEqual(self.de1sim().returncode, PASSED)  # the folder is free

    def test_two_at_once_in_one_folder(self):
        for name in "abc":
            self.steps("2s", name)
        first = subprocess.Popen(self.command(), cwd=self.folder, stdout=subprocess.DEVNULL)
        try:
            while not (self.out / "runs").exists():
                time.sleep(0.01)
            second = subprocess.run(self.command(), cwd=self.folder, text=True, timeout=60,
                                    capture_output=True)
            self.assertEqual(second.returncode, WRONG, second.stderr)
            self.assertIn(str(first.pid), second.stderr)
            self.assertEqual(len(second.stderr.splitlines()), 1, second.stderr)
        finally:
            first.send_signal(signal.SIGINT)
            self.assertEqual(first.wait(60), INTERRUPTED)

    def test_too_few_descriptors(self):
        refused = 0
        for count in (*range(3, 24), 40):
            done = self.de1sim({resource.RLIMIT_NOFILE: count})
            if has_not_begun(done.stderr):
                continue
            if done.returncode != PASSED:
                self.ends_well(done, f"{count} descriptors")
                refused += 1
        self.assertGreater(refused, 0)
        self.assertEqual(done.returncode, PASSED, done.stderr)

    def test_too_little_memory(self):
        codes = set()
        for mib in 60, 100, 200, 400, 800, 1320, 6000:
            done = self.de1sim({resource.RLIMIT_AS: mib * MIB})
            if has_not_begun(done.stderr):
                continue
            if done.returncode != PASSED:
                self.ends_well(done, f"{mib} MiB")
                self.assertIn("memory", done.stdout + done.stderr)
            codes.add(done.returncode)
        self.assertEqual(codes, {PASSED, WRONG})

    def test_a_clock_that_is_set_back(self):
        done = self.de1sim(under=("faketime", "-f", "-1d x-86400"))
        self.assertEqual(done.returncode, PASSED, done.stderr)
        self.all_whole("faketime")
        for path in self.out.rglob("*.json"):
            self.assertTrue(is_whole(path), path)


run()
