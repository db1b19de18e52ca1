"""driven_test.py DE1SIM FOLDER PROGRAMS - `de1sim live --driven`: a program plays, by "run"."""
import asyncio
import json
import pathlib
import subprocess
import sys
import unittest

from board import Board, Client

DE1SIM, FOLDER, PROGRAMS = sys.argv[1], *map(pathlib.Path, sys.argv[2:4])


class Played(unittest.IsolatedAsyncioTestCase):
    async def client(self):
        client = Client(await self.board.connect())
        self.addAsyncCleanup(client.socket.close)
        await client.until(lambda: "hello" in client.last)
        return client

    async def run_for(self, client, order):
        await client.send(run=order)
        return await client.wait_for("ran")


class Driven(Played):
    def setUp(self):
        self.folder = FOLDER / self.id().split(".")[-1]
        self.board = Board(DE1SIM, self.folder, "--driven", "--frames", "last")
        self.addCleanup(self.board.__exit__)

    async def test_time_stands_but_for_what_is_asked(self):
        client = await self.client()
        self.assertAlmostEqual((await self.run_for(client, "0ms"))["time"], 3e-9, 12)
        await asyncio.sleep(0.3)
        for so_far in 0.02, 0.04, 0.06:
            ran = await self.run_for(client, "20ms")
            self.assertAlmostEqual(ran["time"], so_far + 3e-9, 12)
            self.assertEqual(ran["met"], [])
        self.assertEqual(client.console, "ready\r\n")  # all of it came before the answer

    async def test_a_run_ends_in_the_millisecond_in_which_something_happens(self):
        client = await self.client()
        times = {}
        for what in "printed", "frame", "picture":
            ran = await self.run_for(client, {"for": "1s", "until": [what]})
            self.assertEqual(ran["met"], [what])
            times[what] = ran["time"]
        await client.step("hold", {"keypad": "1"})
        pins = await self.run_for(client, {"for": "1s", "until": ["lamps", "pins"]})
        self.assertEqual(pins["met"], ["pins"])  # the keypad's scanner moves them all the time
        ran = await self.run_for(client, {"for": "1s", "until": ["printed", "lamps"]})
        self.assertEqual((ran["met"], client.hex()), (["lamps"], "     1"))
        again = await self.run_for(client, {"for": "0ms", "until": ["lamps"]})
        self.assertEqual((again["met"], again["time"]), ([], ran["time"]))
        self.assertAlmostEqual(times["printed"], 0.001000003, 12)  # the demo's first line
        self.assertLess(times["frame"], 0.04)
        over = await self.run_for(client, {"for": "1ms", "until": ["steps"]})
        self.assertEqual(over["met"], ["steps"])  # there are none

    async def test_a_message_of_many_levels_is_refused(self):
        client = await self.client()
        for order in '{"run": %s}', '{"step": {"hold": %s}}':
            client.last.pop("error", None)
            await client.socket.send(order % ("[" * 20000 + "]" * 20000))
            await client.until(lambda: "error" in client.last)
            self.assertIn("at most 16 levels", client.last["error"])
        self.assertEqual((await self.run_for(client, "0ms"))["met"], [])

    async def test_nothing_is_left_out_for_a_slow_reader(self):
        """After five seconds that were played at once, audio.wav has as many samples."""
        client = await self.client()
        await client.send(speed=0)
        await client.step("press", {"keypad": ["1", "2"], "for": "3s"})
        await client.send(run="2s")
        await asyncio.sleep(3)
        ran = await client.wait_for("ran")
        await client.until(lambda: client.frame == ran["picture"])
        self.board.__exit__()
        file = (self.board.out / "audio.wav").stat().st_size - 44
        self.assertEqual(client.samples, file // 4)
        self.assertGreater(client.samples, 5 * 7900)

    async def test_wrong_orders_are_answered(self):
        client = await self.client()
        for order, answer in (
                ("1us", "expected a time of whole milliseconds up to 10s"),
                ("11s", "expected a time of whole milliseconds up to 10s"),
                (20, "got 20"),
                ({"for": "1s"}, "expected a time of whole milliseconds"),
                ({"for": "1s", "until": ["rain"]},
                 "expected a list of frame, picture, printed, lamps, pins and "
                 "steps, got [\"rain\"]")):
            await client.send(run=order)
            self.assertIn(answer, await client.wait_for("error"))
        await client.send(run="1s")
        await client.send(run="1s")
        self.assertIn("expected the end of the run before", await client.wait_for("error"))

    async def test_all_ends_with_the_last_connection(self):
        first, second = await self.client(), await self.client()
        await first.socket.close()
        await self.run_for(second, "1ms")
        await second.socket.close()
        self.assertEqual(await asyncio.to_thread(self.board.process.wait, 30), 0)

    async def test_the_saved_scenario_plays_again(self):
        client = await self.client()
        await client.send(speed=0)
        for key in "1", "2":
            await client.step("press", {"keypad": key})
            await self.run_for(client, "150ms")
        await client.send(save=True)
        saved = await client.wait_for("saved")
        self.board.__exit__()
        again = self.folder / "again"
        subprocess.run([DE1SIM, "run", saved["file"], "--out", again, "--quiet", "--frames",
                        "last"], check=True)
        frames = [json.loads((out / "report.json").read_text())["frames"]
                  for out in (self.board.out, again)]
        self.assertEqual(*frames)
        sounds = [(out / "audio.wav").read_bytes()[44:] for out in (self.board.out, again)]
        self.assertEqual(*sounds)


# Counts how often a key goes down or a switch up.
COUNTER = """\
module top(input CLOCK_50, input [3:0] KEY, input [9:0] SW, output [9:0] LEDR);
    wire down = KEY != 4'hf || SW != 0;
    reg was = 0;
    reg [9:0] count = 0;
    assign LEDR = count;
    always @(posedge CLOCK_50) begin
        was <= down;
        count <= count + (down && !was);
    end
endmodule
"""


class DrivenProject(Played):
    def setUp(self):
        self.folder = FOLDER / self.id().split(".")[-1]
        self.folder.mkdir(parents=True, exist_ok=True)
        (self.folder / "top.v").write_text(COUNTER)
        self.board = Board(DE1SIM, self.folder, "--driven", "--project", ".", "--frames", "last")
        self.addCleanup(self.board.__exit__)

    async def test_presses_of_one_clock_are_seen(self):
        client = await self.client()
        for control in [{"key": n} for n in range(4)] + [
                {"switch": n, "bounce": "0ms"} for n in (0, 9)]:
            await client.step("press", {**control, "for": "20ns"})
            await client.step("press", {**control, "for": "20ns"})  # 50 ms later
            await self.run_for(client, "51ms")
        await client.send(save=True)
        saved = await client.wait_for("saved")
        self.board.__exit__()
        again = self.folder / "again"
        subprocess.run([DE1SIM, "run", saved["file"], "--project", ".", "--out", again, "--quiet"],
                       check=True, cwd=self.folder)
        for out in self.board.out, again:
            shown = json.loads((out / "report.json").read_text())["shown"]
            self.assertEqual(int(shown["ledr"]["lit"], 2), 12)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
