"""live_test.py - faults of `de1sim live`; the table is in tb/README.md."""
import asyncio
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import time
import urllib.error
import urllib.request

from faults import (DE1SIM, Faults, MIB, NO_INODES, PASSED, WRONG, has_not_begun, limited,
                    new_files, processes_in, run)

sys.path.append(str(pathlib.Path(__file__).parent.parent / "live"))
from board import Board, Client  # noqa: E402


class Live(Faults):
    def setUp(self):
        super().setUp()
        self.steps("1s")

    def board(self, *words, **options):
        shutil.rmtree(self.out, ignore_errors=True)
        return Board(DE1SIM, self.folder, "s.yaml", *words, **options)

    def limited(self, what, most):
        return self.board(preexec_fn=limited({what: most}))

    def end(self, board, sent=signal.SIGINT):
        """Its exit code; no process, and no folder of dropped files is left."""
        if board.process.poll() is None:
            board.process.send_signal(sent)
        code = board.process.wait(30)
        end = time.monotonic() + 20
        while processes_in(self.folder) and time.monotonic() < end:
            time.sleep(0.02)
        self.assertEqual(processes_in(self.folder), [], "the simulation is left")
        return code

    def plays(self, board):
        """Pictures come, and simulated time passes."""
        async def look():
            client = Client(await board.connect())
            await client.until(lambda: client.frames() > 5)
            await client.socket.close()
        asyncio.run(look())

    def post(self, board, file):
        request = urllib.request.Request(f"http://{board.host}/run?token={board.token}",
                                         data=file, method="POST")
        try:
            return urllib.request.urlopen(request, timeout=30).status, ""
        except urllib.error.HTTPError as error:
            return error.code, error.read().decode()

    def test_a_disk_that_is_full_at_any_of_the_files(self):
        with self.board() as board:
            self.plays(board)
            self.assertEqual(self.end(board), PASSED, board.said())
        self.all_whole("all is well")
        sizes = {name.name: path.stat().st_size for name, path in self.files().items()}
        for name in "audio.wav", "report.json":
            with self.subTest(file=name), self.limited(resource.RLIMIT_FSIZE,
                                                       sizes[name] // 2) as board:
                self.plays(board)
                self.assertEqual(self.end(board), WRONG, board.said())
                self.assertIn("File too large", board.said())
                self.all_whole(f"no file over {sizes[name] // 2} bytes")

    def test_a_dropped_file_on_a_full_disk(self):
        """The page is told; the board plays on."""
        with self.limited(resource.RLIMIT_FSIZE, 300_000) as board:
            code, said = self.post(board, b"x" * 400_000)
            self.assertEqual(code, 507)
            self.assertIn("File too large", said)
            self.plays(board)
            self.end(board)

    def test_a_disk_without_inodes(self):
        codes = []
        for count in range(25):
            try:
                with self.board(env=new_files(count, self.folder)) as board:
                    time.sleep(0.3)
                    codes.append(self.end(board))
                    said = board.said()
            except RuntimeError as error:  # it has not listened
                codes.append(WRONG)
                said = str(error)
            self.all_whole(f"{count} new files")
            if codes[-1] == PASSED:
                break
            self.assertIn("No space left", said)
        self.assertEqual(codes, [WRONG] * (len(codes) - 1) + [PASSED])
        self.assertGreater(len(codes), 3)

    def test_a_folder_that_cannot_be_written_to(self):
        """One line says so; the server stays, so that the page can show it."""
        (self.folder / "file").write_text("x")
        for out in "file", "/proc/de1sim":
            with Board(DE1SIM, self.folder, "s.yaml", out=out) as board:
                time.sleep(0.3)
                self.assertEqual(self.end(board), WRONG, board.said())
                about = [line for line in board.said().splitlines() if "board" not in line
                         and "Ctrl-C" not in line]
                self.assertEqual(len(about), 1, board.said())
                self.assertIn(out, about[0])
        self.assertEqual((self.folder / "file").read_text(), "x")

    def test_ended_by_a_signal_at_any_time(self):
        for sent in signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGKILL:
            for wait_s in 0, 0.2, 0.8:
                note = f"{sent.name} after {wait_s} s"
                with self.board("--frames", "last",
                                env={**os.environ, "TMPDIR": str(self.folder)}) as board:
                    time.sleep(wait_s)
                    code, said = self.end(board, sent), board.said()
                if sent == signal.SIGKILL:
                    self.assertEqual(code, -sent, note)
                else:
                    self.assertEqual(code, PASSED, f"{note}: {said}")
                    self.assertEqual(list(self.folder.glob("de1sim-live-*")), [], note)
                self.all_whole(note)
                if wait_s > 0.5:
                    report = json.loads((self.out / "report.json").read_text())
                    self.assertGreater(report["simulated_s"], 0, note)

    def test_two_at_once_in_one_folder(self):
        with self.board() as first:
            self.plays(first)
            kept = Board(DE1SIM, self.folder / "second", "../s.yaml", out=self.out)
            with kept as second:
                time.sleep(0.3)
                second.process.send_signal(signal.SIGINT)
                self.assertEqual(second.process.wait(30), WRONG, second.said())
                self.assertIn("another run is writing", second.said())
            self.plays(first)
            self.assertEqual(self.end(first), PASSED)

    def test_too_few_descriptors(self):
        codes = set()
        for count in (*range(3, 13), 40):
            try:
                with self.limited(resource.RLIMIT_NOFILE, count) as board:
                    time.sleep(0.2)
                    code, said = self.end(board), board.said()
            except RuntimeError as error:
                code, said = WRONG, str(error)
            if has_not_begun(said):
                continue
            self.assertIn(code, (PASSED, WRONG), f"{count} descriptors: {said}")
            self.assertNotIn("terminate", said)
            self.all_whole(f"{count} descriptors")
            codes.add(code)
        self.assertEqual(code, PASSED, said)
        self.assertEqual(codes, {PASSED, WRONG})

    def test_more_clients_than_descriptors(self):
        """Those that find no room wait, and the server does not spin meanwhile."""
        async def crowd(board):
            waiting = [await asyncio.open_connection(*board.host.split(":")) for _ in range(60)]
            before = cpu_s(board.process.pid)
            await asyncio.sleep(1)
            used = cpu_s(board.process.pid) - before
            for _, writer in waiting:
                writer.close()
            return used

        with self.board("--driven", preexec_fn=limited({resource.RLIMIT_NOFILE: 40})) as board:
            self.assertLess(asyncio.run(crowd(board)), 0.5)
            asyncio.run(self.a_picture(board))
            self.end(board)

    async def a_picture(self, board):
        client = Client(await board.connect())
        await client.send(run="50ms")
        await client.wait_for("ran")
        await client.socket.close()

    def test_too_little_memory(self):
        codes = set()
        for mib in 60, 120, 240, 480, 960, 1320, 6000:
            try:
                with self.limited(resource.RLIMIT_AS, mib * MIB) as board:
                    time.sleep(0.5)
                    code, said = self.end(board), board.said()
            except RuntimeError as error:
                code, said = WRONG, str(error)
            if has_not_begun(said):
                continue
            self.assertIn(code, (PASSED, WRONG), f"{mib} MiB: {said}")
            if code == WRONG:
                self.assertIn("memory", said, f"{mib} MiB")
            self.all_whole(f"{mib} MiB")
            codes.add(code)
        self.assertEqual(codes, {PASSED, WRONG})

    def test_a_clock_that_is_set_back(self):
        """By a day a second; the pace is that of the steady clock."""
        library = next(pathlib.Path("/usr/lib").glob("*/faketime/libfaketime.so.1"))
        env = {**os.environ, "LD_PRELOAD": str(library), "FAKETIME": "-1d x-86400",
               "FAKETIME_DONT_FAKE_MONOTONIC": "1"}
        with self.board(env=env) as board:
            self.plays(board)
            self.assertEqual(self.end(board), PASSED, board.said())
        self.all_whole("faketime")


def cpu_s(process):
    """Of user and system, so far."""
    fields = pathlib.Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / 100


run()
