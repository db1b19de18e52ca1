"""deploy_test.py NAME - sw/deploy against a board that is a folder, through a real sshd."""
import os
import subprocess
import unittest

from fixture import SOURCE, DeployTest
from standin import text


class Deploy(DeployTest):
    def test_RunsOnABoardThatLoadsByOverlay(self):
        self.assertEqual(self.deploy(self.version("A")), 0, self.said())
        self.assert_works("A")

    def test_RunsOnABoardThatLoadsByItsDevice(self):
        self.new_board(way="device")
        self.assertEqual(self.deploy(self.version("A")), 0, self.said())
        self.assert_works("A")

    def test_RunsInTheForegroundWhereThereIsNoSystemd(self):
        self.new_board(systemd=False)

        def end_the_program():
            if self.lines[-1] == "A runs":
                self.assert_works("A")
                self.board.kill_all()
        self.deploy(self.version("A"), at_line=end_the_program)
        self.assert_says("no systemd there")
        self.assert_says("A runs")

    def test_RunsInTheForegroundWhereItIsAsked(self):
        self.good_a()

        def end_the_program():
            if self.lines[-1] == "B runs":
                self.assert_works("B")
                self.board.kill_all()
        self.deploy(self.version("B"), at_line=end_the_program, FOREGROUND="1")
        self.assertNotIn("starts the program", self.said())
        self.assert_says("B runs")

    def test_ANewVersionEndsTheProgramInTheForeground(self):
        self.new_board(systemd=False)
        first = self.start("deploy", self.version("A"))

        def end_the_program():
            if self.lines[-1] == "B runs":
                self.assertNotIn(old, [pid for pid, _ in self.board.processes()])
                self.assert_works("B")
                self.board.kill_all()
        while "A runs" not in first.stdout.readline():
            pass
        old = int(text(self.board.root / "run/de1sim/pid"))
        self.deploy(self.version("B"), at_line=end_the_program)
        self.assert_says("B runs")
        first.communicate(timeout=60)

    def test_StartsAgainAfterAPowerCut(self):
        self.good_a()
        self.board.boot()
        self.assert_works("A")

    def test_KeepsTheVersionBeforeAndNoOther(self):
        self.good_a()
        for name in ["B", "C"]:
            self.deploy(self.version(name))
        self.assert_works("C")
        self.assertEqual(len(list((self.board.root / "opt/de1sim/versions").iterdir())), 2)

    def test_CopiesNothingTwice(self):
        self.good_a()
        self.assertEqual(self.deploy(self.version("A")), 0)
        self.assert_says("is there already")
        self.assert_works("A")

    def test_CopiesAnewWhatWasDamagedOnTheBoard(self):
        self.good_a()
        with open(self.board.root / "opt/de1sim/current/de1_soc.rbf", "ab") as rbf:
            rbf.write(b"x")
        self.assertEqual(self.deploy(self.version("A")), 0, self.said())
        self.assert_works("A")

    def test_RollsBackAndForth(self):
        self.good_a()
        self.deploy(self.version("B"))
        self.assertEqual(self.run_script("rollback"), 0, self.said())
        self.assert_works("A")
        self.assertEqual(self.run_script("rollback"), 0, self.said())
        self.assert_works("B")

    def test_RollbackSaysWhenThereIsNoVersionBefore(self):
        self.assertEqual(self.run_script("rollback"), 1)
        self.assert_says("no version is installed")
        self.good_a()
        self.assertEqual(self.run_script("rollback"), 1)
        self.assert_says("there is no version before")
        self.assert_works("A")

    def test_DryRunConnectsToNothing(self):
        for action in ["--dry-run deploy", "--dry-run rollback"]:
            self.assertEqual(self.run_script(action, self.version("A")), 0)
            self.assert_says("[2] ")
        self.assertEqual(self.board.accepted, 0)

    def test_TakesFilesWithBlanksAndQuotes(self):
        version = self.version("it's \"a\" $HOME; `x` version")
        self.version("A")
        os.replace(self.folder / "A.rbf", version["RBF"])
        version["FIRMWARE"] = self.version("A")["FIRMWARE"]
        self.version("A")
        self.assertEqual(self.deploy(version), 0, self.said())
        self.assert_works("A")


class Arguments(DeployTest):
    def assert_one_line(self, code, part):
        self.assertEqual(self.code, code, self.said())
        self.assertEqual(len(self.lines), 1, self.said())
        self.assert_says(part)
        self.assertEqual(self.board.accepted, 0)

    def test_NoBoardIsOneLine(self):
        self.deploy(self.version("A"), BOARD="")
        self.assert_one_line(2, "BOARD=user@host")

    def test_ABoardsNameIsNeverCodeNorAnOption(self):
        for name in ["root@a b", "a'b", "a;touch x", "$(touch x)", "-oProxyCommand=touch x"]:
            self.deploy(self.version("A"), BOARD=name)
            self.assert_one_line(2, "not of the form user@host")

    def test_AMissingBitstreamIsOneLine(self):
        self.deploy({**self.version("A"), "RBF": "/no/such file.rbf"})
        self.assert_one_line(3, "no bitstream at /no/such file.rbf")

    def test_AWrongMselIsOneLine(self):
        for value in ["1", "01012", "01010 x", "$(id)"]:
            self.deploy(self.version("A"), MSEL=value)
            self.assert_one_line(2, "not five binary digits")

    def test_AnUnknownWordIsOneLine(self):
        self.run_script("deploy --harder", self.version("A"))
        self.assert_one_line(2, "--harder")

    def test_MakeAsksForTheBoardFirst(self):
        made = subprocess.run(["make", "-C", SOURCE, "deploy"], capture_output=True, text=True,
                              env={"PATH": os.environ["PATH"]})
        self.assertEqual(made.returncode, 2)
        self.assertIn("BOARD=user@host", made.stderr)
        self.assertNotIn("ninja", made.stdout)


class Jtag(DeployTest):
    def run_jtag(self, path, **environment):
        run = subprocess.run([SOURCE / "sw/deploy/jtag.sh"], capture_output=True, text=True,
                             env={"PATH": str(path), **environment})
        self.code, self.lines = run.returncode, (run.stdout + run.stderr).splitlines()

    def test_JtagHandsTheFileToOpenFpgaLoader(self):
        rbf = self.version("it's A")["RBF"]
        self.board.replace("openFPGALoader", '#!/bin/sh\nprintf "<%s>" "$@"\n')
        self.run_jtag(self.board.bin, RBF=rbf)
        self.assertEqual((self.code, self.lines), (0, [f"<-b><de1Soc><{rbf}>"]))

    def test_JtagSaysWhatIsMissing(self):
        self.run_jtag(self.board.bin, RBF=self.version("A")["RBF"])
        self.assertEqual((self.code, len(self.lines)), (3, 1))
        self.assert_says("openFPGALoader is not on the PATH")
        self.run_jtag(self.board.bin, RBF="/no/such file")
        self.assertEqual((self.code, len(self.lines)), (3, 1))
        self.assert_says("no bitstream at /no/such file")


if __name__ == "__main__":
    unittest.main()
