"""setup_test.py SETUP FOLDER - what .ci/setup installs where Debian's tools are stand-ins."""
import os
import pathlib
import subprocess
import sys
import unittest

SETUP = pathlib.Path(sys.argv[1])
FOLDER = pathlib.Path(sys.argv[2])

# The line with the candidate is the third of many: who stops reading there must not call it a no.
POLICY = """#!/bin/sh
printf '%s:\\n  Installed: (none)\\n' "$2"
case " $OFFERED " in *" $2 "*) c=1.0-1 ;; *) c='(none)' ;; esac
[ "$LC_ALL" = C ] && echo "  Candidate: $c" || echo "  Kandidat: $c"
i=0
while [ $i -lt 2000 ]; do
    echo '     1.0-1 500 http://deb.debian.org/debian bookworm/main amd64 Packages' || exit 1
    i=$((i + 1))
done
"""
STANDINS = {
    "apt-cache": POLICY,
    "dpkg-query": "#!/bin/sh\nexit 1\n",
    "dpkg": "#!/bin/sh\necho amd64\n",
    "apt-get": "#!/bin/sh\necho \"apt-get $*\"\n",
    "id": "#!/bin/sh\necho 0\n",
}


class Setup(unittest.TestCase):
    def setUp(self):
        (FOLDER / "bin").mkdir(parents=True, exist_ok=True)
        for name, text in STANDINS.items():
            file = FOLDER / "bin" / name
            file.write_text(text)
            file.chmod(0o755)
        (FOLDER / "ci/packages").mkdir(parents=True, exist_ok=True)
        (FOLDER / "ci/setup").write_bytes(SETUP.read_bytes())
        (FOLDER / "ci/packages/tool").write_text("verilator  runs the Verilog\n"
                                                 "dynarmic[amd64]  the engine\n"
                                                 "unicorn[arm64]  the same on Arm\n"
                                                 "chromium?  a browser\n")

    def run_setup(self, offered):
        return subprocess.run(["bash", FOLDER / "ci/setup"], capture_output=True, text=True,
                              env={"PATH": f"{FOLDER / 'bin'}:{os.environ['PATH']}",
                                   "LANG": "de_DE.UTF-8", "OFFERED": offered})

    def installed(self, done):
        self.assertEqual(done.returncode, 0, done.stderr)
        line = next(line for line in done.stdout.splitlines() if line.startswith("apt-get install"))
        return line.split("--no-install-recommends ")[1]

    def test_installs_what_is_offered(self):
        self.assertEqual(self.installed(self.run_setup("verilator dynarmic chromium")),
                         "verilator dynarmic chromium")

    def test_leaves_out_what_is_optional_and_not_offered(self):
        done = self.run_setup("verilator dynarmic")
        self.assertEqual(self.installed(done), "verilator dynarmic")
        self.assertIn("no package chromium: the tests that need it are skipped", done.stdout)

    def test_names_what_a_release_does_not_have(self):
        done = self.run_setup("verilator chromium")
        self.assertEqual(done.returncode, 1)
        self.assertIn("This release does not have these packages", done.stderr)
        self.assertIn("dynarmic[amd64]  the engine", done.stderr)
        self.assertNotIn("runs the Verilog", done.stderr)
        self.assertNotIn("apt-get install", done.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
