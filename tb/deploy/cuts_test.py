"""cuts_test.py NAME - the connection, or the power, cut after each line that a deployment prints.

Each line is a step begun; the board goes on for a moment or not at all.  Afterwards one of the two
versions works, and the same command again ends in the new one.
"""
import time
import unittest

from fixture import DeployTest

# Numbers that deploy.sh prints on a board that had a version
LINES = 18
LINES_BACK = 11


class DeployCut(DeployTest):
    def deploy_each(self, names):
        """Returns the names, first the one that runs."""
        for name in names:
            self.assertEqual(self.deploy(self.version(name)), 0, self.said())
            self.assert_works(name)
        return names[::-1]

    def each_cut(self, lines, cut, action="deploy"):
        """cut() after the given lines of a deployment, or of a rollback.

        A case goes on with the board of the case before, which runs one version and can go back
        to another; after a case that failed, with a new board.
        """
        first = ["A"] if action == "deploy" else ["A", "B"]
        names = self.deploy_each(first)
        for line in lines:
            with self.subTest(line=line):
                if not names:
                    self.new_board()
                    names = self.deploy_each(first)
                goal, version = names[-1], {}
                if action == "deploy":
                    goal = f"V{line}"
                    version = self.version(goal)
                before, names = names[0], []

                def at_line():
                    if len(self.lines) == line:
                        cut()
                self.run_script(action, version, at_line=at_line)
                self.assertGreaterEqual(len(self.lines), line, self.said())
                self.board.heal()
                if self.assert_works(before, goal) != goal or action == "deploy":
                    self.assertEqual(self.run_script(action, version), 0, self.said())
                self.assert_works(goal)
                self.assertEqual(len(list((self.board.root / "opt/de1sim/versions").iterdir())), 2)
                names = [goal, before]

    def draw_cable(self):
        self.board.cut()

    def draw_power(self):
        self.board.cut()
        self.board.boot()

    def test_EveryLineOfADeploymentIsCut(self):
        self.good_a()
        self.deploy(self.version("B"))
        self.assertEqual(len(self.lines), LINES, self.said())
        self.run_script("rollback")
        self.assertEqual(len(self.lines), LINES_BACK, self.said())

    def test_AConnectionCutInTheFirstStepsLeavesTheVersionBefore(self):
        self.each_cut(range(1, 8), self.draw_cable)

    def test_AConnectionCutWhileLoadingLetsTheBoardEndAlone(self):
        self.each_cut(range(8, 14), self.draw_cable)

    def test_AConnectionCutWhileStartingLetsTheBoardEndAlone(self):
        self.each_cut(range(14, LINES + 1), self.draw_cable)

    def test_APowerCutInTheFirstStepsStartsTheVersionBefore(self):
        self.each_cut(range(1, 6), self.draw_power)

    def test_APowerCutAroundTheCopyStartsTheVersionBefore(self):
        self.each_cut(range(6, 10), self.draw_power)

    def test_APowerCutWhileLoadingStartsOneOfThem(self):
        self.each_cut(range(10, 15), self.draw_power)

    def test_APowerCutWhileStartingStartsOneOfThem(self):
        self.each_cut(range(15, LINES + 1), self.draw_power)

    def test_ARollbackCutAnywhereLetsTheBoardEndAlone(self):
        self.each_cut(range(1, LINES_BACK + 1), self.draw_cable, "rollback")

    def test_ACopyCutInTheMiddleLeavesTheVersionBefore(self):
        self.good_a()
        started = self.board.root / "copying"
        self.board.replace("tar", "#!/bin/sh\n: >\"$DE1SIM_ROOT/copying\"\nbusybox sleep 0.3\n"
                           "exec busybox tar \"$@\"\n")
        version = self.version("B")
        with open(version["RBF"], "ab") as rbf:
            rbf.write(b"x" * 8_000_000)  # more than ssh buffers

        def at_line():
            if self.lines[-1].startswith("[3]"):
                while not started.exists():
                    time.sleep(0.01)
                self.board.cut()
        self.assertEqual(self.deploy(version, at_line=at_line), 1)
        self.assert_says("no connection at step 3")
        self.assert_works("A")
        self.board.heal()
        self.assertEqual(self.deploy(version), 0, self.said())
        self.assert_works("B")


if __name__ == "__main__":
    unittest.main()
