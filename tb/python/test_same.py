"""test_same.py - the same calls give the same bytes, and `de1sim run` gives them once more."""
import hashlib
import json
import subprocess
import sys
import wave

PLAY = """
import sys
from de1sim import Board
with Board(options=["--frames", "last"]) as board:
    board.wait_text("ready")
    for key in "1234":
        board.keypad(key)
        board.wait_frame("new")
    board.hold(keypad=["5", "6"])
    board.run("37ms")
    board.release(keypad=["6", "5"])
    board.wait_hex("     6")
    board.wait_frame(3)
    print(board.time, board.frames, board.hex)
    board.save_picture("picture.png")
    board.sound().save("sound.wav")
    board.save("scenario.yaml")
"""
FILES = "picture.png", "sound.wav", "scenario.yaml"


def played(folder, nice=0):
    folder.mkdir()
    printed = subprocess.run(["nice", f"-{nice}", sys.executable, "-c", PLAY], cwd=folder,
                             check=True, capture_output=True, text=True).stdout
    return [printed, *((folder / name).read_bytes() for name in FILES)]


def frames(wav):
    with wave.open(str(wav)) as file:
        return file.readframes(file.getnframes())


def test_the_same_script_gives_the_same_bytes_and_its_scenario_too(tmp_path, tool):
    one = played(tmp_path / "one")
    assert played(tmp_path / "two", nice=10) == one
    again = tmp_path / "again"
    subprocess.run([tool, "run", tmp_path / "one/scenario.yaml", "--out", again, "--quiet",
                    "--frames", "last"], check=True)
    sound = frames(tmp_path / "one/sound.wav")
    assert len(sound) > 4 * 8000 * 0.4
    assert frames(again / "audio.wav")[:len(sound)] == sound
    report = json.loads((again / "report.json").read_text())
    assert report["final"]["hex"] == "     6"
    assert report["frames"]["last_sha256"] == pixels_sha256(tmp_path / "one/picture.png")


def pixels_sha256(png):
    """By another program's reading of the file."""
    rgb = subprocess.run(["ffmpeg", "-v", "error", "-i", png, "-f", "rawvideo", "-pix_fmt",
                          "rgb24", "-"], check=True, capture_output=True).stdout
    return hashlib.sha256(rgb).hexdigest()
