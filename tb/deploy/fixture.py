"""fixture.py - what the tests of deployment share: versions to deploy, and what a board must be."""
import hashlib
import os
import pathlib
import shutil
import subprocess
import time
import unittest

from standin import StandIn, text

SOURCE = pathlib.Path(__file__).resolve().parents[2]
DEPLOY = SOURCE / "sw/deploy/deploy.sh"
SCRATCH = pathlib.Path(os.environ["SCRATCH"])
BUILD = os.environ.get("BUILD", str(SOURCE / "build"))

PROGRAM = """#!/bin/sh
# collide-linux of NAME, for the register map MAP
read -r map version <"$DE1SIM_ROOT/fpga"
if [ "$map" != "MAP" ]; then
    echo "collide-linux: system ID of map \\"$map\\": expected MAP" >&2
    exit 1
fi
if [ "$1" = --check ]; then
    echo "system ID ok: $map of $version"
    exit 0
fi
END
echo NAME >"$DE1SIM_ROOT/running"
echo "NAME runs"
while :; do sleep 9; done
"""


class DeployTest(unittest.TestCase):
    def setUp(self):
        self.folder = SCRATCH / self._testMethodName
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        self.board = None
        self.new_board()

    def tearDown(self):
        self.board.stop()
        self.assertEqual(self.board.complaints, [])

    def new_board(self, **options):
        if self.board:
            self.board.stop()
            shutil.rmtree(self.board.folder)
        self.board = StandIn(self.folder / "board", **options)

    # ---- What is deployed ----

    def version(self, name, start="map1", program_map="map1", ends=False):
        """The environment that makes deploy.sh deploy it."""
        rbf = self.folder / f"{name}.rbf"
        rbf.write_bytes(f"{start} {name}\n".encode().ljust(200_000, b"\0"))
        program = self.folder / f"{name}-linux"
        script = PROGRAM.replace("MAP", program_map).replace("NAME", name)
        program.write_text(script.replace("END", "exit 1" if ends else ""))
        return {"RBF": str(rbf), "FIRMWARE": str(program)}

    def start(self, action, version, **environment):
        values = {"HOME": str(self.folder), "PATH": os.environ["PATH"], "BOARD": "board",
                  "BUILD": BUILD, "SSH_CONFIG": str(self.board.ssh / "config"),
                  **version, **environment}
        return subprocess.Popen([DEPLOY, *action.split()], env=values, text=True,
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, start_new_session=True)

    def run_script(self, action, version=None, at_line=None, **environment):
        """Sets self.code and self.lines; calls at_line() after each line."""
        process = self.start(action, version or {}, **environment)
        self.lines = []
        for line in process.stdout:
            self.lines.append(line.rstrip("\n"))
            if at_line:
                at_line()
        process.stdout.close()
        self.code = process.wait()
        return self.code

    def deploy(self, version, **more):
        return self.run_script("deploy", version, **more)

    # ---- What must be ----

    def said(self):
        return "\n".join(self.lines)

    def assert_says(self, part):
        self.assertIn(part, self.said())

    def installed(self):
        """The name of the version that `current` points to, after checking its sums; or None."""
        current = self.board.root / "opt/de1sim/current"
        if not current.is_symlink():
            return None
        for line in text(current / "SHA256SUMS").splitlines():
            digest, name = line.split()
            self.assertEqual(hashlib.sha256((current / name).read_bytes()).hexdigest(), digest)
        return (current / "de1_soc.rbf").read_bytes().split(b"\n")[0].split()[1].decode()

    def assert_works(self, *names):
        """One of these versions is current and loaded, the bridges are on, and its program runs."""
        self.board.wait_for_rest()
        name = self.installed()
        self.assertIn(name, names, self.said())
        self.assertEqual(self.board.fpga.read_bytes(),
                         (self.board.root / "opt/de1sim/current/de1_soc.rbf").read_bytes())
        self.assertEqual(text(self.board.state), self.board.good)
        self.assertTrue(self.board.bridges_are_on())
        deadline = time.monotonic() + 5
        while text(self.board.root / "running") != name and time.monotonic() < deadline:
            time.sleep(0.02)
        self.assertEqual(text(self.board.root / "running"), name, self.said())
        return name

    def assert_untouched(self):
        self.assertFalse((self.board.root / "opt/de1sim").exists())
        self.assertEqual(self.board.fpga.read_bytes(), b"")

    def good_a(self):
        """A board that runs version A."""
        self.assertEqual(self.deploy(self.version("A")), 0, self.said())
        self.assert_works("A")
