"""faults.py - what de1sim leaves behind whatever becomes of it.

A file of cases imports it, and ends with run(): NAME_test.py DE1SIM FOLDER NO_INODES [CASE...].
NO_INODES is the library of no_inodes.cpp.
"""
import json
import os
import pathlib
import resource
import shutil
import struct
import subprocess
import sys
import unittest
import xml.etree.ElementTree

DE1SIM, FOLDER, NO_INODES = sys.argv[1], *map(pathlib.Path, sys.argv[2:4])
PASSED, FAILED, WRONG, INTERRUPTED = 0, 1, 2, 130
STEPS = ("name: {name}\nversion: 1\nduration: {duration}\nsteps:\n  - wait-serial: ready\n"
         "  - press: {{keypad: [\"1\", \"2\"], for: 20ms}}\n")
MIB = 1 << 20


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


def limited(limits):
    """For preexec_fn; {resource: most}."""
    def limit():
        for what, most in limits.items():
            resource.setrlimit(what, (most, most))
    return limit


def new_files(count, folder):
    """The environment in which so many files and folders can be made and no more.

    For a program that runs in this folder: LD_PRELOAD takes no path with a blank.
    """
    shutil.copy(NO_INODES, folder / "no_inodes.so")
    return {**os.environ, "LD_PRELOAD": "./no_inodes.so", "NEW_FILES": str(count)}


def has_not_begun(said):
    """The loader had no room for de1sim's libraries."""
    return "shared librar" in said or "cannot be preloaded" in said


def processes_in(folder):
    """Processes other than this one that work in the folder, or have a file in it open."""
    found = set()
    for process in filter(str.isdigit, os.listdir("/proc")):
        try:
            for link in ["cwd", *(f"fd/{n}" for n in os.listdir(f"/proc/{process}/fd"))]:
                file = pathlib.Path(os.readlink(f"/proc/{process}/{link}"))
                if file.is_relative_to(folder.resolve()):
                    found.add(int(process))
        except OSError:  # it has just ended, or is not ours
            pass
    return sorted(found - {os.getpid()})


class Faults(unittest.TestCase):
    def setUp(self):
        self.folder = FOLDER / self.id().split(".")[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        self.out = self.folder / "out"

    def steps(self, duration, name="s"):
        (self.folder / f"{name}.yaml").write_text(STEPS.format(name=name, duration=duration))

    def files(self):
        return {path.relative_to(self.out): path for path in self.out.rglob("*") if path.is_file()
                and path.name != ".lock"}

    def all_whole(self, note, also=()):
        """`also`: a suffix that may be there, of a file that was cut off."""
        for name, path in self.files().items():
            if path.suffix in also:
                continue
            self.assertNotEqual(path.suffix, ".part", f"{name}, {note}")
            self.assertTrue(is_whole(path), f"{name} is not whole, {note}")

    def in_one_line(self, done, note):
        self.assertEqual(done.returncode, WRONG, f"{note}: {done.stdout}{done.stderr}")
        self.assertEqual(len(done.stderr.splitlines()), 1, f"{note}: {done.stderr}")
        self.assertTrue(done.stderr.startswith("de1sim: "), f"{note}: {done.stderr}")
        self.all_whole(note)


def run():
    unittest.main(module="__main__", argv=sys.argv[:1] + sys.argv[4:])
