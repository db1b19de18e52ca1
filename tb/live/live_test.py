"""live_test.py DE1SIM FOLDER - `de1sim live` by its protocol: who may, what is kept."""
import asyncio
import http.client
import json
import pathlib
import subprocess
import sys
import unittest

import websockets

from board import Board, Client

DE1SIM, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])


class Live(unittest.IsolatedAsyncioTestCase):
    words = ()

    def setUp(self):
        self.folder = FOLDER / self.id().split(".")[-1]
        self.board = Board(DE1SIM, self.folder, *self.words)
        self.addCleanup(self.board.__exit__)

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
        self.assertEqual(client.frame, 1)

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
            with self.assertRaises(websockets.exceptions.InvalidStatusCode) as refused:
                await self.board.connect(**options)
            self.assertEqual(refused.exception.status_code, 403)

    async def test_wrong_messages_are_answered_and_the_run_goes_on(self):
        client = await self.client()
        for text, answer in (
                ("garbage", "expected an object in JSON, got garbage"),
                ('{"jump": 1}', "expected step, pause, speed"),
                ('{"speed": -1}', "expected step, pause, speed"),
                ('{"step": {"hold": {"keypad": "Z"}}}', "expected a keypad key"),
                ('{"step": {"release": {"key": 1}}}', "expected a control that is held"),
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
        self.assertLess(self.memory() - memory, 20_000)

    def memory(self):
        """Of the server, in KiB."""
        status = pathlib.Path(f"/proc/{self.board.process.pid}/status").read_text()
        return int(status.split("VmRSS:")[1].split()[0])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
