"""verilog.py - Verilog as tokens, and what of it is not for faults.

Comments, strings, attributes and lines of directives give no tokens; headers of modules and
declarations of ports give some, which are marked as `fixed`.
"""
import bisect
import re

TOKEN = re.compile(r"""
    (?P<skip>    \s+ | //[^\n]* | /\*.*?\*/ | "(?:\\.|[^"\\])*" | \(\*(?!\s*\)).*?\*\)
               | `(?:include|define|undef|ifdef|ifndef|elsif|else|endif|timescale|default_nettype
                     |resetall|line|pragma|celldefine|endcelldefine)\b(?:\\\n|[^\n])* )
  | (?P<number>  (?:\d[\d_]*)?\s*'[sS]?[bodhBODH]\s*[0-9a-fA-FxXzZ?_]+ | \d[\d_]*(?:\.\d+)? )
  | (?P<name>    [`$]?[A-Za-z_][\w$]* | \\\S+ )
  | (?P<operator> <<<|>>>|===|!==|<<|>>|<=|>=|==|!=|&&|\|\||~&|~\||~\^|\^~|\*\*|\+:|-:|. )
""", re.X | re.S)

NUMBER = re.compile(r"(?P<width>\d[\d_]*)?\s*'(?P<sign>[sS]?)(?P<base>[bodhBODH])\s*(?P<digits>.+)")
RADIX = {"b": (2, "b"), "o": (8, "o"), "d": (10, "d"), "h": (16, "x")}
CONSTANT = re.compile(r"\blocalparam\s*(?:\[[^]]*\])?\s*(\w+)\s*=\s*([\w\s']+);")

OPENING = {"(": ")", "[": "]", "{": "}"}
CLOSING = set(OPENING.values())


def value_of(text):
    """A number's value; None for what is no number, and for x and z."""
    match = NUMBER.match(text)
    digits = (match["digits"] if match else text).replace("_", "")
    try:
        return int(digits, RADIX[match["base"].lower()][0] if match else 10)
    except ValueError:
        return None


def constants_of(text):
    """{name: value} of the constants that a file gives numbers."""
    found = ((name, value_of(number.strip())) for name, number in CONSTANT.findall(text))
    return {name: value for name, value in found if value is not None}


class Token:
    def __init__(self, kind, text, start):
        self.kind, self.text, self.start, self.end = kind, text, start, start + len(text)
        self.fixed = False    # of a header or a declaration of ports
        self.partner = None   # index of the bracket that belongs to this one
        self.depth = 0        # brackets around it


class Source:
    """A file's text, its tokens, and the text with blanks where there are no tokens."""

    def __init__(self, text):
        self.text = text
        self.tokens = []
        plain = list(text)
        for match in TOKEN.finditer(text):
            if match.lastgroup == "skip":
                plain[match.start():match.end()] = [c if c == "\n" else " " for c in match.group()]
            else:
                self.tokens.append(Token(match.lastgroup, match.group(), match.start()))
        self.plain = "".join(plain)
        self.lines = [0] + [i + 1 for i, c in enumerate(text) if c == "\n"]
        self._pair()
        self._fix()

    def _pair(self):
        open_ones = []
        for index, token in enumerate(self.tokens):
            if token.text in CLOSING and open_ones:
                token.partner = open_ones.pop()
                self.tokens[token.partner].partner = index
            token.depth = len(open_ones)
            if token.text in OPENING:
                open_ones.append(index)

    def _fix(self):
        fixed = False
        for token in self.tokens:
            if token.depth == 0 and token.text in ("module", "input", "output", "inout"):
                fixed = True
            token.fixed = fixed
            if token.depth == 0 and token.text == ";":
                fixed = False

    def around(self, index):
        """The brackets that a token is in, from the inside."""
        depth = self.tokens[index].depth
        for token in reversed(self.tokens[:index]):
            if token.text in OPENING and token.depth < depth:
                depth = token.depth
                yield token.text

    def place(self, offset):
        """Line and column, from 1."""
        line = bisect.bisect_right(self.lines, offset)
        return line, offset - self.lines[line - 1] + 1

    def line(self, number):
        """A line without comments, with single blanks."""
        end = self.lines[number] if number < len(self.lines) else len(self.plain)
        return " ".join(self.plain[self.lines[number - 1]:end].split())
