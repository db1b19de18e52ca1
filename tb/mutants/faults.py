"""faults.py - the single faults that a Verilog file can have.

Each has an id, FILE:LINE:COLUMN:WHAT, FILE relative to rtl/, that says which place it is in and
what it changes there.
"""
import re

from verilog import NUMBER, RADIX, Source, constants_of, value_of

BINARY = {"+": ["-"], "-": ["+"], "&": ["|"], "|": ["&"], "&&": ["||"], "||": ["&&"],
          "==": ["!="], "!=": ["=="], "<": ["<="], "<=": ["<"], ">": [">="], ">=": [">"]}
# The causes of waking of tb/formal/sleep.py: awake_o, due_o, and what the groups' clocks obey.
WAKES = re.compile(r"(\w+_)?(awake|due|wakes)(_[oi])?$")
RESET = re.compile(r"rst|reset")
STATEMENT_BEFORE = {";", "begin", "end", "else", ")", ":", "*", "endcase", "endfunction", "initial",
                    "generate", "endgenerate"}


class Fault:
    def __init__(self, file, source, offset, kind, what, edits):
        self.file, self.kind, self.what, self.edits = file, kind, what, edits
        self.line, self.column = source.place(offset)
        self.text = source.line(self.line)
        self.id = f"{file}:{self.line}:{self.column}:{what}"

    def apply(self, text):
        for start, end, new in sorted(self.edits, reverse=True):
            text = text[:start] + new + text[end:]
        return text


def constants(text):
    """What a number becomes: one more, and with its highest bit flipped."""
    match = NUMBER.match(text)
    if not match:
        if not text.replace("_", "").isdigit():
            return []
        value = int(text.replace("_", ""))
        flipped = value ^ 1 << value.bit_length() - 1 if value else None
        return [str(new) for new in dict.fromkeys((value + 1, flipped)) if new is not None]
    radix, format_code = RADIX[match["base"].lower()]
    digits = match["digits"].replace("_", "")
    value, width = value_of(text), int((match["width"] or "32").replace("_", ""))
    if value is None:
        return []
    news = dict.fromkeys(((value + 1) % (1 << width), value ^ 1 << width - 1))
    head = f"{match['width'] or ''}'{match['sign']}{match['base']}"
    digit_count = 0 if radix == 10 else len(digits)
    return [f"{head}{new:0{digit_count}{format_code}}" for new in news if new != value]


class Finder:
    def __init__(self, file, text, constants):
        self.file, self.source = file, Source(text)
        self.tokens = self.source.tokens
        self.constants = {**constants, **constants_of(self.source.plain)}
        self.faults = []
        self.resets = self._resets()
        self.assignments = self._assignments()

    def add(self, offset, kind, what, *edits):
        self.faults.append(Fault(self.file, self.source, offset, kind, what, edits))

    def text(self, first, last):
        """What is between two tokens, both included, without comments."""
        return self.source.plain[self.tokens[first].start:self.tokens[last].end].strip()

    def at(self, index):
        return self.tokens[index].text if 0 <= index < len(self.tokens) else ""

    def all(self):
        for index, token in enumerate(self.tokens):
            if token.fixed:
                continue
            if token.kind == "operator":
                self._operator(index, token)
            elif token.kind == "number":
                self._number(index, token)
            elif token.text == "if" and self.at(index + 1) == "(":
                self._condition(index)
        for operator, (first, last) in self.assignments.items():
            self._assignment(operator, first, last)
        self.faults.sort(key=lambda fault: (fault.line, fault.column, fault.what))
        return self.faults

    # ---- Where statements are ----

    def _resets(self):
        """Ranges of tokens that run in a reset."""
        ranges = []
        for index, token in enumerate(self.tokens):
            if token.text != "if" or self.at(index + 1) != "(":
                continue
            last = self.tokens[index + 1].partner
            if any(RESET.search(t.text) for t in self.tokens[index + 2:last]):
                ranges.append((last, self._statement_end(last + 1)))
        return ranges

    def _statement_end(self, index):
        blocks = 0
        while index < len(self.tokens):
            text = self.at(index)
            blocks += text in ("begin", "case", "casez")
            blocks -= text in ("end", "endcase")
            if blocks <= 0 and text in (";", "end", "endcase"):
                return index
            index += 1
        return index - 1

    def _in_reset(self, index):
        return any(first <= index <= last for first, last in self.resets)

    def _assignments(self):
        """{index of the operator: (first token of what is assigned to, the semicolon)}"""
        found, seen = {}, False
        for index, token in enumerate(self.tokens):
            if token.depth:
                continue
            if token.text in (";", "begin", "end", "else"):
                seen = False
            elif token.text in ("=", "<=") and not seen:
                seen = True
                if not token.fixed:
                    found[index] = (self._target(index), self._statement_end(index))
            elif token.text == ",":   # wire a = b, c = d;
                seen = False
        return found

    def _target(self, operator):
        index = operator - 1
        while self.at(index) == "]":
            index = self.tokens[index].partner - 1
        return self.tokens[index].partner if self.at(index) == "}" else index

    # ---- Faults ----

    def _operator(self, index, token):
        binary = self._binary(index)
        if binary and token.text in BINARY and index not in self.assignments:
            for new in BINARY[token.text]:
                self.add(token.start, "operator", f"{token.text} -> {new}",
                         (token.start, token.end, new))
        elif token.text in ("!", "~") and not binary:
            self.add(token.start, "operator", f"{token.text} dropped", (token.start, token.end, ""))
        elif token.text in ("~&", "~|", "~^") and not binary:
            self.add(token.start, "operator", "~ dropped", (token.start, token.start + 1, ""))
        elif token.text == "?":
            self._arms(index, token)

    def _binary(self, index):
        """Whether an operator stands between two operands."""
        before = self.tokens[index - 1]
        return before.kind in ("number", "name") or before.text in (")", "]", "}")

    def _number(self, index, token):
        bounds = self.at(index - 1) in ("[", ":") and self.at(index + 1) in (":", "]")
        if bounds and self._in_range(index):
            high = self.at(index - 1) == "["
            if not high and self._declares(index):
                return  # as wide as without the high bit
            if high and self._is_extended(index):
                return
            value = int(token.text) + (-1 if high else 1) if token.text.isdigit() else -1
            if value >= 0:
                self.add(token.start, "range",
                         f"{'high' if high else 'low'} bit {token.text} -> {value}",
                         (token.start, token.end, str(value)))
            return
        kind = "reset" if self._in_reset(index) else "constant"
        for new in constants(token.text):
            self.add(token.start, kind, f"{token.text} -> {new}", (token.start, token.end, new))

    def _declares(self, index):
        while self.at(index) != "[":
            index -= 1
        return self.at(index - 1) in ("reg", "wire", "localparam", "parameter", "function",
                                      "signed")

    def _is_extended(self, index):
        """Whether this is the highest bit of a constant, and 0, which it would be without it.

        Not so in braces, where each bit has its place."""
        first = max(i for i in range(index) if self.at(i) == "[")
        name, places = self.at(first - 1), [index]
        if self._declares(index):
            name = self.at(self.tokens[first].partner + 1)
            places = [i for i, token in enumerate(self.tokens) if token.text == name]
        value, bit = self.constants.get(name), self.at(index)
        return (value is not None and bit.isdigit() and not value >> int(bit) & 1
                and not any("{" in self.source.around(place) for place in places))

    def _in_range(self, index):
        """Whether the number is one of the two sides of [high:low]."""
        for first in range(index, -1, -1):
            if self.at(first) == "[" and self.tokens[first].depth < self.tokens[index].depth:
                last = self.tokens[first].partner
                level = [t.text for t in self.tokens[first + 1:last]
                         if t.depth == self.tokens[first].depth + 1]
                return ":" in level and "?" not in level
        return False

    def _condition(self, index):
        start, first, last = (self.tokens[index].start, self.tokens[index + 1],
                              self.tokens[self.tokens[index + 1].partner])
        inner = [t.text for t in self.tokens[index + 2:first.partner]]
        condition = self.source.plain[first.end:last.start].strip()
        # Without a negation that the faults of the operators have already.
        if not (inner[0] == "!" and len(inner) == 2 or
                len(inner) == 3 and inner[1] in ("==", "!=")):
            self.add(start, "condition", "if (x) -> if (!x)",
                     (first.end, last.start, f"!({condition})"))
        for new in ("1'b1", "1'b0"):
            self.add(start, "condition", f"if (x) -> if ({new})", (first.end, last.start, new))

    def _arms(self, index, token):
        nested, colon, last = 0, None, len(self.tokens)
        for later in range(index + 1, len(self.tokens)):
            other = self.tokens[later]
            if other.depth < token.depth or \
                    other.depth == token.depth and other.text in (";", ","):
                last = later
                break
            if other.depth > token.depth:
                continue
            if other.text == "?":
                nested += 1
            elif other.text == ":":
                if nested:
                    nested -= 1
                elif colon is None:
                    colon = later
                else:
                    last = later
                    break
        if colon is None or last >= len(self.tokens):
            return
        one, two = self.text(index + 1, colon - 1), self.text(colon + 1, last - 1)
        if " ".join(one.split()) != " ".join(two.split()):
            self.add(token.start, "arms", "arms of ?: swapped",
                     (token.end, self.tokens[last - 1].end, f" ({two}) : ({one})"))

    def _assignment(self, operator, first, last):
        start, end = self.tokens[first].start, self.tokens[last].end
        before, name = self.at(first - 1), self.at(first)
        if before == "assign":
            start = self.tokens[first - 1].start
        # A block's name stands between `begin` and its first statement.
        named = self.at(first - 2) == ":" and self.at(first - 3) == "begin"
        if before == "assign" or before in STATEMENT_BEFORE or named:
            kind = "reset" if self._in_reset(operator) else "assignment"
            self.add(start, kind, f"{name} {self.at(operator)} left out", (start, end, ";"))
        if WAKES.match(name):
            self._wake(operator, last)

    def _wake(self, operator, last):
        first = operator + 1
        level = self.tokens[operator].depth
        ends = [i for i in range(first, last) if self.tokens[i].depth == level
                and self.at(i) in ("||", "|", ",") and self._binary(i)] + [last]
        if any(self.at(i) == "?" and self.tokens[i].depth == level for i in range(first, last)):
            ends = [last]
        for end in ends:
            text = " ".join(self.text(first, end - 1).split())
            self.add(self.tokens[first].start, "wake", f"wakes without {text}",
                     (self.tokens[first].start, self.tokens[end - 1].end, "1'b0"))
            if self.at(end) == ",":
                break
            first = end + 1


def faults_of(file, text, constants=()):
    """`constants`: values of names that the file includes."""
    return Finder(file, text, dict(constants)).all()
