"""folder.py - scenarios in a folder of their own, and what `de1sim test` makes of them.

A file of cases imports it, and ends with run(): NAME_test.py DE1SIM FOLDER [CASE...]
"""
import json
import pathlib
import shutil
import struct
import subprocess
import sys
import unittest
import zlib

DE1SIM, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
HERE = pathlib.Path(__file__).parent


def black_png(path, width=640, height=480):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(
            ">I", zlib.crc32(kind + data))

    rows = (b"\0" + bytes(3 * width)) * height
    path.write_bytes(b"\x89PNG\r\n\x1a\n" +
                     chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class Folder(unittest.TestCase):
    def setUp(self):
        self.folder = FOLDER / self.id().split(".")[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def scenario(self, name, *steps, head="duration: 2ms"):
        path = self.folder / f"{name}.yaml"
        path.parent.mkdir(parents=True, exist_ok=True)
        lines = "".join(f"  - {step}\n" for step in steps)
        text = f"name: {name}\nversion: 1\n{head}\n"
        path.write_text(text + f"steps:\n{lines}" if lines else text)

    def three(self):
        """Two that pass, in two folders, and one that fails."""
        self.scenario("s/good")
        self.scenario("s/deep/good", 'expect-leds: "0000000000"')
        self.scenario("s/bad", 'expect-leds: "1111111111"')

    def de1sim(self, *words, code=0):
        done = subprocess.run([DE1SIM, *words], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def suite(self, *words, code=0):
        return self.de1sim("test", *words, code=code)

    def results(self, out="test-results"):
        return json.loads((self.folder / out / "results.json").read_text())

    def codes(self, out="test-results"):
        return {one["name"]: one["exit_code"] for one in self.results(out)["scenarios"]}

    def check_junit(self, out="test-results"):
        subprocess.run(["xmllint", "--noout", "--schema", HERE / "junit.xsd",
                        self.folder / out / "junit.xml"], check=True, capture_output=True)


def run():
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
