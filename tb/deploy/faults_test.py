"""faults_test.py NAME - errors during a deployment, and what the board runs after them."""
import os
import unittest

from fixture import DeployTest
from standin import text


class DeployFault(DeployTest):
    # ---- Before anything is changed ----

    def test_AnUnknownHostKeyEndsItAndIsNotLearnt(self):
        (self.board.ssh / "known_hosts").write_text("")
        self.assertEqual(self.deploy(self.version("A")), 1)
        self.assert_says("Host key verification failed")
        self.assertEqual(text(self.board.ssh / "known_hosts"), "")
        self.assert_untouched()

    def test_AChangedHostKeyEndsIt(self):
        self.board.knows_host("other_key.pub")
        self.assertEqual(self.deploy(self.version("A")), 1)
        self.assert_says("Host key verification failed")
        self.assert_untouched()

    def test_AnUnreachableBoardIsSaid(self):
        self.board.cut()
        self.assertEqual(self.deploy(self.version("A")), 1)
        self.assert_says("no connection at step 1")
        self.assert_says("runs what it ran before")

    def test_AWrongKeyIsRefusedWithoutAQuestion(self):
        (self.board.ssh / "authorized_keys").write_text(text(self.board.ssh / "other_key.pub"))
        self.assertEqual(self.deploy(self.version("A")), 1)
        self.assert_says("Permission denied")
        self.assert_untouched()

    def test_WrongMselIsSaidBeforeACopy(self):
        self.board.set_msel("10010")
        self.assertEqual(self.deploy(self.version("A")), 1)
        self.assert_says("MSEL is 10010, this bitstream wants 01010")
        self.assert_untouched()

    def test_WrongMselIsNotForced(self):
        self.board.set_msel("00000")
        self.assertEqual(self.deploy(self.version("A"), FORCE="1"), 1)
        self.assert_untouched()

    def test_AnUncompressedBitstreamWantsAnotherMsel(self):
        self.board.set_msel("00000")
        self.assertEqual(self.deploy(self.version("A"), MSEL="00000"), 0, self.said())
        self.assert_works("A")

    def test_AnUnreadableMselNeedsForce(self):
        self.new_board(way="device")
        (self.board.bin / "devmem").unlink()
        self.assertEqual(self.deploy(self.version("A")), 1)
        self.assert_says("MSEL cannot be read")
        self.assert_untouched()
        self.assertEqual(self.deploy(self.version("A"), FORCE="1"), 0, self.said())
        self.assert_works("A")

    def test_MselIsReadByDevmem2Too(self):
        os.rename(self.board.bin / "devmem", self.board.bin / "devmem.elsewhere")
        self.board.replace("devmem2", """#!/bin/sh
echo "/dev/mem opened."
value=$(devmem.elsewhere "$1" 32)
echo "Value at address $1 (0xb6f4c000): $value"
[ $# -lt 3 ] || devmem.elsewhere "$1" 32 "$3"
""")
        self.assertEqual(self.deploy(self.version("A")), 0, self.said())
        self.assert_says("MSEL 01010")
        self.assert_works("A")

    def test_ALinuxThatCannotLoadIsSaid(self):
        self.new_board(way="none")
        self.assertEqual(self.deploy(self.version("A")), 1)
        self.assert_says("neither device-tree overlays nor /dev/fpga0")
        self.assert_untouched()

    def test_AnMvThatCannotReplaceALinkIsSaidBeforeACopy(self):
        self.board.replace("mv", "#!/bin/sh\n[ \"$1\" != -fT ] && exec busybox mv \"$@\"\n")
        self.assertEqual(self.deploy(self.version("A")), 1)
        self.assert_says("mv cannot replace a link")
        self.assert_untouched()

    def test_NoSpaceIsSaidBeforeACopy(self):
        self.board.replace("df", "#!/bin/sh\necho head\necho '/dev/root 9000 8900 100 99% /'\n")
        self.assertEqual(self.deploy(self.version("A")), 1)
        self.assert_says("no space: 100 KiB are free")
        self.assert_untouched()

    # ---- While copying ----

    def assert_only_a_is_there(self):
        self.assert_works("A")
        self.assertEqual(len(os.listdir(self.board.root / "opt/de1sim/versions")), 1)

    def test_NoSpaceInTheMiddleOfACopyLeavesTheVersionBefore(self):
        self.good_a()
        self.board.replace("tar", "#!/bin/sh\nhead -c 9000 >\"$2/de1_soc.rbf\"\n"
                           "echo 'tar: No space left on device' >&2\nexit 1\n")
        self.assertEqual(self.deploy(self.version("B")), 1)
        self.assert_says("No space left on device")
        self.assert_says("nothing was changed")
        self.assert_only_a_is_there()

    def test_ABrokenChecksumLeavesTheVersionBefore(self):
        self.good_a()
        self.board.replace("tar", "#!/bin/sh\nbusybox tar \"$@\" && echo x >>\"$2/de1_soc.rbf\"\n")
        self.assertEqual(self.deploy(self.version("B")), 1)
        self.assert_says("a checksum is wrong")
        self.assert_only_a_is_there()

    def test_AnotherVersionsSumsLeaveTheVersionBefore(self):
        self.good_a()
        self.board.replace("tar", "#!/bin/sh\nbusybox tar \"$@\" && cd \"$2\" || exit\n"
                           "echo x >de1_soc.rbf && rm SHA256SUMS && sums=$(sha256sum *)\n"
                           "echo \"$sums\" >SHA256SUMS\n")
        self.assertEqual(self.deploy(self.version("B")), 1)
        self.assert_says("a checksum is wrong")
        self.assert_only_a_is_there()

    # ---- While loading ----

    def test_AFailedLoadGoesBackToTheVersionBefore(self):
        self.good_a()
        self.assertEqual(self.deploy(self.version("B", start="broken")), 1)
        self.assert_says("write init error")
        self.assert_says("runs again")
        self.assert_works("A")

    def test_AFailedLoadByTheDeviceGoesBackToo(self):
        self.new_board(way="device")
        self.good_a()
        self.assertEqual(self.deploy(self.version("B", start="broken")), 1)
        self.assert_says("write init error")
        self.assert_works("A")

    def test_AFailedFirstLoadStartsNothing(self):
        self.assertEqual(self.deploy(self.version("B", start="broken")), 1)
        self.assert_says("there was none before it")
        self.assertIsNone(self.installed())
        self.assertFalse((self.board.root / "running").exists())
        self.good_a()

    def test_AWrongSystemIdGoesBackToTheVersionBefore(self):
        self.good_a()
        self.assertEqual(self.deploy(self.version("B", start="map2")), 1)
        self.assert_says("wrong system ID")
        self.assertNotIn("switches to", self.said())
        self.assert_works("A")

    def test_AProgramThatEndsAtOnceGoesBackToTheVersionBefore(self):
        self.good_a()
        self.assertEqual(self.deploy(self.version("B", ends=True)), 1)
        self.assert_says("the program does not run")
        self.assert_works("A")

    def test_AVersionThatFailedCanBeFollowedByAGoodOne(self):
        self.good_a()
        self.deploy(self.version("B", start="broken"))
        self.assertEqual(self.deploy(self.version("C")), 0, self.said())
        self.assert_works("C")
        self.assertEqual(self.run_script("rollback"), 0, self.said())
        self.assert_works("A")

    def test_ARollbackThatFailsStaysWhereItWas(self):
        self.good_a()
        self.deploy(self.version("B"))
        self.board.refused = b"map1 A"
        self.assertEqual(self.run_script("rollback"), 1)
        self.assert_works("B")

    def test_TwoAtOnceEndInOneThatWorks(self):
        self.good_a()
        first = self.start("deploy", self.version("B"))
        second = self.start("deploy", self.version("C"))
        said = first.communicate()[0] + second.communicate()[0]
        self.assertIn(0, (first.returncode, second.returncode), said)
        self.lines = said.splitlines()
        self.assert_works("B", "C")


if __name__ == "__main__":
    unittest.main()
