"""open_project_test.py DE1SIM RTL FOLDER - plays the open bitstream's top: open.qsf, open.yaml

The golden picture is computed: white, yellow, cyan, green, magenta, red, blue and black, of 80
pixels each, as the EBU orders its bars.
"""
import json
import pathlib
import shutil
import struct
import subprocess
import sys
import zlib

BARS = [0xFFFFFF, 0xFFFF00, 0x00FFFF, 0x00FF00, 0xFF00FF, 0xFF0000, 0x0000FF, 0x000000]


def png_of(row, height):
    """A PNG whose rows are all the same."""
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(
            ">I", zlib.crc32(name + data))
    size = struct.pack(">IIBBBBB", len(row) // 3, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", size)
            + chunk(b"IDAT", zlib.compress((b"\0" + row) * height)) + chunk(b"IEND", b""))


def main():
    de1sim, rtl, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(rtl, folder / "rtl", ignore=shutil.ignore_patterns(".de1sim"))
    board = folder / "rtl" / "board" / "de1_soc"
    row = b"".join(colour.to_bytes(3, "big") * 80 for colour in BARS)
    (board / "golden.png").write_bytes(png_of(row, 480))
    with open(board / "open.yaml", "a") as scenario:
        scenario.write("  - expect-frame: {equals: golden.png}\n")
    played = subprocess.run([de1sim, "run", "open.yaml", "--project", "open.qsf", "--strict-vga"],
                            cwd=board)
    if played.returncode != 0:
        sys.exit(played.returncode)
    report = json.loads((board / "out" / "report.json").read_text())
    if report["cpu"] != "none" or report["bus"]["writes"] != 0:
        sys.exit("a processor has painted them")


main()
