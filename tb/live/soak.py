"""soak.py DE1SIM PROGRAM FOLDER MINUTES - `de1sim live` for long: memory, text.

Does memory grow, is text lost? PROGRAM is lines of tb/programs/linux, which runs as fast as it goes
for that many minutes. One client is there all the while; another comes and goes, sends steps, and
at times does not read. Each must have every line from its first on. The memory of both processes
is fitted with a line.
"""
import asyncio
import json
import pathlib
import random
import re
import statistics
import sys
import time

import websockets

from board import Board, Client

DE1SIM, PROGRAM, FOLDER = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
SECONDS = 60 * float(sys.argv[4])
LIMIT = 16 * 1024  # KiB per hour


class Lines:
    """The numbers of the lines, each one more than the one before."""

    def __init__(self):
        self.rest, self.next = "", None

    def take(self, text):
        *lines, self.rest = (self.rest + text).split("\n")
        for line in lines:
            if self.next is None:  # a greeting may begin within a line
                self.next = int(line.split()[-1]) if re.fullmatch(r"line \d{8}\r?", line) else None
            elif not re.fullmatch(rf"line {self.next:08d}\r?", line):
                raise AssertionError(f"expected line {self.next:08d}, got {line!r}")
            if self.next is not None:
                self.next += 1


async def follow(client, lines, end):
    """Reads until then; the client keeps nothing of it."""
    while time.monotonic() < end:
        client.console, client.all = "", {}
        await asyncio.wait_for(client.take(), 30)
        lines.take(client.console)


async def come_and_go(board, end, sent):
    dice, visits = random.Random(1), 0
    while time.monotonic() < end - 3:
        client = Client(await board.connect(max_queue=8))
        for _ in range(dice.randrange(4)):
            await client.step(*dice.choice((("press", {"keypad": "1", "for": "20ms"}),
                                            ("move-mouse", {"right": 3, "for": "10ms"}),
                                            ("set-voltage", {"channel": 1, "volts": 2.5}),
                                            ("type-serial", {"text": "x", "to": "jtag-1"}))))
            sent.append(time.monotonic())
        if dice.randrange(3):
            await follow(client, Lines(), time.monotonic() + 2 * dice.random())
        else:
            await asyncio.sleep(dice.random())  # does not read
        if dice.randrange(2):
            client.socket.transport.abort()
            await client.socket.wait_closed()
        else:
            await client.socket.close()
        visits += 1
        await asyncio.sleep(dice.random())
    return visits


def resident(process):
    text = pathlib.Path(f"/proc/{process}/status").read_text()
    return int(text.split("VmRSS:")[1].split()[0])  # KiB


async def watch(board, end, memory):
    children = pathlib.Path(f"/proc/{board.process.pid}/task/{board.process.pid}/children")
    begin = time.monotonic()
    while time.monotonic() < end:
        simulation = int(children.read_text().split()[0])
        memory.append((time.monotonic() - begin, resident(board.process.pid), resident(simulation)))
        await asyncio.sleep(max(1, SECONDS / 600))


async def main():
    with Board(DE1SIM, FOLDER, "--elf", PROGRAM) as board:
        end = time.monotonic() + SECONDS
        memory, sent, lines = [], [], Lines()
        client = Client(await board.connect())
        await client.send(speed=0)
        _, visits, _ = await asyncio.gather(follow(client, lines, end),
                                            come_and_go(board, end, sent),
                                            watch(board, end, memory))
        await client.wait_for("status")
        status = client.last["status"]
        await client.socket.close()
    wrong = []
    print(f"{SECONDS / 60:.1f} minutes, {status['time']:.0f} s simulated, {lines.next} lines, "
          f"{visits} visits, {len(sent)} steps sent, {status['steps']} recorded")
    if status["steps"] != len(sent):
        wrong.append("steps were lost")
    settled = [row for row in memory if row[0] > SECONDS / 5]
    for name, column in (("server", 1), ("simulation", 2)):
        times, sizes = [row[0] for row in settled], [row[column] for row in settled]
        slope, _ = statistics.linear_regression(times, sizes)
        print(f"{name}: {min(sizes)} to {max(sizes)} KiB after the first fifth, "
              f"{3600 * slope:+.0f} KiB per hour")
        if 3600 * slope > LIMIT and max(sizes) - min(sizes) > 2048:
            wrong.append(f"the {name} grows by more than {LIMIT} KiB per hour")
    (FOLDER / "memory.json").write_text(json.dumps(memory))
    sys.exit("; ".join(wrong))


try:
    asyncio.run(main())
except websockets.exceptions.ConnectionClosed as closed:
    sys.exit(f"a client was disconnected: {closed}")
