"""sound.py - what the codec has played."""
import array
import os
import sys
import wave

try:
    import numpy
except ImportError:  # python3-numpy is not needed
    numpy = None


class Sound:
    """`rate_hz` samples per second; `data` has them as 16-bit numbers, left, right, left, ..."""

    def __init__(self, rate_hz, data):
        self.rate_hz, self.data = rate_hz, data

    def __len__(self):
        return len(self.data) // 4

    def __eq__(self, other):
        return isinstance(other, Sound) and (self.rate_hz, self.data) == (other.rate_hz, other.data)

    @property
    def seconds(self):
        return len(self) / self.rate_hz if self.rate_hz else 0.0

    @property
    def samples(self):
        """An array of rows (left, right), or a list of such pairs where there is no numpy."""
        if numpy is not None:
            return numpy.frombuffer(self.data, "<i2").reshape(-1, 2)
        numbers = array.array("h", self.data)
        if sys.byteorder == "big":
            numbers.byteswap()
        return list(zip(numbers[::2], numbers[1::2]))

    @property
    def is_silent(self):
        return not any(self.data)

    def save(self, path):
        """A WAV file."""
        with wave.open(os.fspath(path), "wb") as file:
            file.setnchannels(2)
            file.setsampwidth(2)
            file.setframerate(self.rate_hz or 8000)
            file.writeframes(self.data)
