"""board.py - a board to play: time stands, but for what a method lets pass."""
import os
import pathlib
import shutil
import tempfile
import weakref

from .connection import Connection
from .errors import Ended, Fault, Refused, Timeout
from .hands import Hands
from .moment import milliseconds
from .senses import Senses

LONGEST_MS = 10_000  # that a message "run" may ask for


class Board(Hands, Senses):
    """With the demo, or a program `elf`, or a Quartus `project`; `scenario` plays first.

    `board` is another than the DE1-SoC: "de10-lite".
    `options` are those of `de1sim run`.  What a run writes is in `out`, and gone with the board
    where that is not given.  To be closed, or used in `with`.
    """

    def __init__(self, elf=None, project=None, scenario=None, options=(), out=None, de1sim=None,
                 board=None):
        super().__init__()
        for file in elf, project, scenario:
            if file is not None and not os.path.exists(file):
                raise Refused(f"{file}: no such file")
        own = tempfile.mkdtemp(prefix="de1sim-") if out is None else None
        self.out = pathlib.Path(own or out)
        words = [] if scenario is None else [os.fspath(scenario)]
        for option, value in (("--elf", elf), ("--project", project), ("--board", board),
                              ("--out", self.out)):
            words += [] if value is None else [option, os.fspath(value)]
        self._connection = None
        try:
            self._connection = Connection([*words, *map(os.fspath, options)], de1sim)
            self._close = weakref.finalize(self, _close, self._connection, own)
            self._connection.send(speed=0)
            self._run("0ms")
            if scenario is not None:
                while "steps" not in self._run(f"{LONGEST_MS}ms", "steps"):
                    pass
        except BaseException as error:
            _close(self._connection, own)
            if isinstance(error, Ended) and not isinstance(error, Fault) and not self.time:
                raise Refused(str(error)) from None
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        """Ends the simulation; what the board showed last can still be read."""
        self._close()

    @property
    def url(self):
        """Of the page on which a person can look on."""
        return self._connection.url

    # ---- Time ----

    def run(self, time):
        """Lets exactly this time pass, such as "20ms"."""
        self._run_until(milliseconds(time), [], lambda: False)

    def wait(self, met, timeout="1s", what=None, pins=False):
        """Lets time pass until met() is true, which is asked when something has changed.

        That is the picture, LEDs, digits and what is printed; with `pins` those of the headers.
        `what` is for the message of Timeout.
        """
        if met():
            return
        changes = ["picture", "printed", "lamps", *(["pins"] if pins else [])]
        if not self._run_until(milliseconds(timeout), changes, met):
            raise Timeout(f"expected {what or 'what was waited for'} within {timeout}; at "
                          f"{self.time:.3f} s {self.summary()}")

    def wait_frame(self, which=1, timeout="1s"):
        """Until the monitor has shown so many frames more, or "new": one that differs."""
        if which == "new":
            until, count, goal = "picture", lambda: self.pictures, self.pictures + 1
        elif isinstance(which, int) and which > 0:
            until, count, goal = "frame", lambda: self.frames, self.frames + which
        else:
            raise Refused(f"expected a number of frames above 0, or \"new\", got {which!r}")
        if not self._run_until(milliseconds(timeout), [until], lambda: count() >= goal):
            raise Timeout(f"expected {which} {until} within {timeout}; the monitor has shown "
                          f"{self.frames} frames, {self.pictures} of them new")

    def wait_text(self, text, timeout="5s", on=None):
        """Until it is printed, after what was found before; `on`: serial, jtag-0, jtag-1
        or a terminal of the parts."""
        found = []

        def met():
            found[:] = [self._find(text, on)]
            return found[0]
        self.wait(met, timeout, f"{text!r} on {on or 'the console'}")

    def wait_hex(self, digits, timeout="1s"):
        self.wait(lambda: self.shows(digits), timeout, f"HEX {digits!r}")

    def wait_leds(self, value, timeout="1s"):
        self.wait(lambda: self.leds == value, timeout, f"LEDR {value:010b}")

    # ---- What was played ----

    def save(self, path=None):
        """The scenario of what was played: its text, and a file where a path is given.

        Files that the scenario names with which the board began are named as seen from `out`.
        """
        self._connection.send(save=True)
        text = self._until("saved")["text"]
        if path is not None:
            pathlib.Path(path).write_text(text, "utf-8")
        return text

    # ---- Messages ----

    def step(self, step):
        """Any step of a scenario that hands can do: {"set-voltage": {...}}; returns after it."""
        self._connection.send(step=step)
        self._run("0ms")

    def _run_until(self, ms, until, met):
        """Whether it was met before the time was over."""
        end = round(self.time * 1000) + ms
        while (left := end - round(self.time * 1000)) > 0:
            self._run(f"{min(left, LONGEST_MS)}ms", *until)
            if met():
                return True
        return False

    def _run(self, time, *until):
        """What of `until` has happened first."""
        self._connection.send(run={"for": time, "until": until} if until else time)
        ran = self._until("ran")
        while self._screen.frame != ran["picture"]:
            self._take(self._next())
        return ran["met"]

    def _until(self, name):
        """The answer of that name.  Refused: an error came instead, or before it of a step."""
        error = None
        while True:
            message = self._next()
            self._take(message)
            if isinstance(message, bytes):
                continue
            error = error or message.get("error")
            answered = name in message or (error and (name != "ran" or error.startswith("run:")))
            if answered and error:
                raise Refused(error)
            if answered:
                return message[name]

    def _next(self):
        message = self._connection.receive()
        if isinstance(message, dict) and "ended" in message:
            self._ended(f"exit code {message['ended']}")
        if message is None:
            self._ended("the connection is gone")
        return message

    def _ended(self, how):
        said = self._connection.said()
        if self.faults:
            raise Fault("\n".join(self.faults))
        raise Ended(f"the simulation has ended, {how}{': ' if said else ''}{said}")


def _close(connection, folder):
    if connection:
        connection.close()
    if folder:
        shutil.rmtree(folder, ignore_errors=True)
