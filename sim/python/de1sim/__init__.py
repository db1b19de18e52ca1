"""de1sim - a simulated DE1-SoC to play in Python; see README.md."""
from .board import Board
from .errors import Ended, Error, Fault, Refused, Timeout
from .sound import Sound

__all__ = ["Board", "Ended", "Error", "Fault", "Refused", "Sound", "Timeout"]
