"""equivalents.py - the faults that change nothing which anybody could see, and why.

An entry of equivalent.txt is FILE :: WHAT :: TEXT :: REASON: file and what as in a fault's id, and
the text of its line without comments, so that it stays valid when lines move.  Where that names
several faults, `#2` after WHAT means the second of them.  Lines that are indented go on with the
entry before.
"""
import re


class Stale(Exception):
    """Entries that name no fault, or several."""


def entries(lines):
    """(number of its first line, the entry in one line)"""
    found = []
    for number, line in enumerate(lines, 1):
        if line[:1].isspace() and line.strip() and found:
            found[-1][1] += " " + line.strip()
        elif line.strip() and not line.startswith("#"):
            found.append([number, line.strip()])
    return found


def equivalents(lines, faults):
    """{id: reason} of those faults; Stale if an entry does not name one."""
    found, wrong = {}, []
    for number, line in entries(lines):
        parts = [part.strip() for part in line.split(" :: ")]
        if len(parts) != 4 or not all(parts):
            wrong.append(f"{number}: not FILE :: WHAT :: TEXT :: REASON: {line}")
            continue
        file, what, text, reason = parts
        place = re.search(r" #(\d+)$", what)
        what = what[:place.start()] if place else what
        named = [fault for fault in faults
                 if (fault.file, fault.what, fault.text) == (file, what, " ".join(text.split()))]
        if place:
            named = named[int(place[1]) - 1:int(place[1])]
        if not named:
            wrong.append(f"{number}: stale, there is no such fault: {line}")
        elif len(named) > 1:
            wrong.append(f"{number}: names {len(named)} faults, say which (#1): {line}")
        elif named[0].id in found:
            wrong.append(f"{number}: is there twice: {line}")
        else:
            found[named[0].id] = reason
    if wrong:
        raise Stale("\n".join(f"equivalent.txt:{what}" for what in wrong))
    return found


def killed_after_all(results):
    """What is said of equivalents that a test has found."""
    return [f"stale: {result['id']} is in equivalent.txt, but {result['by']} finds it"
            for result in results if result["equivalent"] and result["layer"] in
            ("block", "proofs", "whole")]
