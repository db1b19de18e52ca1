"""university_test.py DE1SIM FOLDER [CASE...] - the University Program's cores in a system"""
import pathlib
import re
import subprocess

from case import run
from systems import FULL, HW_TCL, LW, SystemCase, clocked, pio, png, qsys

SOUND = [("pll", "altera_up_avalon_audio_pll", {}),
         ("av_config", "altera_up_avalon_audio_and_video_config",
          {"bit_length": "16", "sampling_rate": "8 kHz", "AUTO_CLK_CLOCK_RATE": "50000000"})]
SOUND_WIRES = [*clocked("pll", "ref_clk", "ref_reset"), *clocked("av_config"), *clocked("audio"),
               ("avalon", LW, "av_config.avalon_av_config_slave", 0x20)]
SOUND_EXPORTS = [("xck", "pll.audio_clk"), ("i2c", "av_config.external_interface"),
                 ("codec", "audio.external_interface")]
SOUND_TOP = """, .xck_clk(AUD_XCK), .i2c_SDAT(FPGA_I2C_SDAT), .i2c_SCLK(FPGA_I2C_SCLK),
.codec_BCLK(AUD_BCLK), .codec_DACDAT(AUD_DACDAT), .codec_DACLRCK(AUD_DACLRCK)"""
SOUND_IN = ", .codec_ADCDAT(AUD_ADCDAT), .codec_ADCLRCK(AUD_ADCLRCK)"
SOUND_PORTS = """, output AUD_XCK, inout FPGA_I2C_SDAT, output FPGA_I2C_SCLK, inout AUD_BCLK,
output AUD_DACDAT, inout AUD_DACLRCK, input AUD_ADCDAT, inout AUD_ADCLRCK"""
ADC_TOP = """, .adc_sclk(ADC_SCLK), .adc_cs_n(ADC_CS_N), .adc_dout(ADC_DOUT),
.adc_din(ADC_DIN)"""
ADC_PORTS = ", output ADC_SCLK, output ADC_CS_N, input ADC_DOUT, output ADC_DIN"

STREAM_TCL = HW_TCL.format(name="square") + """\
foreach side {left right} {
    add_interface $side avalon_streaming start
    set_interface_property $side associatedClock clock
    add_interface_port $side ${side}_data data Output 16
    add_interface_port $side ${side}_valid valid Output 1
    add_interface_port $side ${side}_ready ready Input 1
}
"""
STREAM = """module square(input clk, input reset, output [15:0] left_data, output left_valid,
input left_ready, output [15:0] right_data, output right_valid, input right_ready);
reg [3:0] n;
assign left_data = n[3] ? 16'h2000 : 16'he000, right_data = left_data;
assign left_valid = left_ready && right_ready, right_valid = left_valid;
always @(posedge clk) if (reset) n <= 0; else if (left_valid) n <= n + 1;
endmodule
"""


class Sound(SystemCase):
    def sound(self, audio, wires=(), modules=(), exports=(), top=SOUND_TOP, body="", steps=()):
        leds, led_wires = pio("leds", 0)
        self.system([*SOUND, ("audio", "altera_up_avalon_audio", {"dw": "16", **audio}), *leds,
                     *modules], [*SOUND_WIRES, *led_wires, *wires],
                    [("leds", "leds.external_connection"), *SOUND_EXPORTS, *exports],
                    ", .leds_export(LEDR)" + top, SOUND_PORTS)
        self.program("volatile uint32_t* a = (volatile uint32_t*)0xFF200040;\n"
                     "volatile uint32_t* c = (volatile uint32_t*)0xFF200020;\n" + body)
        self.played(*steps)

    def test_a_program_plays_by_the_registers(self):
        self.sound({}, [("avalon", LW, "audio.avalon_audio_slave", 0x40)], top=SOUND_TOP + SOUND_IN,
                   body="for (uint32_t n = 0;; n++) { while ((a[1] >> 16 & 0xFF) == 0) {}\n"
                        "a[2] = a[3] = n & 8 ? 0x2000 : 0xE000;\n"
                        "R32(0xFF200000) = c[1] & 0x102; }\n",
                   steps=["expect-tone: {hz: 500, for: 60ms, timeout: 400ms}",
                          'expect-leds: {equals: "0100000010", timeout: 10ms}'])

    def test_what_is_heard_is_read(self):
        self.sound({}, [("avalon", LW, "audio.avalon_audio_slave", 0x40)], top=SOUND_TOP + SOUND_IN,
                   body="for (;;) if (a[1] & 0xFF && (a[1] >> 8 & 0xFF)) {\n"
                        "int16_t l = a[2], r = a[3];\n"
                        "if (l > 9000 && l == r) R32(0xFF200000) = 0x155; }\n",
                   steps=["delay: 30ms", "play-tone: {hz: 400}",
                          'expect-leds: {equals: "0101010101", timeout: 200ms}'])

    def test_a_component_plays_by_streams(self):
        (self.folder / "square_hw.tcl").write_text(STREAM_TCL)
        self.write(square_v=STREAM)
        self.sound({"avalon_bus_type": "Streaming", "audio_in": "false"},
                   [*clocked("square", "clock"),
                    ("avalon_streaming", "square.left", "audio.avalon_left_channel_sink"),
                    ("avalon_streaming", "square.right", "audio.avalon_right_channel_sink")],
                   [("square", "square", {})],
                   steps=["expect-tone: {hz: 500, for: 60ms, timeout: 400ms}"])

    def test_words_by_hand_mute_the_codec(self):
        self.sound({}, [("avalon", LW, "audio.avalon_audio_slave", 0x40)], top=SOUND_TOP + SOUND_IN,
                   body="for (uint32_t n = 0;; n++) { while ((a[1] >> 16 & 0xFF) == 0) {}\n"
                        "a[2] = a[3] = n & 8 ? 0x2000 : 0xE000;\n"
                        "if (n == 1600) { c[2] = 5; c[3] = 8; } }\n",
                   steps=["expect-tone: {hz: 500, for: 60ms, timeout: 300ms}",
                          "delay: 250ms", "expect-silence: {for: 50ms}"])


class Adc(SystemCase):
    def adc(self, body, leds, code=0, **parameters):
        self.with_leds([("adc", "altera_up_avalon_adc", {"AUTO_CLK_CLOCK_RATE": "50000000",
                                                         **parameters})],
                       [*clocked("adc"),
                        ("avalon", LW, "adc.adc_slave", 0x40)],
                       exports=[("adc", "adc.external_interface")], top=ADC_TOP, ports=ADC_PORTS)
        self.program("volatile uint32_t* a = (volatile uint32_t*)0xFF200040;\n" + body)
        return self.played("set-voltage: {channel: 0, volts: 0.5}",
                           "set-voltage: {channel: 1, volts: 1.25}",
                           "set-voltage: {channel: 7, volts: 2.5}",
                           f"expect-leds: {{equals: {leds}, timeout: 10ms}}", code=code)

    def test_a_read_waits_for_the_round_that_was_asked_for(self):
        self.adc("for (;;) { a[0] = 0; R32(0xFF200000) = a[7] >> 2; }\n", 2500 >> 2)

    def test_continuous_channels_are_new_once(self):
        self.adc("a[1] = 1;\nfor (;;) { while (!(a[1] & 0x8000)) {}\n"
                   "if (a[1] == 1250) R32(0xFF200000) = a[0] & 0xFFF; }\n", 500)

    def test_channels_beyond_the_last_are_0(self):
        self.adc("for (;;) { a[0] = 0;\n"
                   "R32(0xFF200000) = a[7] == 0 && a[1] == 1250 ? a[0] : 1; }\n", 500, numch_="2")

    def test_nine_channels_are_refused(self):
        self.assertIn("numch_ is 9, expected 1 to 8", self.adc("", 0, 2, numch_="9").stderr)


class Ps2(SystemCase):
    def ps2(self, body, *steps, code=0, **parameters):
        self.with_leds([("ps2", "altera_up_avalon_ps2", {"AUTO_CLK_CLOCK_RATE": "50000000",
                                                         **parameters})],
                       [*clocked("ps2"),
                        ("interrupt", "hps_0.f2h_irq0", "ps2.interrupt", 3),
                        ("avalon", LW, "ps2.avalon_ps2_slave", 0x40)],
                       exports=[("ps2", "ps2.external_interface")],
                       top=", .ps2_CLK(PS2_CLK), .ps2_DAT(PS2_DAT)",
                       ports=", inout PS2_CLK, inout PS2_DAT")
        self.program("#define DATA R32(0xFF200040)\n#define CONTROL R32(0xFF200044)\n"
                     "#define LEDS R32(0xFF200000)\nuint32_t d;\n" + body)
        return self.played(*steps, head="ps2: keyboard\n", code=code)

    # The keyboard sends AA when its self-test ends, half a second after the start.
    def test_a_keyboard_interrupts_answers_and_types(self):
        self.ps2("CONTROL = 1;\nwhile (!(R32(0xFFFED208) & 0x800)) {}\n"
                   "d = CONTROL << 16; d |= R8(0xFF200041); d |= DATA & 0xFF;\n"
                   "if (d == 0x010100AA && CONTROL == 1 && !(R32(0xFFFED208) & 0x800)) LEDS = 1;\n"
                   "DATA = 0xF2;\n"
                   "for (uint32_t all = 0;;) { d = DATA;\n"
                   "if (d & 0x8000) all = all << 8 | (d & 0xFF);\n"
                   "if (all == 0xFAAB83) LEDS |= 2;\n"
                   "if (all == 0x831CF01C) LEDS |= 4; }\n",
                   "expect-leds: {equals: 1, timeout: 600ms}",
                   "expect-leds: {equals: 3, timeout: 20ms}", "press-key: a",
                   "expect-leds: {equals: 7, timeout: 20ms}")

    def test_streams_are_refused(self):
        done = self.ps2("", "delay: 1ms", code=2, avalon_bus_type="Streaming")
        self.assertIn('avalon_bus_type is "Streaming"', done.stderr)


FONT = pathlib.Path(__file__).resolve().parents[2] / "rtl/vga/character_font.vh"
UP = "altera_up_avalon_video_"


class Screen(SystemCase):
    """A subsystem with a picture of 80 x 60 pixels of RGB 3-3-2, 8 times as large, under text."""
    def screen(self, body, mode="Simple"):
        parts = [("clock", "clock_source", {}),
                 ("dma", UP + "pixel_buffer_dma", {"image_width": "80", "image_height": "60",
                                                   "color_space": "8-bit RGB",
                                                   "back_start_address": "0x2000"}),
                 ("colors", UP + "rgb_resampler", {"input_type": "8-bit RGB"}),
                 ("scaler", UP + "scaler", {"width_in": "80", "height_in": "60",
                                            "width_scaling": "8", "height_scaling": "8"}),
                 ("text", UP + "character_buffer_with_dma", {}),
                 ("blender", UP + "alpha_blender", {"mode": mode}),
                 ("buffer", UP + "dual_clock_buffer", {}),
                 ("pll", UP + "pll", {}), ("vga", UP + "vga_controller", {})]
        wires = [("avalon_streaming", *ends) for ends in [
            ("dma.avalon_pixel_source", "colors.avalon_rgb_sink"),
            ("colors.avalon_rgb_source", "scaler.avalon_scaler_sink"),
            ("scaler.avalon_scaler_source", "blender.avalon_background_sink"),
            ("text.avalon_char_source", "blender.avalon_foreground_sink"),
            ("blender.avalon_blended_source", "buffer.avalon_dc_buffer_sink"),
            ("buffer.avalon_dc_buffer_source", "vga.avalon_vga_sink")]]
        for name in "dma", "colors", "scaler", "text", "blender":
            wires += [("clock", "clock.clk", name + ".clk"),
                      ("reset", "clock.clk_reset", name + ".reset")]
        wires += [("clock", "clock.clk", "buffer.clock_stream_in"),
                  ("reset", "clock.clk_reset", "buffer.reset_stream_in"),
                  ("clock", "pll.vga_clk", "buffer.clock_stream_out"),
                  ("reset", "pll.reset_source", "buffer.reset_stream_out"),
                  ("clock", "pll.vga_clk", "vga.clk"), ("reset", "pll.reset_source", "vga.reset"),
                  ("clock", "clock.clk", "pll.ref_clk"),
                  ("reset", "clock.clk_reset", "pll.ref_reset")]
        exports = [("reads", "dma.avalon_pixel_dma_master"), ("dma", "dma.avalon_control_slave"),
                   ("chars", "text.avalon_char_buffer_slave"),
                   ("text", "text.avalon_char_control_slave"), ("vga", "vga.external_interface"),
                   ("clk_in", "clock.clk_in"), ("clk_in_reset", "clock.clk_in_reset")]
        self.write(screen_qsys=qsys(parts, wires, exports, clock=""))
        leds, led_wires = pio("leds", 0)
        memory = {"memorySize": "16384", "dataWidth": "32", "initMemContent": "false"}
        self.system([("view", "screen", {}), ("memory", "altera_avalon_onchip_memory2", memory),
                     ("translation", UP + "dma_ctrl_addr_trans", {}), *leds],
                    [*led_wires, *clocked("view", "clk_in", "clk_in_reset"),
                     *clocked("memory", "clk1", "reset1"), *clocked("translation", "clock"),
                     ("avalon", FULL, "memory.s1", 0), ("avalon", "view.reads", "memory.s1", 0),
                     ("avalon", LW, "translation.slave", 0x20),
                     ("avalon", "translation.master", "view.dma", 0),
                     ("avalon", FULL, "view.chars", 0x8000), ("avalon", LW, "view.text", 0x30)],
                    [("leds", "leds.external_connection"), ("vga", "view.vga")],
                    ", .leds_export(LEDR), " + ", ".join(
                        f".vga_{role}(VGA_{pin})" for role, pin in [
                            ("CLK", "CLK"), ("HS", "HS"), ("VS", "VS"), ("BLANK", "BLANK_N"),
                            ("SYNC", "SYNC_N"), ("R", "R"), ("G", "G"), ("B", "B")]))
        file = self.folder / "top.v"
        file.write_text(file.read_text().replace(
            "output [9:0] LEDR", "output [9:0] LEDR, output VGA_CLK, VGA_HS, VGA_VS, VGA_BLANK_N,\n"
                                 "VGA_SYNC_N, output [7:0] VGA_R, VGA_G, VGA_B"))
        self.program("volatile uint8_t* m = (volatile uint8_t*)0xC0000000;\n"
                     "volatile uint8_t* c = (volatile uint8_t*)0xC0008000;\n"
                     "volatile uint32_t* d = (volatile uint32_t*)0xFF200020;\n" + body +
                     "R32(0xFF200000) = 0x155;")

    def shown(self, pixel, text):
        """pixel(x, y) in RGB 3-3-2; text: characters by line and column."""
        shapes = {int(code, 16): int(bits, 16) for code, bits in
                  re.findall(r"7'h(\w+): +letter = 64'h(\w+)", FONT.read_text())}

        def grown(value, bits):
            return int((f"{value:0{bits}b}" * 10)[:8], 2)

        def at(x, y):
            bits = shapes[ord(text[y // 8, x // 8])] if (y // 8, x // 8) in text else 0
            if bits >> (8 * (y % 8) + x % 8) & 1:
                return 255, 255, 255
            value = pixel(x // 8, y // 8)
            return grown(value >> 5, 3), grown(value >> 2 & 7, 3), grown(value & 3, 2)

        png(self.folder / "golden.png", [[at(x, y) for x in range(640)] for y in range(480)])
        self.played("expect-leds: {equals: 341, timeout: 500ms}", "delay: 100ms",
                    "expect-frame: {equals: golden.png}")

    DRAW = ("for (int y = 0; y < 60; y++) for (int x = 0; x < 80; x++) "
            "m[{} + (y << 7) + x] = {};\n")
    TEXT = "while (R32(0xFF200030)) {} c[2 * 128 + 3] = 'A'; c[59 * 128 + 79] = 'z';\n"

    def test_a_picture_and_text(self):
        self.screen(self.TEXT + self.DRAW.format(0, "x ^ y * 4"))
        self.shown(lambda x, y: (x ^ y * 4) & 255, {(2, 3): "A", (59, 79): "z"})

    def test_two_buffers_and_the_processors_addresses(self):
        self.screen(self.DRAW.format(0, "255") + self.DRAW.format("0x2000", "x + y") +
                    "uint32_t ok = d[0] == 0xC0000000 && d[1] == 0xC0002000 && "
                    "d[2] == 0x003C0050 && (d[3] & 7) == 4;\n"
                    "d[0] = 1; while (d[3] & 1) {}\n"
                    "d[1] = 0xC0001000; ok &= d[0] == 0xC0002000 && d[1] == 0xC0001000;\n"
                    "while (!ok) {}\n", mode="Normal")
        self.shown(lambda x, y: x + y, {})

    FB0 = """#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <sys/ioctl.h>
#include <linux/fb.h>
int main(void) {
    struct fb_fix_screeninfo fixed;
    struct fb_var_screeninfo screen;
    const int fd = open("/dev/fb0", O_RDWR);
    if (fd < 0 || ioctl(fd, FBIOGET_FSCREENINFO, &fixed) || ioctl(fd, FBIOGET_VSCREENINFO, &screen))
        return perror("fb0"), 0;
    printf("0x%lx %u: %u x %u, %u, %u\\n", fixed.smem_start, fixed.line_length, screen.xres,
           screen.yres, screen.bits_per_pixel, screen.red.offset);
}
"""

    def test_a_linux_program_has_the_frame_buffer_of_the_system(self):
        memory = {"memorySize": "65536", "dataWidth": "32", "initMemContent": "false"}
        size = {"image_width": "80", "image_height": "60", "start_address": "0x1000"}
        for parameters, printed in (
                (None, "fb0: No such file or directory"),
                ({"color_space": "16-bit RGB"}, "0xc0021000 256: 80 x 60, 16, 11"),
                ({"color_space": "24-bit RGB", "addr_mode": "Consecutive"},
                 "0xc0021000 320: 80 x 60, 32, 16")):
            modules = [("memory", "altera_avalon_onchip_memory2", memory)]
            wires = [*clocked("memory", "clk1", "reset1"), ("avalon", FULL, "memory.s1", 0x20000)]
            if parameters:
                modules += [("dma", UP + "pixel_buffer_dma", {**size, **parameters})]
                wires += [*clocked("dma"),
                          ("avalon", "dma.avalon_pixel_dma_master", "memory.s1", 0),
                          ("avalon", LW, "dma.avalon_control_slave", 0)]
            self.system(modules, wires)
            self.write(fb0_c=self.FB0)
            subprocess.run(["arm-linux-gnueabihf-gcc", "-static", "fb0.c", "-o", "fb0"],
                           cwd=self.folder, check=True)
            done = self.de1sim("run", "--elf", "fb0", "--project", "top.qsf")
            self.assertIn(printed, done.stdout + done.stderr)

    def test_a_subsystem_that_contains_itself(self):
        self.screen("")
        self.write(screen_qsys=qsys([("again", "screen", {})], [], clock=""))
        self.refused("screen.qsys: screen.qsys contains itself")


if __name__ == "__main__":
    run()
