"""flip_lut_bit.py IN OUT - the netlist with one bit of a look-up table changed."""
import pathlib
import re
import sys

TABLE = re.compile(r"MISTRAL_ALUT\d #\(\s*\.LUT\(\d+'h([0-9a-f]+)\)\s*\)"
                   r" \\video_block\.vga_block\.timing\.")


def main():
    text = pathlib.Path(sys.argv[1]).read_text()
    table = TABLE.search(text)
    if not table:
        sys.exit("no look-up table of video_block.vga_block.timing in the netlist")
    digit = table.end(1) - 1
    flipped = f"{int(text[digit], 16) ^ 1:x}"
    pathlib.Path(sys.argv[2]).write_text(text[:digit] + flipped + text[digit + 1:])


main()
