"""test_card.py FILE.png - draws the picture that the camera sees in the tests, 720 x 480

Eight colour bars of 75 % over a ramp of grey, a white frame at the edge of what programs get of
it, two discs, and a mark that is told from its mirror image.  Two rows each are alike, so that it
is all one which field a snapshot shows.
"""
import struct
import sys
import zlib

WIDTH, HEIGHT = 720, 480
BARS = [(191, 191, 191), (191, 191, 0), (0, 191, 191), (0, 191, 0),
        (191, 0, 191), (191, 0, 0), (0, 0, 191), (0, 0, 0)]
MARK = ["####", "#   ", "### ", "#   ", "#   "]


def pixel(x, y):
    y -= y % 2
    if not 40 <= x < 680:
        return 64, 64, 64                       # clipped
    if x in (40, 41, 678, 679) or y in (0, 478):
        return 255, 255, 255
    if (x - 200) ** 2 + (y - 360) ** 2 < 80 ** 2:
        return 255, 128, 0
    if (x - 520) ** 2 + (y - 360) ** 2 < 80 ** 2:
        return 0, 96, 255
    if 320 <= x < 400 and 300 <= y < 400:
        return (255, 255, 255) if MARK[(y - 300) // 20][(x - 320) // 20] == "#" else (0, 0, 0)
    if y < 240:
        return BARS[(x - 40) // 80]
    return ((x - 40) * 256 // 640,) * 3


def main():
    rows = b"".join(b"\0" + bytes(v for x in range(WIDTH) for v in pixel(x, y))
                    for y in range(HEIGHT))

    def chunk(name, data):
        return (struct.pack(">I", len(data)) + name + data
                + struct.pack(">I", zlib.crc32(name + data)))
    with open(sys.argv[1], "wb") as png:
        png.write(b"\x89PNG\r\n\x1a\n"
                  + chunk(b"IHDR", struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 2, 0, 0, 0))
                  + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


main()
