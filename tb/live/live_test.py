"""live_test.py DE1SIM FOLDER PROGRAMS [TEST] - `de1sim live` by its protocol."""
import asyncio
import http.client
import json
import pathlib
import subprocess
import sys
import unittest

import websockets

from board import Board, Client

DE1SIM, FOLDER, PROGRAMS = sys.argv[1], *map(pathlib.Path, sys.argv[2:4])


# 640 x 480, but for lines of 799 clocks.
SHORT_LINES = """
module top(input CLOCK_50, output reg VGA_CLK, output VGA_HS, VGA_VS, VGA_BLANK_N, VGA_SYNC_N,
           output [7:0] VGA_R, VGA_G, VGA_B);
    reg [9:0] x, y;
    assign VGA_HS = x >= 96, VGA_VS = y >= 2, VGA_SYNC_N = 0;
    assign VGA_BLANK_N = x >= 144 && x < 784 && y >= 35 && y < 515;
    assign VGA_R = VGA_BLANK_N ? x : 0, VGA_G = 0, VGA_B = 0;
    always @(posedge CLOCK_50) begin
        VGA_CLK <= !VGA_CLK;
        if (VGA_CLK) begin
            x <= x == 798 ? 0 : x + 1;
            if (x == 798) y <= y == 524 ? 0 : y + 1;
        end
    end
endmodule
"""


class Live(unittest.IsolatedAsyncioTestCase):
    words = ()

    def setUp(self):
        self.folder = FOLDER / self.id().split(".")[-1]
        self.board = Board(DE1SIM, self.folder, *self.words)
        self.addCleanup(self.board.__exit__)

    def report(self):
        """Of the run, which ends."""
        self.board.__exit__()
        return json.loads((self.board.out / "report.json").read_text())

    def played_again(self, saved):
        """The saved scenario's report; its files are those of the run, which has ended."""
        out = self.folder / "again"
        again = subprocess.run([DE1SIM, "run", saved, "--out", out, "--quiet", "--frames", "last"],
                               capture_output=True, text=True)
        self.assertEqual(again.returncode, 0, again.stdout + again.stderr)
        for name in ("audio.wav", "console.txt"):
            self.assertEqual((out / name).read_bytes(), (self.board.out / name).read_bytes(), name)
        live, report = (json.loads((folder / "report.json").read_text())
                        for folder in (self.board.out, out))
        for what in set(live) - {"scenario", "file", "end", "wall", "expectations"}:
            self.assertEqual(report[what], live[what], what)
        return report

    async def paused(self, client):
        """What is inside while time stands."""
        await client.send(pause=True)
        await client.until(lambda: client.last.get("status", {}).get("paused"))
        return await client.wait_for("inside")

    async def client(self, **options):
        client = Client(await self.board.connect(**options))
        self.addAsyncCleanup(client.socket.close)
        await client.until(lambda: "hello" in client.last)
        return client

    async def tap(self, client, key):
        await client.step("hold", {"keypad": key})
        await client.frames_on(4)
        await client.step("release", {"keypad": key})
        await client.frames_on(4)


class Playing(Live):
    async def test_what_is_played_is_kept_and_plays_again(self):
        """Picture, sound and HEX of the replay are those of the live run."""
        client = await self.client()
        self.assertEqual(client.last["hello"]["protocol"], 1)
        await client.until(lambda: client.pictures > 0)
        for key in "1", "2", "3":
            await self.tap(client, key)
        await client.until(lambda: client.hex() == "     3")
        await client.send(mark=True)
        await client.wait_for("marked")
        await client.send(save=True)
        saved = await client.wait_for("saved")
        self.assertEqual((self.board.out / "live.yaml").read_text(), saved["text"])
        self.assertIn("ready", client.console)
        again = subprocess.run([DE1SIM, "run", saved["file"], "--out", self.folder / "again",
                                "--quiet"], capture_output=True, text=True)
        self.assertEqual(again.returncode, 0, again.stdout + again.stderr)
        report = json.loads((self.folder / "again" / "report.json").read_text())
        self.assertEqual([claim["met"] for claim in report["expectations"]], [True])
        self.board.__exit__()
        live, replay = ((folder / "audio.wav").read_bytes()[44:]
                        for folder in (self.board.out, self.folder / "again"))
        self.assertGreater(len(replay), 4000)
        self.assertEqual(live[:len(replay)], replay)

    async def test_time_stands_and_goes_on_frame_by_frame(self):
        client = await self.client()
        await client.until(lambda: client.pictures > 0)
        await client.send(pause=True)
        await client.until(lambda: client.last.get("status", {}).get("paused"))
        frames = client.last["status"]["frames"]
        await asyncio.sleep(0.5)
        await client.wait_for("status")
        self.assertEqual(client.last["status"]["frames"], frames)
        await client.send(frame=2)
        await client.until(lambda: client.last["status"]["frames"] == frames + 2
                           and client.last["status"]["paused"])
        await client.send(speed=0.1)
        await client.send(pause=False)
        await client.until(lambda: client.last["status"]["frames"] > frames + 6)
        self.assertLess(client.last["status"]["factor"], 0.2)

    async def test_power_off_and_on_begins_anew(self):
        client = await self.client()
        await client.frames_on(20)
        await client.send(reset=True)
        await client.wait_for("power")
        client.pictures = 0
        await client.until(lambda: client.pictures > 0)
        self.assertLess(client.frame, 20)  # which had been shown before

    async def test_a_dropped_program_runs(self):
        client = await self.client()
        await client.until(lambda: client.pictures > 0)
        wrong = self.post(b"\x7fELF, but no more than that")
        self.assertEqual(wrong.status, 200)
        self.assertTrue(await client.wait_for("ended"))
        scenario = b"name: dropped\nversion: 1\nsteps:\n  - hold: {keypad: 5}\n"
        self.assertEqual(self.post(scenario).status, 200)
        await client.until(lambda: client.hex() == "     1")

    def post(self, body):
        connection = http.client.HTTPConnection(self.board.host, timeout=20)
        connection.request("POST", f"/run?token={self.board.token}", body)
        return connection.getresponse()


class BegunByAScenario(Live):
    STEPS = ("  - wait-serial: {text: ready, timeout: 2s}\n"
             "  - press: {keypad: \"1\", for: 80ms}\n"
             "  - delay: 123456.789us\n")

    def setUp(self):
        """A scenario with a golden picture, which has to be made first."""
        folder = FOLDER / "scenario"
        (folder / "golden").mkdir(parents=True, exist_ok=True)
        head = "name: begun\nversion: 1\nseed: 7\nduration: 60s\nps2: [mouse, keyboard]\nsteps:\n"
        made = folder / "made.yaml"
        made.write_text(head.replace("duration: 60s\n", "") + self.STEPS
                        + "  - take-screenshot: {save-to: one.png}\n")
        subprocess.run([DE1SIM, "run", made, "--quiet", "--out", folder / "golden"], check=True,
                       capture_output=True)
        begun = folder / "begun.yaml"
        begun.write_text(head + self.STEPS + "  - expect-frame: {equals: golden/one.png}\n")
        self.words = (str(begun), "--frames", "last")
        super().setUp()

    async def test_its_steps_and_what_was_played_are_saved_and_play_again(self):
        client = await self.client()
        await client.send(save=True)
        self.assertIn("steps still play", await client.wait_for("error"))
        await client.until(lambda: client.hex() == "     1")
        await client.frames_on(20)
        await self.tap(client, "2")
        await client.step("hold-key", "a")  # at the second port, as the scenario says
        await self.paused(client)
        await client.send(save=True)
        saved = await client.wait_for("saved")
        self.assertIn("ps2: [mouse, keyboard]\n", saved["text"])
        self.assertNotIn("duration", saved["text"])
        self.board.__exit__()
        again = self.played_again(saved["file"])
        self.assertEqual([claim["met"] for claim in again["expectations"]], [True, True])
        self.assertEqual(again["seed"], 7)


class InsideAProgram(Live):
    words = ("--elf", str(PROGRAMS / "aborts_twice.elf"))

    async def test_it_is_seen_where_it_is_and_what_it_does(self):
        client = await self.client()
        await client.frames_on(10)
        inside = await self.paused(client)
        late = await self.client()
        await late.until(lambda: "lamps" in late.last)
        self.assertEqual(len(late.all["log"]), 2)  # as they happened, also for who comes later
        report = self.report()
        self.assertEqual(late.all["log"], report["log"]["first"])
        program = report["program"]
        self.assertEqual(inside["program"]["function"], program["at"]["function"])
        self.assertEqual(inside["program"]["pc"], int(program["at"]["pc"], 16))
        self.assertEqual(inside["program"]["waiting"], program["at"]["waiting_for"])
        self.assertEqual(inside["program"]["aborts"], program["aborts"])
        for name, spread in (("busy", "busy_share"), ("on_bus", "bus_share"),
                             ("instructions", "instructions")):
            least, most = (program["frames"][spread][end] for end in ("min", "max"))
            self.assertTrue(least <= inside["program"][name] <= most, name)
        frames = client.last["status"]["time"] / 16.8e-3
        self.assertAlmostEqual(inside["bus"]["reads"] / report["bus"]["reads"] * frames, 1, 1)
        self.assertEqual(inside["bus"]["errors"], report["bus"]["errors"])
        self.assertIn(report["frames"]["shown"] - inside["frames"], (0, 1))  # one may just end
        self.assertEqual(inside["pictures"], report["frames"]["swapped"])
        # The codec's samples fill a FIFO that nobody reads; nobody has written to the other.
        self.assertEqual(inside["audio"], {"to_play": [0, 0], "recorded": [128, 128], "size": 128,
                                           "underruns": 0})


class InsideSound(Live):
    words = ("--elf", str(PROGRAMS / "starves.elf"))

    async def test_fifos_and_underruns_are_those_that_the_program_has_read(self):
        """Three times the FIFOs run dry; then the left one alone is filled."""
        client = await self.client()
        await client.until(lambda: "held\n" in client.console)
        inside = await self.paused(client)
        self.assertEqual(inside["audio"]["underruns"], 3)
        self.assertEqual(inside["audio"]["to_play"], [100, 0])
        self.assertEqual(self.report()["audio"]["underruns"], 3)


class Terminals(Live):
    words = ("--elf", str(PROGRAMS / "terminals.elf"))

    def printed(self, client):
        """On each line."""
        texts = {"serial": "", "jtag-0": "", "jtag-1": ""}
        for message in client.all.get("terminals", ()):
            for line, text in message.items():
                texts[line] += text
        return texts

    async def test_each_has_what_is_printed_and_typed_there(self):
        """And the saved scenario types the same; what comes later is told all of it."""
        client = await self.client()
        expected = {"serial": "\u00e4 ready\n+a+b", "jtag-0": "+c", "jtag-1": "+d+e"}
        for line, text in ("jtag-1", "d"), ("serial", "ab"), ("jtag-0", "c"), ("jtag-1", "e"):
            await client.step("type-serial", {"text": text, "to": line})
        await client.until(lambda: self.printed(client) == expected)
        self.assertEqual(len(client.console), len("".join(expected.values())))
        late = await self.client()
        await late.until(lambda: self.printed(late) == expected)
        self.assertEqual(late.console, client.console)
        await client.send(save=True)
        saved = await client.wait_for("saved")
        again = subprocess.run([DE1SIM, "run", saved["file"], *self.words, "--quiet", "--out",
                                self.folder / "again"], capture_output=True, text=True)
        self.assertEqual(again.returncode, 0, again.stdout + again.stderr)
        self.board.__exit__()
        self.assertEqual((self.folder / "again/console.txt").read_bytes(),
                         (self.board.out / "console.txt").read_bytes())


class Parts(Live):
    def setUp(self):
        folder = FOLDER / "parts"
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "top.v").write_text("""
module top(input CLOCK_50, inout [35:0] GPIO_0, output [9:0] LEDR);
    assign LEDR = GPIO_0[9:0];
    assign GPIO_0[11:10] = {1'b1, GPIO_0[0]};
    assign GPIO_0[13:12] = 2'b01; endmodule
""")
        (folder / "s.yaml").write_text("""name: s
version: 1
parts:
  - button: {name: a, pin: "GPIO_0[0]"}
  - switch: {name: b, pin: "GPIO_0[1]"}
  - led-matrix: {name: m, rows: "GPIO_0[11:10]", columns: "GPIO_0[13:12]"}
  - lt24: GPIO_1
steps:
  - delay: 1ms
""")
        self.words = ("--project", str(folder), str(folder / "s.yaml"))
        super().setUp()

    async def test_buttons_and_switches_are_played(self):
        client = await self.client()
        await client.until(lambda: client.last.get("lamps", {}).get("ledr") == 0x3FD, 120)
        await client.step("hold-button", {"button": "a"})
        await client.step("set-switch", {"switch": "b", "level": "high"})
        await client.until(lambda: client.last["lamps"]["ledr"] == 0x3FE)
        await client.step("release-button", {"button": "a"})
        await client.step("delay", "1ms")
        await client.until(lambda: client.last["lamps"]["ledr"] == 0x3FF)


    async def test_what_parts_show_is_told(self):
        client = await self.client()
        seen = {}

        def shows(rows):
            for name, news in client.last.get("parts", {}).items():
                seen.setdefault(name, {}).update(news)
            return seen.get("m", {}).get("rows") == rows and "picture" in seen["lt24"]
        await client.until(lambda: shows(["#.", "#."]), 120)
        await client.step("hold-button", {"button": "a"})
        await client.until(lambda: shows(["#.", ".."]))
        self.assertEqual(seen["a"], {"kind": "button", "on": {"hold-button": "a"},
                                     "off": {"release-button": "a"}, "stays": False})
        self.assertTrue(seen["lt24"]["picture"].startswith("data:image/png;base64,"))
        late = await self.client()
        await late.until(lambda: "parts" in late.last)
        self.assertEqual(late.last["parts"]["m"]["rows"], ["#.", ".."])


class AnotherBoard(Live):
    def setUp(self):
        folder = FOLDER / "de10_lite"
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "top.qsf").write_text("set_global_assignment -name DEVICE 10M50DAF484C7G\n"
                                        "set_global_assignment -name TOP_LEVEL_ENTITY top\n"
                                        "set_global_assignment -name VERILOG_FILE top.v\n")
        (folder / "top.v").write_text("""\
module top(input [1:0] KEY, output [9:0] LEDR, output [7:0] HEX0, inout [15:0] ARDUINO_IO);
    assign ARDUINO_IO[15] = ~ARDUINO_IO[2];
    assign LEDR = {8'd0, ~KEY}; assign HEX0 = {KEY[0], 7'h7f}; endmodule
""")
        self.words = ("--project", str(folder / "top.qsf"))
        super().setUp()

    async def test_what_the_board_has_is_told_and_nothing_else_is_played(self):
        client = await self.client()
        await client.until(lambda: "board" in client.last, 120)
        board = client.last["board"]
        self.assertEqual(board["name"], "DE10-Lite")
        self.assertIn("HEX0[7]", board["wires"])
        self.assertNotIn("KEY[2]", board["wires"])
        self.assertEqual(board["names"]["GPIO_0"], "GPIO")
        self.assertIn("ARDUINO_IO[15]", board["wires"])
        await client.step("hold", {"key": 0})
        await client.until(lambda: client.last.get("lamps", {}).get("ledr") == 1)
        self.assertEqual(client.last["lamps"]["hex"][0], 0x80)  # the point
        self.assertEqual(board["leds"], [f"LEDR[{n}]" for n in range(10)])
        self.assertIn("ARDUINO_IO[15]", board["wires"])
        self.assertEqual(client.last["lamps"]["gpio"][2]["levels"] & 0xFFFF, 0x7FFF)
        await client.step("set-pins", {"arduino_io": 2, "level": "low"})
        await client.until(
            lambda: client.last["lamps"]["gpio"][2]["levels"] & 0xFFFF == 0xFFFB)
        await client.step("hold", {"key": 2})
        await client.until(lambda: "error" in client.last)
        self.assertIn("expected a step for what the DE10-Lite has", client.last["error"])


class InsideAProject(Live):
    def setUp(self):
        project = FOLDER / "project"
        project.mkdir(parents=True, exist_ok=True)
        (project / "top.v").write_text(SHORT_LINES)
        self.words = ("--project", str(project), "--strict-vga")
        super().setUp()

    async def test_violations_are_reported_as_they_happen(self):
        client = await self.client()
        await client.until(lambda: client.last.get("inside", {}).get("frames", 0) > 2, 120)
        self.assertNotIn("bus", client.last["inside"])
        inside = await self.paused(client)
        told = client.all["violation"]
        report = self.report()["timing_violations"]
        self.assertEqual(told, [f"VGA: {line}" for line in report["first"]])
        self.assertAlmostEqual(inside["vga_violations"], report["count"], delta=2)  # the last line


class Refused(Live):
    def get(self, path="/", **headers):
        connection = http.client.HTTPConnection(self.board.host, timeout=20)
        connection.request("GET", path, headers=headers)
        response = connection.getresponse()
        return response.status, response.read().decode()

    async def test_who_has_not_the_token_or_another_page(self):
        self.assertEqual(self.get()[0], 403)
        self.assertEqual(self.get(f"/?token={self.board.token}")[0], 200)
        self.assertEqual(self.get("/board.js", Host="evil.example")[0], 403)
        self.assertEqual(self.get("/../../etc/passwd")[0], 404)
        for options in ({"token": "0" * 32}, {"origin": "http://evil.example"}):
            with self.assertRaises(websockets.exceptions.InvalidHandshake) as refused:
                await self.board.connect(**options)
            self.assertIn("HTTP 403", str(refused.exception))

    async def test_wrong_messages_are_answered_and_the_run_goes_on(self):
        client = await self.client()
        for text, answer in (
                ("garbage", "expected an object in JSON, got garbage"),
                ('{"jump": 1}', "expected step, pause, speed"),
                ('{"speed": -1}', "expected step, pause, speed"),
                ('{"step": {"hold": {"keypad": "Z"}}}', "expected a keypad key"),
                ('{"step": {"release": {"key": 1}}}', "expected a control that is held"),
                ('{"step": {"expect-leds": 0}}', "not played live: expect-leds"),
                ('{"step": {"press-button": {"button": "a"}}}', "expected a button among the"),
                ('{"step": {"send-signal": "SIGHUP"}}', "expected a Linux program that gets"),
                ('{"step": {"take-screenshot": {"save-to": "a.png"}}}', "not played live: take"),
                ('{"step": {"play-file": "/etc/passwd"}}', "not played live: play-file")):
            await client.socket.send(text)
            self.assertIn(answer, await client.wait_for("error"))
        await client.socket.send(b"\0\1\2")
        self.assertIn("got a binary message", await client.wait_for("error"))
        await client.frames_on(1)

    async def test_a_huge_message_ends_its_sender_alone(self):
        first, second = await self.client(), await self.client()
        await first.socket.send("x" * 1_000_000)
        with self.assertRaises(websockets.exceptions.ConnectionClosed):
            await first.until(lambda: False)
        await second.frames_on(5)

    async def test_a_client_that_does_not_read_slows_nobody_down(self):
        """It loses pictures; another one has them all the while."""
        lazy = await self.board.connect(max_queue=1, close_timeout=0.2)
        self.addAsyncCleanup(lazy.close)
        client = await self.client()
        for key in "1", "2":
            await self.tap(client, key)
        memory = self.memory()
        await client.frames_on(90)
        maps = pathlib.Path(f"/proc/{self.board.process.pid}/maps").read_text()
        keeps = 100_000 if "libasan" in maps else 0  # what was freed, for a while
        self.assertLess(self.memory() - memory, 20_000 + keeps)

    def memory(self):
        """Of the server, in KiB."""
        status = pathlib.Path(f"/proc/{self.board.process.pid}/status").read_text()
        return int(status.split("VmRSS:")[1].split()[0])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
