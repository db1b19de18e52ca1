"""messages_test.py README SIM - every message that README quotes can still be said by SIM's code.

A message is what stands in the first column of a table, in backquotes; "..." is what is put in.
Each part between them has to be made of whole pieces of text in the sources, one after the other,
where a piece ends at "{}" or at the text's end.  The first may begin in the middle of one, and the
last may end there.
"""
import pathlib
import re
import sys

TEXT = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
LEAST = 4  # letters of a piece that is cut


def pieces(path):
    """What the string literals of a file consist of; those that follow each other are one."""
    source = re.sub(r'"\s*\n\s*"', "", path.read_text())
    for text in TEXT.findall(source):
        yield from re.split(r"\{.*?\}", text.replace('\\"', '"').replace("\\n", "\n"))


def said(part, all_pieces, cut_begins, cut_ends):
    """Whether `part` is made of pieces."""
    if not part.strip():
        return True
    reached = {0} | {n for n in range(LEAST, len(part) + 1) if part[:n] in cut_begins}
    for begin in range(len(part)):
        if begin not in reached:
            continue
        if part[begin:] in cut_ends:
            return True
        reached |= {end for end in range(begin + 1, len(part) + 1) if part[begin:end] in all_pieces}
    return len(part) in reached


def main():
    readme, sim = (pathlib.Path(argument) for argument in sys.argv[1:])
    files = sorted(sim.rglob("*.cpp")) + sorted(sim.rglob("*.h"))
    all_pieces = {piece for path in files for piece in pieces(path) if piece}
    cut_begins = {piece[i:] for piece in all_pieces for i in range(len(piece) - LEAST + 1)}
    cut_ends = {piece[:n] for piece in all_pieces for n in range(LEAST, len(piece) + 1)}
    messages = re.findall(r"^\| `(.*?)` \|", readme.read_text(), re.M)
    missing = 0
    for message in messages:
        for part in message.split("..."):
            if not said(part, all_pieces, cut_begins, cut_ends):
                missing += 1
                print(f"{readme}: `{message}`: no source says \"{part}\"")
    print(f"{len(messages)} messages, {missing} parts missing")
    return 1 if missing or len(messages) < 20 else 0


sys.exit(main())
