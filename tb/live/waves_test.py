"""waves_test.py DE1SIM FOLDER PROGRAMS [CASE...] - waveforms of what was played"""
import asyncio
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

from board import Board, Client

DE1SIM, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])


# Of a VCD: a vector's name in the file, and when it moves; when all begins and ends.
AWK = """
$1 == "$var" && $5 == name { key = $4 }
/^#/ { now = substr($0, 2); if (begin == "") begin = now }
/^b/ && $2 == key { print now, substr($1, 2) }
END { print begin, now }
"""


def movements(fst, signal):
    """[(seconds, value), ...] of a signal of the pins, and when the first and the last clock is."""
    text = subprocess.run(["sh", "-c", 'fst2vcd "$1" | awk -v name="$2" "$3"', "sh", fst, signal,
                           AWK], capture_output=True, text=True, check=True).stdout
    *moves, (begin, end) = [line.split() for line in text.splitlines()]
    return [(int(t) * 1e-12, int(value, 2)) for t, value in moves], int(begin) * 1e-12, \
        int(end) * 1e-12


class Waves(unittest.IsolatedAsyncioTestCase):
    def setUp(self):
        self.folder = FOLDER / self.id().split(".")[-1]
        shutil.rmtree(self.folder, ignore_errors=True)
        self.begin()

    def begin(self, *words):
        self.board = Board(DE1SIM, self.folder, *words)
        self.addCleanup(self.board.__exit__)

    def steps(self):
        return (self.board.out / "waves-1.yaml").read_text()

    async def test_of_the_last_milliseconds(self):
        async with self.board.connect() as socket:
            client = Client(socket)
            await client.frames_on(6)
            await client.send(pause=True)
            await client.until(lambda: client.last["status"]["paused"])
            await client.step("hold", {"key": 2})
            await client.send(frame=1)
            await client.until(lambda: not client.last["status"]["paused"])
            await client.until(lambda: client.last["status"]["paused"])
            await client.send(waves={"last": "20ms"})
            await client.send(waves={"last": "20ms"})
            self.assertEqual(await client.wait_for("error"),
                             "waveforms are being written; wait for their end")
            written = await client.wait_for("waves", 120)
            self.assertTrue(written.endswith("/out/waves-1/waves.fst"), written)
            now = client.last["status"]["time"]
        moves, first, last = movements(self.board.out / "waves-1" / "waves.fst", "key_ni")
        self.assertAlmostEqual(first, now - 0.02, delta=1e-6)
        self.assertAlmostEqual(last, now, delta=1e-6)
        self.assertEqual([value for _, value in moves], [0b1111, 0b1011])
        held = sum(float(line.split()[2][:-2]) * 1e-3 for line in self.steps().splitlines()
                   if line.startswith("  - delay: ") and line.endswith("ms"))
        self.assertIn('hold', self.steps())
        self.assertLess(moves[1][0], held + 0.02)
        self.assertIn("AUDIO_FIFOSPACE",
                      (self.board.out / "waves-1" / "waves.bus.txt").read_text())

    async def test_of_the_next(self):
        async with self.board.connect() as socket:
            client = Client(socket)
            await client.frames_on(2)
            await client.send(waves={"next": "12ms"})
            await client.step("hold", {"switch": 3, "bounce": "0ms"})
            written = await client.wait_for("waves", 120)
            self.assertTrue(written.endswith("/out/waves-1/waves.fst"), written)
            frames = client.frames()
            await client.frames_on(2)  # the board has gone on
            self.assertGreater(client.frames(), frames)
        moves, first, last = movements(self.board.out / "waves-1" / "waves.fst", "sw_i")
        self.assertAlmostEqual(last - first, 0.012, delta=1e-6)
        self.assertEqual([value for _, value in moves], [0, 8])

    async def test_of_more_than_there_was(self):
        self.board.__exit__()
        self.begin("--driven")
        async with self.board.connect() as socket:
            client = Client(socket)
            await client.send(run="5ms")
            await client.wait_for("ran")
            await client.send(waves={"last": "1s"})
            await client.send(run="1ms")
            await client.wait_for("waves", 120)
        _, first, last = movements(self.board.out / "waves-1" / "waves.fst", "key_ni")
        self.assertAlmostEqual(first, 0, delta=1e-7)
        self.assertAlmostEqual(last, 0.005, delta=1e-7)

    async def test_wrong_times(self):
        async with self.board.connect() as socket:
            client = Client(socket)
            for wrong in (True, {"last": 5}, {"last": "0ms"}, {"last": "2s"}, {"last": "x"},
                          {"last": "1ms", "next": "1ms"}, {}):
                await client.send(waves=wrong)
                self.assertRegex(await client.wait_for("error"),
                                 "expected waves with last or next and a time of up to 1s")

    async def test_the_end_ends_it(self):
        async with self.board.connect() as socket:
            client = Client(socket)
            await client.frames_on(60)
            await client.send(waves={"last": "900ms"})
            for _ in range(200):  # 20 s
                if self.second_runs():
                    break
                await asyncio.sleep(0.1)
            self.assertNotEqual(self.second_runs(), [])
        self.board.__exit__()
        self.assertEqual(self.second_runs(), [])

    def second_runs(self):
        """Processes that write the waveforms."""
        folder = str((self.folder / "out/waves-1").resolve())
        found = []
        for link in pathlib.Path("/proc").glob("[0-9]*/fd/*"):
            try:
                if os.readlink(link).startswith(folder):
                    found.append(link)
            except OSError:
                pass  # it has ended since, or is not ours
        return found


unittest.main(argv=sys.argv[:1] + sys.argv[4:])
