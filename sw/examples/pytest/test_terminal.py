"""test_terminal.py - a program at the terminal: it prompts, and sends back what is typed."""
import pytest

pytestmark = pytest.mark.board(elf="../jtag_uart/jtag_uart.elf")


def test_what_is_typed_comes_back(board):
    board.wait_text("\n> ")
    board.type("Hello, board\n")
    board.wait_text("Hello, board\n> ")


@pytest.mark.parametrize("text", ["a", "four", "a longer line"])
def test_the_leds_count_the_characters(board, text):
    board.wait_text("> ")
    board.type(text)
    board.wait_leds(0x200 | len(text))
