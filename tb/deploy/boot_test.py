"""boot_test.py NAME - boot.cmd, read by sh as by U-Boot's hush, with stand-ins for its commands."""
import os
import pathlib
import shutil
import subprocess
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "sw/deploy/boot.cmd"
COMMANDS = ["fatload", "fpga", "bridge", "run", "itest.l", "bootelf"]


class BootScript(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(os.environ["SCRATCH"]) / self._testMethodName
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)

    def boot(self, *failing):
        """Runs the script; a command line that holds one of `failing` fails.  Returns what ran."""
        refuse = "".join(f"case \"$0 $*\" in *\"{part}\"*) exit 1 ;; esac\n" for part in failing)
        for command in COMMANDS:
            file = self.folder / command
            file.write_text(f"#!/bin/sh\necho \"{command} $*\" >>\"{self.folder}/ran\"\n{refuse}")
            file.chmod(0o755)
        environment = {"PATH": str(self.folder), "loadaddr": "0x1000000", "filesize": "1F0000"}
        run = subprocess.run(["/bin/sh", SCRIPT], env=environment, cwd=self.folder, text=True,
                             capture_output=True)
        self.said = run.stdout + run.stderr
        return (self.folder / "ran").read_text().splitlines()

    def test_LoadsTheFpgaThenLooksAtItThenStartsTheProgram(self):
        self.assertEqual(self.boot(), [
            "fatload mmc 0:1 0x1000000 de1_soc.rbf", "fpga load 0 0x1000000 1F0000",
            "bridge enable", "itest.l *0xff202040 == 0x44453153",
            "fatload mmc 0:1 0x02000000 collide.elf", "bootelf 0x02000000"])

    def test_EndsForLinuxWhereThereIsNoProgram(self):
        self.assertNotIn("bootelf 0x02000000", self.boot("collide.elf"))
        self.assertIn("system ID ok", self.said)

    def test_TouchesNoBridgeWhenTheFpgaDoesNotLoad(self):
        self.assertNotIn("bridge enable", self.boot("fpga load"))
        self.assertIn("is not loaded", self.said)

    def test_StartsNothingOnAWrongSystemId(self):
        self.assertNotIn("bootelf 0x02000000", self.boot("itest"))
        self.assertIn("wrong system ID", self.said)

    def test_EnablesTheBridgesInAnOldUBootToo(self):
        self.assertIn("run bridge_enable_handoff", self.boot("bridge enable"))


if __name__ == "__main__":
    unittest.main()
