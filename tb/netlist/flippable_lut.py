"""flippable_lut.py IN OUT - the netlist with one look-up table as FLIPPABLE_ALUT of cells.v."""
import pathlib
import re
import sys

TABLE = re.compile(r"MISTRAL_ALUT\d( #\(\s*\.LUT\(\d+'h[0-9a-f]+\)\s*\)"
                   r" \\video_block\.vga_block\.timing\.)")


def main():
    text, changed = TABLE.subn(r"FLIPPABLE_ALUT\1", pathlib.Path(sys.argv[1]).read_text(), 1)
    if not changed:
        sys.exit("no look-up table of video_block.vga_block.timing in the netlist")
    pathlib.Path(sys.argv[2]).write_text(text)


main()
