"""page_test.py DE1SIM - the page that --html writes, as a browser's parser and a person have it

A run of the demo with expectations that are met and two that are not, one of them a golden picture
that is black.
"""

import base64
import html.parser
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

SCENARIO = """\
name: "<b>a page</b> & more"
version: 1
steps:
  - wait-serial: ready
  - press: {keypad: "1", for: 80ms}
  - delay: 100ms
  - take-screenshot: {save-to: seen.png}
  - expect-hex: "     1"
  - expect-frame: {equals: golden.png}
  - expect-leds: "1111111111"
"""
BLACK = bytes(3)


def png_of(width, height, pixel):
    """A PNG of one colour."""
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(
            ">I", zlib.crc32(name + data))
    rows = (b"\0" + pixel * width) * height
    size = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", size)
            + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def rows_of(png):
    """The rows of a PNG with 8-bit RGB and no filters, as de1sim writes it: lists of pixels."""
    assert png.startswith(b"\x89PNG\r\n\x1a\n")
    at, chunks = 8, {}
    while at < len(png):
        (size,) = struct.unpack(">I", png[at:at + 4])
        name = png[at + 4:at + 8]
        chunks[name] = chunks.get(name, b"") + png[at + 8:at + 8 + size]
        at += size + 12
    width, height, *kind = struct.unpack(">IIBBBBB", chunks[b"IHDR"])
    assert kind == [8, 2, 0, 0, 0], kind
    data, row = zlib.decompress(chunks[b"IDAT"]), 1 + 3 * width
    assert len(data) == row * height and not any(data[::row])
    return [[data[i:i + 3] for i in range(y * row + 1, (y + 1) * row, 3)] for y in range(height)]


VOID = {"meta", "img", "br", "input"}


class Page(html.parser.HTMLParser):
    """Text and pictures of a page, whose elements must be closed in the order they were opened."""

    def __init__(self, text):
        super().__init__()
        self.open, self.text, self.pictures, self.ids, self.links = [], "", [], [], []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        for name in ("src", "href", "data", "srcset"):
            if name in attributes:
                inside = attributes[name].startswith(("#", "data:image/png;base64,"))
                assert inside, f"{tag} refers to {attributes[name][:80]}"
        if tag == "img":
            encoded = attributes["src"].split(",", 1)[1]
            self.pictures.append((attributes["alt"], base64.b64decode(encoded, validate=True)))
        self.ids += [attributes["id"]] if "id" in attributes else []
        self.links += [attributes["href"]] if "href" in attributes else []
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in VOID:
            self.handle_endtag(tag)

    def handle_endtag(self, tag):
        expected = self.open.pop()
        assert tag == expected, f"</{tag}> at {self.getpos()}, expected </{expected}>"

    def handle_data(self, data):
        self.text += data


class PageOfARun(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        (cls.folder / "s.yaml").write_text(SCENARIO)
        (cls.folder / "golden.png").write_bytes(png_of(640, 480, BLACK))
        cls.outcome = cls.play("--html", str(cls.folder / "page.html"))
        cls.html = (cls.folder / "page.html").read_text("utf-8")
        cls.page = Page(cls.html)
        cls.report = json.loads((cls.folder / "out/report.json").read_text())

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @classmethod
    def play(cls, *words):
        return subprocess.run(
            [sys.argv[1], "run", cls.folder / "s.yaml", "--out", cls.folder / "out", "--quiet",
             *words], capture_output=True, text=True, check=False)

    def picture(self, name):
        found = [picture for alt, picture in self.page.pictures if alt == name]
        self.assertTrue(found, name)
        return found[0]

    def test_is_closed_and_refers_to_nothing_outside(self):
        self.assertEqual(self.page.open, [])
        self.assertNotIn("http:", self.html)
        self.assertNotIn("https:", self.html)
        for link in self.page.links:
            self.assertIn(link[1:], self.page.ids)
        self.assertEqual(len(self.page.ids), len(set(self.page.ids)))

    def test_has_the_verdict_and_every_step_with_what_was_found(self):
        self.assertEqual(self.outcome.returncode, 1)
        self.assertIn("<b>a page</b> & more", self.page.text)
        self.assertIn("failed", self.page.text)
        met = sum(expectation["met"] for expectation in self.report["expectations"])
        self.assertEqual(met, 2)
        self.assertIn("2 of 4 met", self.page.text)
        for expectation in self.report["expectations"]:
            self.assertIn(expectation["step"], self.page.text)
            self.assertIn(expectation["detail"], self.page.text)
        for step in ("press keypad 1 for 80ms", "take screenshot seen.png"):
            self.assertIn(step, self.page.text)
        self.assertEqual(sum(i.startswith("s") for i in self.page.ids), 7)

    def test_has_the_pictures_of_a_golden_that_did_not_match(self):
        for what in ("actual", "expected", "difference"):
            (file,) = (self.folder / "out/mismatch").glob(f"*_{what}.png")
            self.assertEqual(rows_of(self.picture(what)), rows_of(file.read_bytes()))
        self.assertEqual(rows_of(self.picture("actual")),
                         rows_of((self.folder / "out/seen.png").read_bytes()))

    def test_has_the_new_pictures_half_as_large(self):
        film = {int(alt.split()[1]): picture for alt, picture in self.page.pictures
                if alt.startswith("frame ")}
        self.assertEqual({str(number) for number in film}, set(self.report["frames"]["pictures"]))
        for number, picture in film.items():
            whole = rows_of((self.folder / f"out/frames/frame_{number:06}.png").read_bytes())
            # Every pixel of the demo's is two by two.
            self.assertEqual(rows_of(picture), [row[::2] for row in whole[::2]])

    def test_has_the_plots_the_console_and_how_to_repeat_it(self):
        for plot in ("Steps over time", "Sound over time", "Lamps and digits over time"):
            self.assertIn(f'aria-label="{plot}"', self.html)
        console = (self.folder / "out/console.txt").read_text()
        for line in console.split("\n"):
            self.assertIn(line.strip("\r"), self.page.text)
        self.assertIn(f"--html {self.folder}/page.html", self.page.text)
        version = subprocess.run([sys.argv[1], "--version"], capture_output=True, text=True,
                                 check=True).stdout.strip()
        self.assertIn(version, self.page.text)

    def test_is_not_begun_where_it_cannot_be_written(self):
        wrong = self.play("--html", str(self.folder / "missing/page.html"))
        self.assertEqual(wrong.returncode, 2)
        self.assertIn("missing/page.html", wrong.stderr)
        self.assertEqual(wrong.stderr.count("\n"), 1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
