"""package_test.py CPACK_CONFIG WORK - the Debian package in a system with only its dependencies

Its dependencies suffice, an example plays there, and when it is removed nothing of it is left.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

import bare_root

CONFIG = sys.argv[1]
WORK = pathlib.Path(sys.argv[2])
PATH = "PATH=/usr/sbin:/usr/bin:/sbin:/bin"


def field(deb, name):
    return subprocess.check_output(["dpkg-deb", "-f", deb, name], text=True).strip()


def files(root):
    return {path.relative_to(root) for path in root.rglob("*")
            if not path.is_relative_to(root / "var/lib/dpkg")
            and not path.is_relative_to(root / "var/log")}


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(WORK, ignore_errors=True)
        WORK.mkdir(parents=True)
        subprocess.run(["cpack", "--config", CONFIG, "-B", WORK / "deb"], check=True,
                       stdout=subprocess.DEVNULL)
        cls.deb, = (WORK / "deb").glob("*.deb")
        cls.root = WORK / "root"
        bare_root.make(cls.root, field(cls.deb, "Depends"))
        shutil.copy2(cls.deb, cls.root / "de1sim.deb")
        subprocess.run(["ldconfig", "-r", cls.root], check=True)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.root)

    def inside(self, *command, passes=True):
        # Without root it becomes root in a user namespace.
        become = [] if os.geteuid() == 0 else ["unshare", "--map-root-user"]
        done = subprocess.run([*become, "chroot", self.root, "/usr/bin/env", "-i", PATH, *command],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if passes:
            self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    def test_installs_plays_an_example_and_leaves_no_trace(self):
        before = files(self.root)
        self.inside("dpkg", "-i", "/de1sim.deb")
        self.assertRegex(self.inside("de1sim", "--version"),
                         rf"^de1sim {field(self.deb, 'Version')} \(")
        self.inside("cp", "-r", "/usr/share/de1sim/examples", "/tmp/my examples")
        self.inside("de1sim", "run", "/tmp/my examples/first_led/first_led.yaml",
                    "--out", "/tmp/out", "--quiet")
        report = json.loads((self.root / "tmp/out/report.json").read_text())
        self.assertTrue(report["passed"])
        self.inside("rm", "-r", "/tmp/my examples", "/tmp/out")
        self.inside("dpkg", "--purge", "de1sim")
        self.assertEqual(files(self.root) - before, set())
        self.assertEqual(before - files(self.root), set())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
