"""pytest_plugin.py - the fixture `board`, and what a failed test leaves behind.

In the topmost conftest.py:

    pytest_plugins = ["de1sim.pytest_plugin"]
"""
import pathlib
import re
import shutil

import pytest

from .board import Board
from .errors import Error

FILES = ("elf", "project", "scenario")
BOARDS = pytest.StashKey()


def pytest_configure(config):
    config.addinivalue_line("markers", "board(elf=..., project=..., scenario=..., board=..., "
                            "options=[...]): what runs on the fixture `board`; files as seen from "
                            "the test's")


def pytest_addoption(parser):
    parser.getgroup("de1sim").addoption(
        "--board-failures", default="board-failures", metavar="DIR",
        help="where a failed test leaves picture, sound, console and scenario")


@pytest.fixture
def start_board(request):
    """Starts boards: start_board(elf="program.elf"); they end with the test."""
    boards = request.node.stash.setdefault(BOARDS, [])

    def start(**what):
        for name in FILES:
            if what.get(name) is not None:
                what[name] = request.path.parent / what[name]
        boards.append(Board(**what))
        return boards[-1]
    yield start
    for board in boards:
        board.close()


@pytest.fixture
def board(request, start_board):
    """A board with what the marker `board` says, or the demo; time stands at 0."""
    marker = request.node.get_closest_marker("board")
    return start_board(**(marker.kwargs if marker else {}))


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item, call):
    report = (yield).get_result()
    boards = item.stash.get(BOARDS, [])
    if call.when != "call" or not report.failed or not boards:
        return
    place = pathlib.Path(item.config.getoption("--board-failures"))
    place = item.config.invocation_params.dir / place / re.sub(r"[^\w.-]+", "_", item.nodeid)
    shutil.rmtree(place, ignore_errors=True)
    for number, one in enumerate(boards):
        folder = place if len(boards) == 1 else place / str(number)
        folder.mkdir(parents=True)
        report.sections.append((f"board in {folder}", leave_behind(one, folder)))


def leave_behind(board, folder):
    """Files of what the board shows; a text that says so."""
    lines = [f"at {board.time:.3f} s: {board.summary()}", *board.log, *board.violations]
    if board.save_picture(folder / "picture.png"):
        lines.append("picture.png: the monitor")
    (folder / "console.txt").write_text(board.console, "utf-8")
    try:
        board.save(folder / "scenario.yaml")
        lines.append("scenario.yaml: what was played, for de1sim run with the same options")
    except Error as error:
        lines.append(f"no scenario: {error}")
    return "\n".join(lines)
