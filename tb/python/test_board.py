"""test_board.py - what a board does, shows and refuses."""
import os
import pathlib
import re
import subprocess
import sys
import time

import pytest
import de1sim
from de1sim.connection import Connection
from de1sim.digits import GLYPHS

ROOT = pathlib.Path(__file__).resolve().parents[2]


def test_time_stands_but_for_what_a_method_lets_pass(board):
    assert board.time == 3e-9  # between the clocks
    board.hold(keypad="1")
    assert board.time == 3e-9
    board.run("20ms")
    board.press(key=0, for_="50ms")
    time.sleep(0.3)
    board.step({"release": {"keypad": "1"}})
    assert board.time == pytest.approx(0.07, abs=1e-8)


def test_what_cannot_be_done_is_refused_in_the_servers_words(board):
    for wrong, words in (
            (lambda: board.keypad("Z"), "expected a keypad key, 0-9 or A-F, got \"Z\""),
            (lambda: board.release(key=1), "expected a control that is held"),
            (lambda: board.step({"play-file": "/etc/passwd"}), "not played live: play-file"),
            (lambda: board.run("1us"), "expected a time of whole milliseconds"),
            (lambda: board.wait_frame("old"), "expected a number of frames above 0, or \"new\"")):
        with pytest.raises(de1sim.Refused, match=re.escape(words)):
            wrong()
    board.keypad("1")  # it goes on
    board.wait_hex("     1")


def test_a_timeout_says_what_was_expected_and_what_there_is(board):
    board.wait_text("ready")
    begin = board.time
    with pytest.raises(de1sim.Timeout, match=r"expected 'never' on serial within 30ms; at 0\.031 s "
                       r"LEDR 0000000000, HEX '     0', printed last 'ready\\r\\n'"):
        board.wait_text("never", timeout="30ms", on="serial")
    assert board.time - begin == pytest.approx(0.03)


def test_a_terminal_of_the_parts_is_read_and_typed_at(tmp_path):
    (tmp_path / "top.v").write_text("module top(inout [35:0] GPIO_0);\n"
                                    "assign GPIO_0[1] = GPIO_0[3];\nendmodule\n")
    (tmp_path / "s.yaml").write_text(
        "name: s\nversion: 1\nparts:\n  - terminal: {name: echo, rx: \"GPIO_0[1]\", "
        "tx: \"GPIO_0[3]\", baud: 115200}\nsteps:\n  - delay: 1ms\n")
    with de1sim.Board(project=tmp_path, scenario=tmp_path / "s.yaml",
                      out=tmp_path / "out") as board:
        assert board.terminals["echo"] == ""
        assert board.parts == {"echo": {"kind": "terminal"}}
        board.step({"type-serial": {"text": "hello", "to": "echo"}})
        board.wait_text("hel", on="echo")
        board.wait_text("lo")
        assert board.terminals["echo"] == "hello"


@pytest.mark.parametrize("what, words", [
    ({"elf": "nowhere.elf"}, "nowhere.elf: no such file"),
    ({"elf": __file__}, "is not a program (ELF file)"),
    ({"options": ["--cpi", "0"]}, "--cpi"),
    ({"board": "DE9"}, "board DE9: there is no such board"),
    ({"de1sim": "/nowhere/de1sim"}, "cannot start /nowhere/de1sim: No such file"),
])
def test_a_board_that_cannot_begin_is_refused(what, words):
    with pytest.raises(de1sim.Refused, match=re.escape(words)):
        de1sim.Board(**what)


def test_a_board_that_ended_before_the_connection_is_refused(monkeypatch):
    connect = Connection._connect

    def connect_late(self):
        time.sleep(1)
        connect(self)
    monkeypatch.setattr(Connection, "_connect", connect_late)
    with pytest.raises(de1sim.Refused, match="--cpi"):
        de1sim.Board(options=["--cpi", "0"])


def test_a_scenario_plays_first(start_board, tmp_path):
    (tmp_path / "s.yaml").write_text("name: s\nversion: 1\nsteps:\n  - press: {keypad: 1}\n"
                                     "  - delay: 250ms\n")
    board = start_board(scenario=tmp_path / "s.yaml")
    assert 0.35 <= board.time < 0.352
    assert board.hex == "     1"
    board.keypad("2")
    assert "delay: 250ms" in board.save()


def test_a_scenario_plays_first_on_a_program(start_board, programs, tmp_path):
    (tmp_path / "s.yaml").write_text("name: s\nversion: 1\nsteps:\n"
                                     "  - type-serial: {text: b, to: jtag-1}\n"
                                     "  - delay: 250ms\n")
    board = start_board(scenario=tmp_path / "s.yaml", elf=programs / "terminals.elf")
    assert board.terminals["jtag-1"] == "+b"


def test_another_board_refuses_steps_for_what_it_has_not(start_board, programs, tmp_path):
    (tmp_path / "s.yaml").write_text("name: s\nversion: 1\nboard: DE10-Lite\nduration: 1ms\n")
    for named in {"board": "de10-lite"}, {"scenario": tmp_path / "s.yaml"}:
        board = start_board(elf=programs / "nios_v_sums.elf", **named)
        with pytest.raises(de1sim.Refused, match="a step for what the DE10-Lite has"):
            board.hold(key=2)


def test_the_sound_of_a_long_step_is_whole(board):
    board.press(keypad=["1", "2"], for_="3s")
    board.run("2s")
    assert board.sound().seconds == pytest.approx(5, abs=0.02)
    assert len(board.sound()) == 0


def test_each_terminal_has_its_own_text(start_board, programs):
    board = start_board(elf=programs / "terminals.elf")
    for line, text, answer in ("jtag-1", "d", "+d"), ("serial", "a", "+a"), ("jtag-1", "e", "+e"):
        board.type(text, to=line)
        board.wait_text(answer, on=line)
    assert board.terminals["jtag-1"] == "+d+e"
    assert len(board.console) == sum(map(len, board.terminals.values()))


def test_a_program_for_nios_v_is_played_and_saved(start_board, programs, tmp_path, tool):
    board = start_board(elf=programs / "nios_v_mistakes.elf")
    board.run("3ms")
    assert board.leds == 0
    board.press(key=0, for_="1ms")
    board.wait_leds(0x3FF)
    board.save(tmp_path / "saved.yaml")
    subprocess.run([tool, "run", tmp_path / "saved.yaml", "--elf", programs / "nios_v_mistakes.elf",
                    "--out", tmp_path / "out"], check=True)


def test_a_program_that_dies_is_a_fault(start_board, programs):
    board = start_board(elf=programs / "dies.elf")
    with pytest.raises(de1sim.Fault, match="PC 0x"):
        board.run("1s")


def test_closing_leaves_nothing_behind(tool):
    board = de1sim.Board()
    folder = board.out
    processes = running(tool)
    board.close()
    board.close()
    assert not folder.exists() and len(running(tool)) < len(processes)
    with pytest.raises(de1sim.Ended, match="closed"):
        board.run("1ms")


def test_a_script_that_is_killed_leaves_no_process_behind(tool):
    script = subprocess.Popen([sys.executable, "-c", "import de1sim, time\nboard = de1sim.Board()\n"
                               "print(board.url, flush=True)\ntime.sleep(60)"],
                              stdout=subprocess.PIPE, text=True)
    port = re.search(r":(\d+)/", script.stdout.readline())[1]
    script.kill()
    script.wait()
    script.stdout.close()
    end = time.monotonic() + 20
    while time.monotonic() < end and f":{int(port):04X} 00000000:0000 0A" in listening():
        time.sleep(0.05)
    assert f":{int(port):04X} 00000000:0000 0A" not in listening()


def running(tool):
    """Processes of the tool that this one has started."""
    found = []
    for status in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            if os.readlink(status / "exe") == os.path.realpath(tool) and \
                    f"PPid:\t{os.getpid()}\n" in (status / "status").read_text():
                found.append(status.name)
        except OSError:
            pass
    return found


def listening():
    return pathlib.Path("/proc/net/tcp").read_text()


def test_without_numpy_there_are_picture_and_sound_all_the_same(tmp_path):
    (tmp_path / "numpy.py").write_text("raise ImportError\n")
    script = ("import de1sim\nwith de1sim.Board() as b:\n    b.run('100ms')\n"
              "    p = b.picture\n    print(p.width, p.height, len(p.rgb), p[0, 0],"
              " b.sound().samples[:2])\n")
    path = f"{tmp_path}{os.pathsep}{os.environ['PYTHONPATH']}"
    printed = subprocess.run([sys.executable, "-c", script], check=True, capture_output=True,
                             text=True, env={**os.environ, "PYTHONPATH": path}).stdout
    assert printed.startswith("640 480 921600 (")
    assert printed.endswith("[(0, 0), (0, 0)]\n")


def test_digits_read_as_in_reports():
    header = (ROOT / "sim/scenario/seven_segment.h").read_text()
    table = re.findall(r"\{'(.)', 0x([0-9A-F]{2})\}", header)
    assert [(character, int(lit, 16)) for character, lit in table] == list(GLYPHS)
