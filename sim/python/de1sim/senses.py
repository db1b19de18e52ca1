"""senses.py - what a person sees, reads and hears of the board, gathered from its messages."""
import pathlib
import struct

from .digits import digits_text
from .picture import Screen
from .sound import Sound

LINES = ("serial", "jtag-0", "jtag-1")
PICTURE, SOUND = 1, 2


class Senses:
    def __init__(self):
        self.time = 0.0  # simulated, in seconds
        self.frames = self.pictures = 0  # shown; those that differed from the one before
        self.leds = 0  # LEDR9 to LEDR0 in bits 9 to 0
        self.segments = [0] * 6  # of HEX0 to HEX5; bit 0 is segment 0
        self.hps_led = False
        self.gpio = []  # of GPIO_0 and GPIO_1: levels, outputs
        self.console = ""  # what all lines have printed
        self.terminals = dict.fromkeys(LINES, "")  # what each has, and terminals of the parts
        self.parts = {}  # on the headers, by name: {"kind": "led-matrix", "rows": [...]}
        self.log, self.violations, self.faults = [], [], []
        self._searched = {}  # by line, None: all in one; how far
        self._screen = Screen()
        self._sound, self._rate_hz = bytearray(), 0

    @property
    def hex(self):
        """The six digits, HEX5 first: "    12"."""
        return digits_text(self.segments)

    def shows(self, digits):
        """Whether HEX reads so; 6, 7, 9 have two forms each, and one of 6 is also B."""
        return digits_text(self.segments, digits) == digits

    @property
    def picture(self):
        """Of the monitor: an array [y, x, colour], or a Picture without numpy, or None before."""
        return self._screen.picture()

    def save_picture(self, path):
        """A PNG; False if there has been no picture yet."""
        if self._screen.width:
            pathlib.Path(path).write_bytes(self._screen.png())
        return self._screen.width > 0

    def sound(self):
        """What was played since the last call."""
        sound = Sound(self._rate_hz, bytes(self._sound))
        self._sound.clear()
        return sound

    def summary(self):
        """In a line, for messages."""
        printed = f", printed last {self.console[-60:]!r}" if self.console else ""
        return f"LEDR {self.leds:010b}, HEX {self.hex!r}{printed}"

    def _find(self, text, line):
        lines = [None, *(name for name in self.terminals if name not in LINES)]
        for name in lines if line is None else [line]:
            printed = self.console if name is None else self.terminals.get(name, "")
            at = printed.find(text, self._searched.get(name, 0))
            if at >= 0:
                self._searched[name] = at + len(text)
                return True
        return False

    def _take(self, message):
        if isinstance(message, bytes):
            if message[0] == PICTURE and len(message) > 1:
                self._screen.take(message)
            elif message[0] == SOUND:
                self._rate_hz, = struct.unpack_from("<I", message, 1)
                self._sound += message[5:]
            return
        for name, value in message.items():
            if name == "ran":
                self.time, self.frames = round(value["time"], 12), value["frames"]
                self.pictures = value["pictures"]
            elif name == "lamps":
                self.leds, self.segments = value["ledr"], value["hex"]
                self.hps_led, self.gpio = value["hps_led"], value["gpio"]
            elif name == "console":
                self.console += value
            elif name == "parts":
                for part, news in value.items():
                    self.parts.setdefault(part, {}).update(news)
                    if news.get("kind") == "terminal":
                        self.terminals.setdefault(part, "")
            elif name == "terminals":
                for line, text in value.items():
                    self.terminals[line] = self.terminals.get(line, "") + text
            elif name in ("log", "violation", "fault"):
                {"log": self.log, "violation": self.violations,
                 "fault": self.faults}[name].append(value)
