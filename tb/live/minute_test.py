"""minute_test.py DE1SIM FOLDER PROGRAMS [SECONDS] - play with all inputs, saved and replayed.

Fifty inputs, spread over so many simulated seconds, 60. The replay has to give the same last
picture, sound, text and report, byte for byte.
"""
import asyncio
import json
import pathlib
import random
import subprocess
import sys

from board import Board, Client

DE1SIM, FOLDER, PROGRAMS = sys.argv[1], *map(pathlib.Path, sys.argv[2:4])
SECONDS = float(sys.argv[4]) if len(sys.argv) > 4 else 60
RUN = ("--elf", str(PROGRAMS / "linux" / "everything"), "--frames", "last")


def inputs():
    """Ten rounds of five; what is held in one is let go in the next."""
    held = None
    for number in range(10):
        yield "press", {"keypad": "123A456B78"[number], "for": "60ms"}
        if held:
            yield "release", held
        else:
            yield "click-mouse", "left"
        held = None if held else ({"key": number % 4}, {"switch": number % 10})[number // 2 % 2]
        yield ("hold", held) if held else ("turn-wheel", 2)
        yield (("type-keys", f"key {number}"), ("press-key", "Left"))[number % 2]
        yield (("move-mouse", {"right": 20 + number, "down": 5, "for": "30ms"}),
               ("set-voltage", {"channel": number % 8, "volts": 0.3 * number}),
               ("type-serial", {"text": f"to {number}\n", "to": "jtag-1"}),
               ("type-serial", {"text": f"go {number}\n"}),
               ("type-serial", {"text": f"on {number}\n", "to": "serial"}))[number % 5]


async def play(board):
    client, dice = Client(await board.connect()), random.Random(4)
    await client.until(lambda: "ready" in client.console)
    await client.send(speed=0)
    await client.wait_for("status")
    count = 0
    for name, value in inputs():
        count += 1
        due = SECONDS * (count - dice.random() / 2) / 50
        await client.until(lambda: client.last["status"]["time"] >= due, 600)
        await client.step(name, value)
    await client.until(lambda: client.last["status"]["time"] >= SECONDS, 600)
    await client.send(pause=True)
    await client.until(lambda: client.last["status"]["paused"])
    if "error" in client.last or client.last["status"]["steps"] != 50:
        sys.exit(f"expected 50 steps, got {client.last}")
    await client.send(save=True)
    saved = await client.wait_for("saved")
    await client.socket.close()
    return saved["file"]


with Board(DE1SIM, FOLDER, *RUN) as board:
    file = asyncio.run(play(board))
again = FOLDER / "again"
subprocess.run([DE1SIM, "run", file, *RUN, "--quiet", "--out", again], check=True)
reports = [json.loads((folder / "report.json").read_text()) for folder in (board.out, again)]
for report in reports:
    for name in "scenario", "file", "end", "wall":
        del report[name]
if reports[0] != reports[1]:
    sys.exit(f"the reports differ: {board.out}, {again}")
for name in ("audio.wav", "console.txt", "frames"):
    files = sorted((board.out / name).glob("*")) or [board.out / name]
    for live in files:
        if live.read_bytes() != (again / live.relative_to(board.out)).read_bytes():
            sys.exit(f"{live} differs from that in {again}")
reacted = (board.out / "console.txt").read_text().count("\n") - 1
if reacted < 50:
    sys.exit(f"expected the program to react to each of 50 inputs, got {reacted} lines")
