"""hands.py - what a person does at the board: each a step of a scenario, in no other way.

A method returns when its step is over: press() has let time pass, hold() has not.
"""


def _without_none(**fields):
    return {name: value for name, value in fields.items() if value is not None}


class Hands:
    """For a class with step()."""

    def press(self, key=None, keypad=None, switch=None, for_=None):
        """Contacts are held for a while, 100 ms if not told; lists are chords."""
        self.step({"press": _without_none(key=key, keypad=keypad, switch=switch, **{"for": for_})})

    def hold(self, key=None, keypad=None, switch=None):
        self.step({"hold": _without_none(key=key, keypad=keypad, switch=switch)})

    def release(self, key=None, keypad=None, switch=None):
        self.step({"release": _without_none(key=key, keypad=keypad, switch=switch)})

    def keypad(self, key, for_="80ms"):
        """A key of the keypad, "0" to "F", or a list."""
        self.press(keypad=key, for_=for_)

    def type(self, text, to=None):
        """At a terminal: serial, jtag-0, jtag-1 or one of the parts; if not told, where programs
        listen."""
        self.step({"type-serial": _without_none(text=text, to=to)})

    def send_signal(self, name, process=None):
        """To a Linux program, such as "SIGUSR1"; or to one of its processes by its number."""
        self.step({"send-signal": _without_none(name=name, process=process)})

    def type_keys(self, text, to=None):
        """On the PS/2 keyboard; to="usb": on a Linux program's USB keyboard alone."""
        self.step({"type-keys": _without_none(text=text, to=to)})

    def press_key(self, key, for_=None, to=None):
        """A key of a keyboard, such as "Left", or a list."""
        self.step({"press-key": _without_none(key=key, to=to, **{"for": for_})})

    def hold_key(self, key, to=None):
        self.step({"hold-key": _without_none(key=key, to=to)})

    def release_key(self, key, to=None):
        self.step({"release-key": _without_none(key=key, to=to)})

    def move_mouse(self, right=None, down=None, for_=None, to=None):
        self.step({"move-mouse": _without_none(right=right, down=down, to=to, **{"for": for_})})

    def click_mouse(self, button="left", to=None):
        self.step({"click-mouse": _without_none(button=button, to=to)})

    def press_pad_button(self, button, for_=None, pad=None):
        """Of a USB gamepad; where there are two, of the pad 1 or 2."""
        self.step({"press-pad-button": _without_none(button=button, pad=pad, **{"for": for_})})

    def move_stick(self, stick, right=0, down=0, pad=None):
        """In percent; it stays there."""
        self.step({"move-stick": _without_none(stick=stick, right=right, down=down, pad=pad)})

    def tilt_board(self, right=0, towards=0):
        """Degrees; the accelerometer feels it."""
        self.step({"tilt-board": {"right": right, "towards": towards}})

    def set_voltage(self, channel, volts):
        """At the AD converter."""
        self.step({"set-voltage": {"channel": channel, "volts": volts}})
