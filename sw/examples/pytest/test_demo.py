"""test_demo.py - the demo: shapes by the keypad, and the picture that shows them."""


def test_each_key_adds_a_shape(board):
    board.wait_text("ready")
    for count, key in enumerate(["1", "2", "3"], 1):
        board.keypad(key)
        board.wait_hex(f"{count:6}")


def test_a_shape_is_on_the_monitor(board):
    board.wait_frame("new")
    before = board.picture
    board.keypad("1")
    board.wait_hex("     1")
    board.wait_frame("new")
    changed = (board.picture != before).any(axis=2)  # an array of the rows, with numpy
    assert 100 < changed.sum() < 0.2 * changed.size


def test_shapes_that_collide_are_heard(board):
    board.run("100ms")
    board.sound()  # nothing of what was before
    for key in "1234560":
        board.keypad(key)
    board.run("1s")
    sound = board.sound()
    assert sound.rate_hz == 8000
    assert abs(sound.samples).max() > 1000
