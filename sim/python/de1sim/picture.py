"""picture.py - the monitor's picture, from the tiles that have changed; and PNG files."""
import struct
import zlib

try:
    import numpy
except ImportError:  # python3-numpy is not needed
    numpy = None

TILE = 16
TILE_BYTES = TILE * TILE * 3


class Picture:
    """Where there is no numpy: `rgb` has three bytes per pixel, row by row."""

    def __init__(self, width, height, rgb):
        self.width, self.height, self.rgb = width, height, rgb

    def __getitem__(self, place):
        """picture[y, x] is (red, green, blue)."""
        y, x = place
        if not (0 <= y < self.height and 0 <= x < self.width):
            raise IndexError(f"expected a pixel of {self.width} x {self.height}, got {x}, {y}")
        at = 3 * (y * self.width + x)
        return tuple(self.rgb[at:at + 3])

    def __eq__(self, other):
        return (isinstance(other, Picture) and self.width == other.width
                and self.height == other.height and self.rgb == other.rgb)


class Screen:
    """Gathers the messages."""

    def __init__(self):
        self.width = self.height = self.frame = 0  # no picture yet
        self._rgb = bytearray()

    def take(self, message):
        width, height, self.frame = struct.unpack_from("<HHI", message, 1)
        if (width, height) != (self.width, self.height):
            self.width, self.height = width, height
            self._rgb = bytearray(3 * width * height)
        across = (width + TILE - 1) // TILE
        for at in range(9, len(message), 2 + TILE_BYTES):
            number, = struct.unpack_from("<H", message, at)
            top, left = number // across * TILE, number % across * TILE
            columns = 3 * min(TILE, width - left)
            for row in range(min(TILE, height - top)):
                to, start = 3 * ((top + row) * width + left), at + 2 + 3 * TILE * row
                self._rgb[to:to + columns] = message[start:start + columns]

    def picture(self):
        if not self.width:
            return None
        if numpy is None:
            return Picture(self.width, self.height, bytes(self._rgb))
        return numpy.frombuffer(bytes(self._rgb), numpy.uint8).reshape(self.height, self.width, 3)

    def png(self):
        def chunk(kind, data):
            return (struct.pack(">I", len(data)) + kind + data
                    + struct.pack(">I", zlib.crc32(kind + data)))
        row = 3 * self.width
        rows = b"".join(b"\0" + self._rgb[y * row:(y + 1) * row] for y in range(self.height))
        head = struct.pack(">IIBBBBB", self.width, self.height, 8, 2, 0, 0, 0)
        return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows))
                + chunk(b"IEND", b""))
