"""board.py - a board that `de1sim live` simulates, and a client of its protocol.

The protocol is in sim/live/README.md.
"""
import asyncio
import json
import pathlib
import re
import signal
import struct
import subprocess
import time

import websockets

PICTURE, SOUND = 1, 2


class Board:
    """The server's process; `with` ends it."""

    def __init__(self, de1sim, folder, *words, out=None, **options):
        """`options` are those of subprocess.Popen."""
        folder.mkdir(parents=True, exist_ok=True)
        self.out = out or folder / "out"
        self.errors = open(folder / "stderr.txt", "w+", encoding="utf-8")
        self.process = subprocess.Popen([de1sim, "live", "--out", str(self.out), *words],
                                        stderr=self.errors, cwd=folder, **options)
        end = time.monotonic() + 60
        while not (found := re.search(r"http://(\S+)/\?token=(\w+)", self.said())):
            if self.process.poll() is not None or time.monotonic() > end:
                raise RuntimeError(self.said())
            time.sleep(0.02)
        self.host, self.token = found.groups()
        self.url = found.group()

    def said(self):
        self.errors.flush()
        return pathlib.Path(self.errors.name).read_text(encoding="utf-8")

    def connect(self, token=None, **options):
        return websockets.connect(f"ws://{self.host}/ws?token={token or self.token}",
                                  max_size=None, ping_interval=None,  # tests block for long
                                  **{"close_timeout": 0.2, **options})

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        self.process.wait(30)
        self.errors.close()


class Client:
    """What a page knows, from the messages that came."""

    def __init__(self, socket):
        self.socket = socket
        self.width = self.height = self.frame = self.pictures = self.samples = self.bytes = 0
        self.console, self.last, self.all = "", {}, {}  # of each name the last value, and all

    async def send(self, **message):
        await self.socket.send(json.dumps(message))

    async def step(self, name, value):
        await self.send(step={name: value})

    async def take(self):
        message = await self.socket.recv()
        self.bytes += len(message)
        if isinstance(message, str):
            for name, value in json.loads(message).items():
                self.last[name] = value
                self.all.setdefault(name, []).append(value)
                if name == "console":
                    self.console += value
        elif message[0] == PICTURE and len(message) > 1:
            self.width, self.height, self.frame = struct.unpack_from("<HHI", message, 1)
            self.pictures += 1
        elif message[0] == SOUND:
            self.samples += (len(message) - 5) // 4

    async def until(self, met, seconds=300):
        async def wait():
            while not met():
                await self.take()
        await asyncio.wait_for(wait(), seconds)

    async def wait_for(self, name, seconds=300):
        self.last.pop(name, None)
        await self.until(lambda: name in self.last, seconds)
        return self.last[name]

    def frames(self):
        """That the monitor has shown, new pictures or not."""
        return self.last.get("status", {}).get("frames", 0)

    async def frames_on(self, count):
        end = self.frames() + count
        await self.until(lambda: self.frames() >= end)

    def hex(self):
        return self.last.get("lamps", {}).get("hex_text", "")
