"""instant_test.py DE1SIM FOLDER PROGRAMS - a step at the instant of what an earlier one still does.

Keys are typed, 20 ms down and 20 ms up; another is pressed at each of these instants.  Played
again, what the keyboard sends comes in the same order.
"""
import asyncio
import pathlib
import subprocess
import sys

from board import Board, Client

DE1SIM, FOLDER, PROGRAMS = sys.argv[1], *map(pathlib.Path, sys.argv[2:4])
RUN = ("--elf", str(PROGRAMS / "linux" / "everything"), "--frames", "none")


async def play(board):
    client = Client(await board.connect())

    async def pass_ms(count):
        await client.send(run=f"{count}ms")
        await client.wait_for("ran")

    await pass_ms(700)  # the keyboard's self-test
    for instant in range(0, 140, 20):
        await client.step("type-keys", "abc")
        await pass_ms(instant)
        await client.step("press-key", "Left")
        await pass_ms(300)
    await client.send(save=True)
    saved = await client.wait_for("saved")
    await client.socket.close()
    return saved["file"]


with Board(DE1SIM, FOLDER, "--driven", *RUN) as board:
    file = asyncio.run(play(board))
again = FOLDER / "again"
subprocess.run([DE1SIM, "run", file, *RUN, "--quiet", "--out", again], check=True)
played, replayed = ((folder / "console.txt").read_text() for folder in (board.out, again))
if played.count("\n") < 50:
    sys.exit(f"expected the program to tell of each key, got {played}")
if played != replayed:
    sys.exit(f"{board.out}/console.txt and {again}/console.txt differ")
