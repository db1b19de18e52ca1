"""digits.py - what a digit of seven segments shows, as sim/scenario/seven_segment.h says."""

GLYPHS = (
    ("0", 0x3F), ("1", 0x06), ("2", 0x5B), ("3", 0x4F), ("4", 0x66), ("5", 0x6D), ("6", 0x7D),
    ("7", 0x07), ("8", 0x7F), ("9", 0x6F), ("A", 0x77), ("B", 0x7C), ("C", 0x39), ("D", 0x5E),
    ("E", 0x79), ("F", 0x71), (" ", 0x00), ("-", 0x40), ("_", 0x08), ("H", 0x76), ("L", 0x38),
    ("P", 0x73), ("U", 0x3E), ("n", 0x54), ("o", 0x5C), ("r", 0x50), ("t", 0x78), ("u", 0x1C),
    ("y", 0x6E), ("6", 0x7C), ("7", 0x27), ("9", 0x67),
)


def digits_text(segments, expected=""):
    """HEX5 first.  A pattern of several characters is that of `expected`, or the usual one."""
    text = ""
    for place, pattern in enumerate(reversed(segments)):
        shown = [character for character, lit in GLYPHS if lit == pattern] or ["?"]
        wanted = expected[place:place + 1]
        text += wanted if wanted and wanted in shown else shown[0]
    return text
