"""fifo_test.py DE1SIM FOLDER [CASE...] - Platform Designer's FIFO in a system"""
from case import run
from systems import LW, SystemCase, clocked

DUAL = {"singleClockMode": "false"}
TOP = """module top(input CLOCK_50, input [9:0] SW, output [9:0] LEDR);
reg  [31:0] data;  // Quartus takes it from a system
wire        ready;
reg  [9:0]  shown;
sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), .out_PORT(ready), .out_ASK(ASKS),
    .out_DATA(data));
reg read;
always @(posedge CLOCK_50) begin read <= TAKES; if (read) shown <= data[9:0]; end
assign LEDR = shown;
endmodule
"""


class Fifo(SystemCase):
    def fifo(self, body, wires=(), exports=(), **parameters):
        clocks = [*clocked("fifo", "clk_in", "reset_in"),
                  ("avalon", LW, "fifo.in", 0x40), ("avalon", LW, "fifo.in_csr", 0x60)]
        if parameters.get("singleClockMode") == "false":
            clocks += [("clock", "clk_0.clk", "fifo.clk_out"),
                       ("avalon", LW, "fifo.out_csr", 0x80)]
            if parameters.get("singleResetMode") != "true":
                clocks += [("reset", "clk_0.clk_reset", "fifo.reset_out")]
        self.with_leds([("fifo", "altera_avalon_fifo", {"usePacket": "false", **parameters})],
                       [*clocks, *wires], exports)
        self.program("#define LEDS R32(0xFF200000)\n#define IN R32(0xFF200040)\n"
                     "#define OUT R32(0xFF2000C0)\nvolatile uint32_t* in = (uint32_t*)0xFF200060;\n"
                     "volatile uint32_t* out = (uint32_t*)0xFF200080;\n" + body)

    OUT = [("avalon", LW, "fifo.out", 0xC0)]
    IRQ = [("interrupt", "hps_0.f2h_irq0", "fifo.in_irq", 3)]

    def test_words_come_out_in_order(self):
        self.fifo("uint32_t all = in[1] == 0xA, n;\n"  # empty, almost empty
                  "for (n = 1; n <= 5; n++) IN = 3 * n;\n"
                  "all |= (in[0] == 5) << 1; all |= (in[1] == 0) << 2;\n"
                  "for (n = 1; n <= 5 && OUT == 3 * n; n++) {}\n"
                  "all |= (n == 6) << 3; all |= (in[0] == 0) << 4;\n"
                  "LEDS = all;\n", self.OUT)
        self.shows(0x1F)

    def test_a_threshold_interrupts_until_its_event_is_cleared(self):
        self.fifo("#define PENDING (R32(0xFFFED208) >> 11 & 1)\n"
                  "in[4] = 3; in[3] = 4; in[5] = 99;\n"
                  "uint32_t all = in[4] == 3 && in[5] == 15;\n"
                  "IN = 1; IN = 2; all |= !PENDING << 1;\n"
                  "IN = 3; all |= PENDING << 2; all |= (in[2] & 4) << 1; all |= (in[1] & 4) << 2;\n"
                  "in[2] = 4; all |= !PENDING << 5;\nLEDS = all;\n", [*self.OUT, *self.IRQ])
        self.shows(0x3F)

    def test_two_clocks_have_a_control_slave_each(self):
        self.fifo("for (uint32_t n = 0; n < 252; n++) IN = n;\n"
                  "uint32_t all = in[0] == 252; all |= (in[1] == 4) << 1;\n"   # almost full
                  "IN = 252; all |= (in[1] == 5) << 2; all |= (out[0] == 253) << 3;\n"
                  "uint32_t n = 0;\nwhile (n < 253 && OUT == n) n++;\n"
                  "all |= (n == 253) << 4; all |= (out[1] == 0xA) << 5;\nLEDS = all;\n", self.OUT,
                  fifoDepth="256", **DUAL)
        self.shows(0x3F)

    def test_one_reset_serves_both_sides(self):
        self.fifo("IN = 0x155; LEDS = OUT;\n", self.OUT, singleResetMode="true", **DUAL)
        self.shows(0x155)

    def test_a_write_into_a_full_one_waits_for_ever(self):
        self.fifo("for (uint32_t n = 0; n < 17; n++) { LEDS = n; IN = n; }\n", self.OUT)
        done = self.de1sim("run", "--elf", "program.elf", "--project", "top.qsf",
                           "--duration", "30ms")
        self.assertEqual(done.returncode, 1)
        self.assertIn("write of 4 bytes at 0xFF200040 (fifo did not answer", done.stderr)

    def test_without_backpressure_it_is_lost(self):
        self.fifo("for (uint32_t n = 0; n < 17; n++) IN = n;\n"
                  "uint32_t all = (in[2] & 0x10) != 0, n = 0;\nwhile (n < 16 && OUT == n) n++;\n"
                  "all |= (n == 16) << 1; all |= (OUT == 15) << 2; all |= (in[2] & 0x20) >> 2;\n"
                  "LEDS = all;\n", self.OUT, useBackpressure="false")
        self.shows(0xF)

    def exported(self, port, ask, asks, takes, **parameters):
        self.fifo("IN = 0x11223344;\n", exports=[("out", "fifo.out")], **parameters)
        text = TOP.replace(".out_DATA", ".out_" + ("data" if port == "valid" else "readdata"))
        for word, value in {"PORT": port, "ASKS": asks, "ASK": ask, "TAKES": takes}.items():
            text = text.replace(word, value)
        file = self.folder / "sys.qsys"
        file.write_text("".join(line for line in file.read_text().splitlines(True)
                                if 'name="leds" internal' not in line))
        self.write(top_v=text)

    def test_the_top_reads_it(self):
        self.exported("waitrequest", "read", "!ready", "!ready", **DUAL)
        self.shows(0x344)

    def test_a_stream_begins_with_the_lowest_byte_of_a_word(self):
        self.exported("valid", "ready", "1'b1", "1'b0", bitsPerSymbol="8", symbolsPerBeat="4",
                      fifoOutputInterfaceOptions="AVALONST_SOURCE")
        file = self.folder / "top.v"
        file.write_text(file.read_text().replace("read <= 1'b0; if (read)", "if (ready)"))
        self.shows(0x211)

    def test_a_stream_without_backpressure_flows(self):
        self.exported("valid", "ready", "1'b1", "1'b0", bitsPerSymbol="8", symbolsPerBeat="4",
                      fifoOutputInterfaceOptions="AVALONST_SOURCE", useBackpressure="false")
        file = self.folder / "top.v"
        file.write_text(file.read_text().replace("read <= 1'b0; if (read)", "if (ready)")
                        .replace(" .out_ready(1'b1),", ""))
        self.program("IN = 0x40000000; IN = 0xFF010000;\n".replace("IN", "R32(0xFF200040)"))
        self.shows(0x1FF)

    def test_a_stream_goes_a_clock_after_ready(self):
        """The word that is there when ready falls still comes."""
        self.exported("valid", "ready", "asks", "1'b0", bitsPerSymbol="8", symbolsPerBeat="4",
                      fifoOutputInterfaceOptions="AVALONST_SOURCE")
        file = self.folder / "top.v"
        file.write_text(file.read_text().replace(
            "read <= 1'b0; if (read) shown <= data[9:0];",
            "asks <= !asks && !SW[0]; if (ready) begin shown <= shown + 1;"
            " if (asks) shown <= 10'h3FF; end").replace("reg read;", "reg asks;"))
        self.program("for (int n = 0; n < 16; n++) IN = n;\n".replace("IN", "R32(0xFF200040)"))
        self.shows(16)

    def test_what_cannot_be_simulated_is_refused(self):
        for parameters, message in (({"fifoDepth": "12"}, "fifoDepth is 12, expected a power"),
                                    ({"channelWidth": "9"}, "channelWidth is 9, expected 0 to")):
            self.fifo("", **parameters)
            done = self.de1sim("check", "top.qsf")
            self.assertEqual(done.returncode, 2)
            self.assertIn(message, done.stderr)


if __name__ == "__main__":
    run()
