"""test_pong.py - a Quartus project: KEY3 moves the left bat out of the ball's way.

It takes Verilator and a C++ compiler: the test builds the project.
"""
import pathlib
import shutil

import pytest

INSTALLED = pathlib.Path("/usr/share/de1sim/rtl/examples/pong")


@pytest.fixture(scope="session")
def project(tmp_path_factory):
    """A copy, since what is built lies beside the project."""
    above = pathlib.Path(__file__).resolve().parents
    places = [*(folder / "rtl/examples/pong" for folder in above), INSTALLED]
    place = next(place for place in places if place.exists())
    return shutil.copytree(place, tmp_path_factory.mktemp("project") / "pong",
                           ignore=shutil.ignore_patterns(".de1sim")) / "pong.qsf"


def test_a_ball_that_is_missed_is_a_point(start_board, project):
    board = start_board(project=project)
    board.press(key=3, for_="200ms")
    assert board.hex == "0    0"
    board.wait_hex("1    0", timeout="3s")
    assert board.time < 2
