"""frame_reader_test.py DE1SIM FOLDER [CASE...] - a frame reader with a clocked video output"""
import subprocess

from case import run
from systems import BASE, CLOCKS, LW, SystemCase, clocked, pio, png, qsys

# The beam of 640 x 480 at 60 Hz.
VGA = {"H_ACTIVE_PIXELS": "640", "V_ACTIVE_LINES": "480", "H_FRONT_PORCH": "16",
       "H_SYNC_LENGTH": "96", "H_BACK_PORCH": "48", "V_FRONT_PORCH": "10", "V_SYNC_LENGTH": "2",
       "V_BACK_PORCH": "33", "FIFO_DEPTH": "512", "THRESHOLD": "500"}
TOP = """module top(input CLOCK_50, output [9:0] LEDR, output reg VGA_CLK, output VGA_HS, VGA_VS,
    VGA_BLANK_N, output [7:0] VGA_R, VGA_G, VGA_B);
wire [{bits}:0] pixel; wire hs, vs;
assign {{VGA_R, VGA_G, VGA_B}} = pixel[23:0];
assign VGA_HS = !hs, VGA_VS = !vs;
initial VGA_CLK = 0;
always @(posedge CLOCK_50) VGA_CLK <= !VGA_CLK;
sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), .leds_export(LEDR), .video_vid_clk(VGA_CLK),
    .video_vid_data(pixel), .video_underflow(), .video_vid_datavalid(VGA_BLANK_N),
    .video_vid_v_sync(vs), .video_vid_h_sync(hs), .video_vid_f(), .video_vid_h(), .video_vid_v());
endmodule
"""
# The registers of frame 0 at 4, of frame 1 at 11.
PROGRAM = """volatile uint32_t* r = (volatile uint32_t*)0xFF201000;
for (int f = 0; f < 2; ++f) {{
    const uint32_t to = 0x20000000 + f * 0x200000;
    for (int y = 0; y < 480; ++y)
        for (int x = 0; x < 640; ++x) {{
            const uint32_t p = f ? x * 256 + (y & 255) : (x ^ y) * 0x10101;
            const int n = y * 640 + x;
            R32(to + {bytes} * (n / {pixels}) + 4 * (n % {pixels})) = p;
        }}
    volatile uint32_t* const of = r + (f ? 11 : 4);
    of[0] = to; of[1] = 640 * 480 / {pixels}; of[2] = 640 * 480; of[4] = 640; of[5] = 480;
    of[6] = 3;
}}
r[3] = 0; r[0] = 3;
while (!(r[2] & 2)) {{}}
r[2] = 2; r[3] = 1;
while (!(r[2] & 2)) {{}}
R32(0xFF200000) = r[0] | r[1] << 2 | (r[9] == 480) << 3;"""

LINUX = """#include <fcntl.h>
#include <stdint.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>
#include <linux/fb.h>
int main(void) {
    struct fb_fix_screeninfo fixed;
    struct fb_var_screeninfo screen;
    const int fd = open("/dev/fb0", O_RDWR);
    if (fd < 0 || ioctl(fd, FBIOGET_FSCREENINFO, &fixed) || ioctl(fd, FBIOGET_VSCREENINFO, &screen))
        return 1;
    uint8_t* const at = mmap(0, fixed.smem_len, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    if (at == MAP_FAILED) return 2;
    for (uint32_t y = 0; y < screen.yres; ++y)
        for (uint32_t x = 0; x < screen.xres; ++x)
            *(uint32_t*)(at + y * fixed.line_length + x * screen.bits_per_pixel / 8) =
                (x >> 8) << screen.red.offset | (x & 255) << screen.green.offset |
                (y & 255) << screen.blue.offset;
    pause();
}
"""


class FrameReader(SystemCase):
    def shown(self, port, processor, memory, linux=False):
        """Of pixels with four colour planes, as the processor's software has them."""
        leds, wires = pio("leds", 0)
        reader = {"BITS_PER_PIXEL_PER_COLOR_PLANE": "8", "MEM_PORT_WIDTH": str(memory),
                  "NUMBER_OF_CHANNELS_IN_PARALLEL": "4", "RMASTER_BURST_TARGET": "16"}
        clock = "f2h_axi_clock" if port == "f2h_axi_slave" else "f2h_sdram0_clock"
        self.write(
            sys_qsys=qsys([BASE[0], ("hps_0", "altera_hps", {**BASE[1][2], **processor}), *leds,
                           ("reader", "alt_vip_vfr", reader),
                           ("video", "alt_vip_itc", {**VGA, "NUMBER_OF_COLOUR_PLANES": "4"})],
                          [*CLOCKS, *wires, *clocked("reader", "clock_reset", "clock_reset_reset"),
                           *clocked("reader", "clock_master", "clock_master_reset"),
                           *clocked("video", "is_clk_rst", "is_clk_rst_reset"),
                           ("clock", "clk_0.clk", f"hps_0.{clock}"),
                           ("avalon", LW, "reader.avalon_slave", 0x1000),
                           ("avalon", "reader.avalon_master", f"hps_0.{port}", 0),
                           ("avalon_streaming", "reader.avalon_streaming_source", "video.din")],
                          [("leds", "leds.external_connection"),
                           ("video", "video.clocked_video")]),
            top_v=TOP.format(bits=31),
            top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                    "set_global_assignment -name VERILOG_FILE top.v\n"
                    "set_global_assignment -name QSYS_FILE sys.qsys\n")
        if linux:
            self.write(picture_c=LINUX)
            subprocess.run(["arm-linux-gnueabihf-gcc", "-static", "picture.c", "-o", "program.elf"],
                           cwd=self.folder, check=True)
        else:
            self.program(PROGRAM.format(bytes=memory // 8, pixels=memory // 32))
        png(self.folder / "golden.png",
            [[(x >> 8 & 255, x & 255, y & 255) for x in range(640)] for y in range(480)])
        lit = [] if linux else ["expect-leds: {equals: 15, timeout: 900ms}"]
        self.played(*lit, "delay: 200ms",
                    "expect-frame: {equals: golden.png}")

    def test_frames_of_the_processors_sdram(self):
        self.shown("f2h_sdram0_data", {"F2SDRAM_Type": "Avalon-MM Bidirectional",
                                       "F2SDRAM_Width": "64"}, 64)

    def test_frames_by_the_bridge(self):
        self.shown("f2h_axi_slave", {"F2S_Width": "3"}, 128)

    def test_frames_of_a_linux_program(self):
        self.shown("f2h_axi_slave", {"F2S_Width": "2"}, 64, linux=True)

    def test_what_is_not_simulated_is_refused(self):
        for parameter, what in (("USE_CONTROL", "the control port"),
                                ("USE_EMBEDDED_SYNCS", "embedded syncs"),
                                ("INTERLACED", "interlaced video")):
            self.refuses(what, [("video", "alt_vip_itc", {**VGA, parameter: "1"})],
                         clocked("video", "is_clk_rst", "is_clk_rst_reset"))


run()
