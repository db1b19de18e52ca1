"""test_plugin.py - pytest with the fixture `board`: a failed test leaves what it saw."""
import subprocess
import sys

TEST = """
import pytest

@pytest.mark.board(options=["--frames", "none"])
def test_passes(board):
    board.run("1ms")

def test_fails(board):
    board.keypad("1")
    board.wait_frame("new")
    assert board.hex == "     2"
"""


def test_a_failed_test_leaves_picture_and_scenario(tmp_path, tool):
    (tmp_path / "conftest.py").write_text('pytest_plugins = ["de1sim.pytest_plugin"]\n')
    (tmp_path / "test_it.py").write_text(TEST)
    done = subprocess.run([sys.executable, "-B", "-m", "pytest", "-p", "no:cacheprovider"],
                          cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 1, done.stdout
    assert "1 failed, 1 passed" in done.stdout
    assert "LEDR 0000000000, HEX '     1', printed last 'ready" in done.stdout
    left, = (tmp_path / "board-failures").iterdir()
    assert left.name == "test_it.py_test_fails"
    assert sorted(file.name for file in left.iterdir()) == ["console.txt", "picture.png",
                                                            "scenario.yaml"]
    assert (left / "picture.png").read_bytes()[:4] == b"\x89PNG"
    subprocess.run([tool, "run", left / "scenario.yaml", "--quiet", "--out", tmp_path / "out"],
                   check=True)
