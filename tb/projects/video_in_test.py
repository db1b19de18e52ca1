"""video_in_test.py DE1SIM FOLDER [CASE...] - the University Program's cores of the video input"""
import math
import random

from case import run
from systems import FULL, LW, SystemCase, clocked
from university_test import UP, png

CAMERA = """, .camera_TD_CLK27(TD_CLK27), .camera_TD_DATA(TD_DATA), .camera_TD_HS(TD_HS),
.camera_TD_VS(TD_VS), .camera_clk27_reset(1'b0), .camera_TD_RESET(TD_RESET_N),
.camera_overflow_flag()"""
CAMERA_PORTS = ", input TD_CLK27, TD_HS, TD_VS, input [7:0] TD_DATA, output TD_RESET_N"
TO_RGB = ("csc", {"csc_type": "444 YCrCb to 24-bit RGB"}, "csc")


def clipped(value):
    return min(max(value, 0), 255)


def times(value, factor):
    """As the core multiplies: the factor in 32768ths, rounded down."""
    return value * factor >> 15


def rgb(y, cb, cr):
    return (clipped(times(y - 16, 38141) + times(cr - 128, 52297)),
            clipped(times(y - 16, 38141) - times(cr - 128, 26640) - times(cb - 128, 12845)),
            clipped(times(y - 16, 38141) + times(cb - 128, 66093)))


def ycbcr(r, g, b):
    return (clipped(16 + times(r, 8421) + times(g, 16515) + times(b, 3213)),
            clipped(128 + times(b, 14385) - times(g, 9535) - times(r, 4850)),
            clipped(128 + times(r, 14385) - times(g, 12059) - times(b, 2327)))


def rgb565(r, g, b):
    return r >> 3 << 11 | g >> 2 << 5 | b >> 3


def filmed(r, g, b):
    """What the camera makes of a colour: Y, Cb, Cr of ITU-R BT.601."""
    r, g, b = r / 255, g / 255, b / 255
    return (math.floor(16.5 + 65.481 * r + 128.553 * g + 24.966 * b),
            math.floor(128.5 - 37.797 * r - 74.203 * g + 112 * b),
            math.floor(128.5 + 112 * r - 93.786 * g - 18.214 * b))


def edges(rows):
    """The core's edge detection of rows of brightness, as its document has it."""
    width = len(rows[0])
    line = [value for row in rows for value in row]

    def each(weigh, before):
        def at(n, x, y):
            n += y * width + x
            return before[min(max(n, 0), len(before) - 1)]  # beyond the picture is not compared
        return [weigh(lambda x, y, n=n: at(n, x, y)) for n in range(len(before))]

    weights = {0: 15, 1: 12, 2: 9, 4: 5, 5: 4, 8: 2}
    square = [(x, y) for y in (-2, -1, 0, 1, 2) for x in (-2, -1, 0, 1, 2)]
    smooth = each(lambda at: sum(weights[x * x + y * y] * at(x, y) for x, y in square) >> 7, line)

    def slope(at):
        gx = sum(at(1, y) * (2 - abs(y)) - at(-1, y) * (2 - abs(y)) for y in (-1, 0, 1))
        gy = sum(at(x, 1) * (2 - abs(x)) - at(x, -1) * (2 - abs(x)) for x in (-1, 0, 1))
        falls = (gx < 0) != (gy < 0)
        return min((abs(gx) + abs(gy)) // 4, 255), 2 * falls + (falls != (abs(gy) > abs(gx)))

    slopes = each(slope, smooth)
    pairs = {0: ((1, 1), (1, 0), (-1, 0)), 1: ((1, 1), (0, 1), (0, -1)),
             2: ((0, 1), (-1, 1), (1, -1)), 3: ((-1, 1), (-1, 0), (1, 0))}

    def thin(at):
        value, direction = at(0, 0)
        a, b, c = (at(x, y)[0] for x, y in pairs[direction])
        return value if value >= (a + b) // 2 and value >= c else 0

    strengths = each(thin, slopes)
    around = [(x, y) for y in (-1, 0, 1) for x in (-1, 0, 1)]
    chosen = each(lambda at: min(at(0, 0) + 32, 255) if any(at(*p) >= 10 for p in around) else 0,
                  strengths)
    return [chosen[n:n + width] for n in range(0, len(chosen), width)]


class VideoIn(SystemCase):
    def stream(self, parts, exports=(), **named):
        """Cores behind each other, and a memory at the processor's first address of the FPGA.

        A part is (name, parameters, the middle of its interfaces' names, and what it has instead of
        _sink and _source); the first and the last may be masters of the memory.
        """
        memory = {"memorySize": "262144", "dataWidth": "32", "initMemContent": "false"}
        modules = [("memory", "altera_avalon_onchip_memory2", memory)]
        wires = [*clocked("memory", "clk1", "reset1"),
                 ("avalon", FULL, "memory.s1", 0)]
        source = None
        for n, (kind, parameters, middle) in enumerate(parts):
            name = f"part{n}"
            modules.append((name, UP + kind, parameters))
            wires += [*clocked(name)]
            if kind == "dma_controller":
                wires += [("avalon", f"{name}.avalon_dma_master", "memory.s1", 0),
                          ("avalon", LW, f"{name}.avalon_dma_control_slave", 0x40 + 0x10 * n)]
            if source:
                wires.append(("avalon_streaming", source, f"{name}.avalon_{middle}_sink"))
            source = f"{name}.avalon_{'pixel' if kind == 'dma_controller' else middle}_source"
        self.with_leds(modules, wires, exports, **named)

    def written(self, last, expected, width_bits, bytes_, steps=(), before=""):
        """Lets part `last` write until the memory has what is expected: {(x, y): pixel}."""
        table = ",\n".join(f"{{{x}, {y}, {pixel}}}" for (x, y), pixel in expected.items())
        self.program(f"""static const struct {{ uint16_t x, y; uint32_t pixel; }} all[] = {{
{table}}};
volatile uint{8 * bytes_}_t* m = (volatile uint{8 * bytes_}_t*)0xC0000000;
{before}
R32(0xFF20004C + {0x10 * last}) = 4;
for (;;) {{
    uint32_t wrong = 0;
    for (unsigned n = 0; n < sizeof all / sizeof all[0]; n++)
        wrong += m[(all[n].y << {width_bits}) + all[n].x] != all[n].pixel;
    R32(0xFF200000) = wrong == 0 ? 341 : wrong > 1000 ? 1000 : wrong;
}}""")
        self.played(*steps, "expect-leds: {equals: 341, timeout: 200ms}")

    def filmed(self, picture, expected, more=()):
        """The camera sees rows of (red, green, blue), each of them twice, for both fields.

        The decoder's lines without vertical blanking begin 12 before the camera's, of which the
        clipper takes away 2.
        """
        expected = {(x, y + 10): pixel for (x, y), pixel in expected.items() if y < 230}
        png(self.folder / "picture.png", [row for row in picture for _ in (0, 1)])
        into = {"mode": "From Stream to Memory", "width": "320", "height": "240",
                "color_bits": "16", "color_planes": "1", "dma_enabled": "false"}
        clip = {"drop_left": "40", "drop_right": "40", "drop_top": "2", "drop_bottom": "2"}
        parts = [("decoder", {}, "decoder"), ("chroma_resampler", {}, "chroma"), *more, TO_RGB,
                 ("rgb_resampler", {"input_type": "24-bit RGB", "output_type": "16-bit RGB"},
                  "rgb"),
                 ("clipper", clip, "clipper"),
                 ("scaler", {"width_in": "640", "height_in": "240", "width_scaling": "0.5",
                             "height_scaling": "1", "color_bits": "16", "color_planes": "1"},
                  "scaler"), ("dma_controller", into, "dma")]
        self.stream(parts, [("camera", "part0.external_interface")], top=CAMERA,
                    ports=CAMERA_PORTS)
        self.written(len(parts) - 1, expected, 9, 2, ["show-picture: picture.png"])

    def test_colours_of_a_camera(self):
        draw = random.Random(1)
        colours = [[tuple(draw.randrange(256) for _ in range(3)) for _ in range(9)]
                   for _ in range(5)]
        picture = [[colours[y // 48][x // 80] for x in range(720)] for y in range(240)]
        # In the middle of each field of colour, and at the picture's corners.
        places = {(c * 40 + 20 - 20, r * 48 + 24) for c in range(1, 8) for r in range(4)}
        places |= {(0, 0), (319, 0), (0, 229), (319, 229), (19, 47), (21, 48)}
        self.filmed(picture, {(x, y): rgb565(*rgb(*filmed(*picture[y][40 + 2 * x])))
                              for x, y in places})

    def test_edges_of_a_camera(self):
        draw = random.Random(2)
        blocks = [[draw.randrange(256) for _ in range(60)] for _ in range(20)]
        picture = [[(clipped(blocks[y // 12][x // 12] + (x + y) % 12),) * 3 for x in range(720)]
                   for y in range(240)]
        bright = [[filmed(*pixel)[0] for pixel in row] for row in picture]
        found = edges(bright)
        grey = {"input_type": "YCrCb 444", "output_type": "Y only"}
        back = {"input_type": "Y only", "output_type": "YCrCb 444"}
        self.filmed(picture, {(x, y): rgb565(*rgb(found[y][40 + 2 * x], 128, 128))
                              for y in range(8, 222, 7) for x in range(320)},
                    [("chroma_resampler", grey, "chroma"),
                     ("edge_detection", {"width": "720"}, "edge_detection"),
                     ("chroma_resampler", back, "chroma")])

    def passed(self, parts, width, height, pixels, out_width, out_height, expected, planes=3):
        """A picture from the memory through the parts and back, after it."""
        bits = {"color_bits": "8", "color_planes": str(planes)}
        bytes_ = 4 if planes == 3 else planes
        parts = [("dma_controller", {"width": str(width), "height": str(height), **bits}, ""),
                 *parts,
                 ("dma_controller", {"mode": "From Stream to Memory", "width": str(out_width),
                                     "height": str(out_height), "dma_enabled": "false",
                                     "start_address": "0x10000", **bits}, "dma")]
        self.stream(parts)
        line = (width - 1).bit_length()
        draw = ", ".join(str(pixel) for row in pixels for pixel in row)
        self.written(len(parts) - 1, expected, (out_width - 1).bit_length(), bytes_,
                     before=f"static const uint32_t drawn[] = {{{draw}}};\n"
                            f"for (int n = 0; n < {width * height}; n++)\n"
                            f"    m[(n / {width} << {line}) + n % {width}] = drawn[n];\n"
                            f"m += {0x10000 // bytes_};\n")

    def test_colours_there_and_back(self):
        draw = random.Random(3)
        pixels = [[draw.randrange(1 << 24) for _ in range(20)] for _ in range(6)]
        expected = {}
        for y, row in enumerate(pixels):
            for x, pixel in enumerate(row):
                all_ = [ycbcr(p >> 16, p >> 8 & 255, p & 255) for p in row]
                # In turn Cb and Cr are that of the pixel, and of the one before.
                before = all_[x - 1] if x else \
                    ycbcr(pixels[y - 1][19] >> 16, pixels[y - 1][19] >> 8 & 255,
                          pixels[y - 1][19] & 255) if y else (0, 0, 0)
                cb, cr = (before[1], all_[x][2]) if x % 2 else (all_[x][1], before[2])
                r, g, b = rgb(all_[x][0], cb, cr)
                expected[x, y] = r << 16 | g << 8 | b
        self.passed([("csc", {"csc_type": "24-bit RGB to 444 YCrCb"}, "csc"),
                     ("chroma_resampler", {"input_type": "YCrCb 444", "output_type": "YCrCb 422"},
                      "chroma"), ("chroma_resampler", {}, "chroma"), TO_RGB],
                    20, 6, pixels, 20, 6, expected)

    def test_grey_of_colours(self):
        draw = random.Random(4)
        pixels = [[draw.randrange(1 << 24) for _ in range(20)] for _ in range(6)]
        luma = {(x, y): ycbcr(p >> 16, p >> 8 & 255, p & 255)[0]
                for y, row in enumerate(pixels) for x, p in enumerate(row)}
        self.passed([("csc", {"csc_type": "24-bit RGB to Grayscale (Y)"}, "csc"),
                     ("csc", {"csc_type": "Grayscale (Y) to 24-bit RGB"}, "csc")],
                    20, 6, pixels, 20, 6, {at: grey * 0x10101 for at, grey in luma.items()})

    def test_a_picture_without_its_edges_in_a_frame(self):
        pixels = [[10 * y + x for x in range(10)] for y in range(8)]
        clip = {"width_in": "10", "height_in": "8", "drop_left": "1", "drop_right": "2",
                "drop_top": "3", "drop_bottom": "1", "add_left": "2", "add_right": "1",
                "add_top": "1", "add_bottom": "2", "add_value_plane_1": "200", "color_bits": "8"}
        self.passed([("clipper", clip, "clipper")], 10, 8, pixels, 10, 7,
                    {(x, y): pixels[y + 2][x - 1] if 2 <= x < 9 and 1 <= y < 5 else 200
                     for x in range(10) for y in range(7)}, planes=1)

    def test_a_picture_that_ends_too_soon_is_filled(self):
        pixels = [[10 * y + x for x in range(10)] for y in range(4)]
        clip = {"width_in": "10", "height_in": "6", "drop_left": "1", "add_value_plane_1": "99",
                "color_bits": "8"}
        self.passed([("clipper", clip, "clipper")], 10, 4, pixels, 9, 6,
                    {(x, y): pixels[y][x + 1] if y < 4 else 99
                     for x in range(9) for y in range(6)}, planes=1)

    def test_a_smaller_picture(self):
        pixels = [[20 * y + x for x in range(16)] for y in range(12)]
        small = {"width_in": "16", "height_in": "12", "width_scaling": "0.25",
                 "height_scaling": "0.5", "color_bits": "8", "color_planes": "1"}
        wide = {**small, "width_in": "4", "height_in": "6", "width_scaling": "3",
                "height_scaling": "1"}
        self.passed([("scaler", small, "scaler"), ("scaler", wide, "scaler")], 16, 12, pixels,
                    12, 6, {(x, y): pixels[2 * y][x // 3 * 4] for x in range(12)
                            for y in range(6)}, planes=1)

    def test_packets_by_the_way_that_is_chosen(self):
        """One way leaves the pixels alone, the other changes their colours."""
        bits = {"color_bits": "8", "color_planes": "3"}
        split = {**bits, "router_type": "Split"}
        merge = {**bits, "router_type": "Merge"}
        into = {"width": "4", "height": "4", **bits}
        modules = [("memory", "altera_avalon_onchip_memory2",
                    {"memorySize": "4096", "dataWidth": "32", "initMemContent": "false"}),
                   ("reads", UP + "dma_controller", into),
                   ("split", UP + "stream_router", split),
                   ("colors", UP + "csc", {}), ("merge", UP + "stream_router", merge),
                   ("writes", UP + "dma_controller", {**into, "mode": "From Stream to Memory",
                                                      "start_address": "0x100"}),
                   ("choice", "altera_avalon_pio", {"width": "1", "direction": "Output"})]
        router = "avalon_stream_router_"
        wires = [("avalon_streaming", *ends) for ends in [
            ("reads.avalon_pixel_source", "split." + router + "sink"),
            ("split." + router + "source_0", "merge." + router + "sink_0"),
            ("split." + router + "source_1", "colors.avalon_csc_sink"),
            ("colors.avalon_csc_source", "merge." + router + "sink_1"),
            ("split.avalon_sync_source", "merge.avalon_sync_sink"),
            ("merge." + router + "source", "writes.avalon_dma_sink")]]
        for name in "reads", "split", "colors", "merge", "writes", "choice":
            wires += [*clocked(name)]
        wires += [*clocked("memory", "clk1", "reset1"),
                  ("avalon", FULL, "memory.s1", 0), ("avalon", LW, "choice.s1", 0x40),
                  ("avalon", "reads.avalon_dma_master", "memory.s1", 0),
                  ("avalon", "writes.avalon_dma_master", "memory.s1", 0),
                  ("avalon", LW, "reads.avalon_dma_control_slave", 0x50),
                  ("avalon", LW, "writes.avalon_dma_control_slave", 0x60),
                  ("conduit", "split.external_interface", "choice.external_connection")]
        self.with_leds(modules, wires)
        pixels = [n * 0x0F1E2D & 0xFFFFFF for n in range(16)]
        ways = [pixels, [r << 16 | g << 8 | b for r, g, b in (
            rgb(p & 255, p >> 8 & 255, p >> 16) for p in pixels)]]
        table = ", ".join("{" + ", ".join(map(str, way)) + "}" for way in ways)
        self.program(f"""static const uint32_t ways[2][16] = {{{table}}};
volatile uint32_t* m = (volatile uint32_t*)0xC0000000;
for (int n = 0; n < 16; n++) m[n] = ways[0][n];
for (int times = 0; times < 50; times++) {{
    for (int way = 0; way < 2; way++) {{
        R32(0xFF200040) = way;
        for (unsigned same = 0; same < 3;) {{  // and it stays so
            unsigned wrong = 0;
            for (int n = 0; n < 16; n++) wrong += m[0x40 + n] != ways[way][n];
            same = wrong ? 0 : same + 1;
        }}
    }}
}}
R32(0xFF200000) = 341;""")
        self.shows(341)

    def test_a_camera_that_cannot_be_plugged_in(self):
        self.stream([("decoder", {"video_source": "5MP Digital Camera (TRDB_D5M)"}, "decoder")])
        self.refused("no camera can be plugged in", "check", "top.qsf")

    def test_a_clipper_that_leaves_nothing(self):
        self.stream([("clipper", {"drop_left": "400", "drop_right": "400"}, "clipper")])
        self.refused("drop_left and drop_right leave nothing of width_in, 720", "check", "top.qsf")


if __name__ == "__main__":
    run()
