"""errors.py - what a board can say instead of doing what it was asked."""


class Error(Exception):
    """Of de1sim; its text says what was wrong."""


class Refused(Error):
    """The board cannot be started, or was asked for something that there is not."""


class Timeout(Error, AssertionError):
    """What was waited for has not happened in that simulated time."""


class Ended(Error):
    """The simulation has ended by itself; what the board showed last can still be read."""


class Fault(Ended):
    """It has ended since the program or the project failed."""
