"""moment.py - simulated times as scenarios write them: 500ms, 1.5s, 20us."""
import decimal
import re

from .errors import Refused

UNITS_MS = {"s": 1000, "ms": 1, "us": decimal.Decimal("1e-3"), "ns": decimal.Decimal("1e-6")}


def milliseconds(text):
    """Whole ones, as which time passes."""
    found = re.fullmatch(r"(\d+(?:\.\d+)?)(s|ms|us|ns)", text) if isinstance(text, str) else None
    count = decimal.Decimal(found[1]) * UNITS_MS[found[2]] if found else None
    if count is None or count != int(count):
        raise Refused(f"expected a time of whole milliseconds such as \"20ms\", got {text!r}")
    return int(count)
