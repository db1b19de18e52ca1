"""test_pong.py - a Quartus project: SW0 holds the ball, KEY3 and KEY2 move the left bat.

It takes Verilator and a C++ compiler: the first test builds the project.
"""
import pathlib
import shutil

import pytest

BAT_X = 28  # of the left bat's middle
INSTALLED = pathlib.Path("/usr/share/de1sim/rtl/examples/pong")


@pytest.fixture(scope="session")
def project(tmp_path_factory):
    """A copy, since what is built lies beside the project."""
    here = pathlib.Path(__file__).resolve().parents
    places = [here[2] / "rtl/examples/pong", here[3] / "rtl/examples/pong", INSTALLED]
    place = next(place for place in places if place.exists())
    return shutil.copytree(place, tmp_path_factory.mktemp("project") / "pong") / "pong.qsf"


def bat_top(board):
    return board.picture[:, BAT_X].any(axis=1).argmax()


def test_key3_moves_the_bat_up_and_key2_down(start_board, project):
    board = start_board(project=project)
    board.hold(switch=0)
    board.wait_frame(3)
    begin = bat_top(board)
    board.press(key=3, for_="200ms")
    board.wait_frame(2)
    up = bat_top(board)
    board.press(key=2, for_="200ms")
    board.wait_frame(2)
    assert up < begin
    assert up < bat_top(board) <= begin + 8


def test_a_ball_that_is_missed_is_a_point(start_board, project):
    board = start_board(project=project)
    board.press(key=3, for_="200ms")
    assert board.hex == "0    0"
    board.wait_hex("1    0", timeout="3s")
    assert board.time < 2
