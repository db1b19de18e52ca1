"""university_test.py DE1SIM FOLDER [CASE...] - the University Program's cores in a system"""
from case import run
from systems import LW, SystemCase, pio

SOUND = [("pll", "altera_up_avalon_audio_pll", {}),
         ("av_config", "altera_up_avalon_audio_and_video_config",
          {"bit_length": "16", "sampling_rate": "8 kHz", "AUTO_CLK_CLOCK_RATE": "50000000"})]
SOUND_WIRES = [("clock", "clk_0.clk", "pll.ref_clk"), ("reset", "clk_0.clk_reset", "pll.ref_reset"),
               ("clock", "clk_0.clk", "av_config.clk"), ("reset", "clk_0.clk_reset", "av_config.reset"),
               ("clock", "clk_0.clk", "audio.clk"), ("reset", "clk_0.clk_reset", "audio.reset"),
               ("avalon", LW, "av_config.avalon_av_config_slave", 0x20)]
SOUND_EXPORTS = [("xck", "pll.audio_clk"), ("i2c", "av_config.external_interface"),
                 ("codec", "audio.external_interface")]
SOUND_TOP = """, .xck_clk(AUD_XCK), .i2c_SDAT(FPGA_I2C_SDAT), .i2c_SCLK(FPGA_I2C_SCLK),
.codec_BCLK(AUD_BCLK), .codec_DACDAT(AUD_DACDAT), .codec_DACLRCK(AUD_DACLRCK)"""
SOUND_IN = ", .codec_ADCDAT(AUD_ADCDAT), .codec_ADCLRCK(AUD_ADCLRCK)"
SOUND_PORTS = """, output AUD_XCK, inout FPGA_I2C_SDAT, output FPGA_I2C_SCLK, inout AUD_BCLK,
output AUD_DACDAT, inout AUD_DACLRCK, input AUD_ADCDAT, inout AUD_ADCLRCK"""

STREAM_TCL = """set_module_property NAME square
add_fileset QUARTUS_SYNTH QUARTUS_SYNTH "" ""
set_fileset_property QUARTUS_SYNTH TOP_LEVEL square
add_fileset_file square.v VERILOG PATH square.v
add_interface clock clock end
add_interface_port clock clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clock
add_interface_port reset reset reset Input 1
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
                    ", .leds_export(LEDR)" + top)
        file = self.folder / "top.v"
        file.write_text(file.read_text().replace("output [9:0] LEDR", "output [9:0] LEDR" +
                                                 SOUND_PORTS))
        self.program("volatile uint32_t* a = (volatile uint32_t*)0xFF200040;\n"
                     "volatile uint32_t* c = (volatile uint32_t*)0xFF200020;\n" + body)
        self.write(s_yaml="name: s\nversion: 1\nprogram: program.elf\nproject: top.qsf\nsteps:\n" +
                          "".join(f"  - {step}\n" for step in steps))
        done = self.de1sim("run", "s.yaml")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

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
                   [("clock", "clk_0.clk", "square.clock"),
                    ("reset", "clk_0.clk_reset", "square.reset"),
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


if __name__ == "__main__":
    run()
