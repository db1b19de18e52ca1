"""masters_test.py DE1SIM FOLDER [CASE...] - masters in the FPGA on the processor's memory"""
from case import run
from systems import HW_TCL, LW, OWN_CLOCK, BASE, CLOCKS, TOP, SystemCase, clocked, pio, qsys

# Registers: 0 source, 1 destination, 2 words of 64 bits, which begins, 3 words that are to come.
COPIER = """module copier(input clk, reset, input [1:0] s_address, input s_write,
    input [31:0] s_writedata, output [31:0] s_readdata,
    output reg [31:0] m_address, output reg [4:0] m_burstcount,
    output reg m_read, m_write, output [63:0] m_writedata, input [63:0] m_readdata,
    input m_readdatavalid, m_waitrequest);
reg [31:0] from, to;
reg [15:0] left;
reg [63:0] words [0:15];
reg [4:0] got, put;
reg waits;
wire [4:0] burst = left > 16 ? 16 : left;
assign s_readdata = left;
assign m_writedata = words[put];
always @(posedge clk)
    if (reset) begin left <= 0; m_read <= 0; m_write <= 0; waits <= 0; end
    else begin
        if (s_write) case (s_address)
            0: from <= s_writedata;
            1: to <= s_writedata;
            2: left <= s_writedata;
        endcase
        if (m_readdatavalid) begin words[got] <= m_readdata; got <= got + 1; end
        if (m_read) begin
            if (!m_waitrequest) begin m_read <= 0; waits <= 1; end
        end else if (m_write) begin
            if (!m_waitrequest) begin
                put <= put + 1;
                if (put == m_burstcount - 1) begin
                    m_write <= 0;
                    left <= left - m_burstcount;
                    from <= from + 8 * m_burstcount;
                    to <= to + 8 * m_burstcount;
                end
            end
        end else if (waits) begin
            if (got == m_burstcount) begin waits <= 0; m_write <= 1; m_address <= to; put <= 0; end
        end else if (left != 0) begin
            m_read <= 1; m_address <= from; m_burstcount <= burst; got <= 0;
        end
    end
endmodule
"""
PORTS = "".join(f"add_interface_port m m_{role} {role} {direction} {bits}\n"
                for role, direction, bits in (
                    ("address", "Output", 32), ("burstcount", "Output", 5), ("read", "Output", 1),
                    ("write", "Output", 1), ("writedata", "Output", 64), ("readdata", "Input", 64),
                    ("readdatavalid", "Input", 1), ("waitrequest", "Input", 1)))
COPIER_TCL = HW_TCL.format(name="copier") + f"""add_interface s avalon end
{OWN_CLOCK}add_interface_port s s_address address Input 2
add_interface_port s s_write write Input 1
add_interface_port s s_writedata writedata Input 32
add_interface_port s s_readdata readdata Output 32
add_interface m avalon start
set_interface_property m associatedClock clock
set_interface_property m associatedReset reset
set_interface_property m addressUnits SYMBOLS
{PORTS}"""
COPY = """enum {{ FROM = 0x20000000, TO = {to:#x}, WORDS = 45 }};
for (int n = 0; n < 2 * WORDS; ++n) R32(FROM + 4 * n) = 0x01010101 * n;
R32(0xFF201000) = {there:#x} + FROM;
R32(0xFF201004) = {there:#x} + TO;
R32(0xFF201008) = WORDS;
while (R32(0xFF20100C)) {{}}
uint32_t wrong = 0;
for (int n = 0; n < 2 * WORDS; ++n) wrong |= R32(TO + 4 * n) ^ 0x01010101 * n;
R32(0xFF200000) = wrong ? 1 : R32(TO + 4 * 88) & 0x3FF;"""
SHOWN = 88 * 0x101 & 0x3FF


class Masters(SystemCase):
    def copier(self, processor, port, body):
        modules, wires = pio("leds", 0)
        clock = "f2h_axi_clock" if port == "f2h_axi_slave" else "f2h_sdram0_clock"
        hps = ("hps_0", "altera_hps", {**BASE[1][2], **processor})
        self.write(
            copier_v=COPIER, copier_hw_tcl=COPIER_TCL,
            sys_qsys=qsys([BASE[0], hps, *modules, ("copier_0", "copier", {})],
                          [*CLOCKS, *wires, *clocked("copier_0", "clock"),
                           ("avalon", LW, "copier_0.s", 0x1000),
                           ("clock", "clk_0.clk", f"hps_0.{clock}"),
                           ("avalon", "copier_0.m", f"hps_0.{port}", 0)],
                          [("leds", "leds.external_connection")]),
            top_v=TOP.format(", .leds_export(LEDR)", ""),
            top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                    "set_global_assignment -name VERILOG_FILE top.v\n"
                    "set_global_assignment -name QSYS_FILE sys.qsys\n")
        self.program(body)

    def test_copy_by_a_port_to_the_sdram(self):
        for kinds, widths in (("Avalon-MM Bidirectional", "64"),
                              ("Avalon-MM Bidirectional,AXI-3", "256,64"), ("AXI-3", "32")):
            self.copier({"F2SDRAM_Type": kinds, "F2SDRAM_Width": widths}, "f2h_sdram0_data",
                        COPY.format(to=0x3FFFF000, there=0))
            self.shows(SHOWN)

    def test_copy_by_the_bridge_to_sdram_and_on_chip_ram(self):
        for width in 1, 2, 3:
            for to, there in ((0x20010000, 0), (0x20010000, 0x80000000), (0xFFFF1000, 0)):
                self.copier({"F2S_Width": str(width)}, "f2h_axi_slave",
                            COPY.format(to=to, there=there))
                self.shows(SHOWN)

    def test_masters_have_the_bandwidth_that_is_asked_for(self):
        self.copier({"F2SDRAM_Type": "Avalon-MM Bidirectional", "F2SDRAM_Width": "64"},
                    "f2h_sdram0_data", COPY.format(to=0x20010000, there=0))
        dark, lit = 'expect-leds: "0000000000"', f'expect-leds: "{SHOWN:010b}"'
        self.played("delay: 300us", lit)  # 720 bytes
        self.played("delay: 600us", dark, "delay: 400us", lit, options=("--ddr3-rate", "1"))

    def test_a_word_past_the_end_ends_the_run(self):
        self.copier({"F2SDRAM_Type": "Avalon-MM Bidirectional", "F2SDRAM_Width": "64"},
                    "f2h_sdram0_data", COPY.format(to=0x3FFFFEA0, there=0))
        done = self.played("delay: 10ms", code=1)
        self.assertIn("(fpga2sdram, command port 0): writes 0x40000000, but the processor's DDR3 "
                      "ends at 0x3FFFFFFF", done.stdout + done.stderr)

    def test_a_port_in_reset_does_not_answer(self):
        for port, processor, register, name in (
                ("f2h_sdram0_data", {"F2SDRAM_Type": "AXI-3", "F2SDRAM_Width": "64"},
                 "R32(0xFFC25080) = 0", "fpgaportrst, 0xFFC25080"),
                ("f2h_axi_slave", {"F2S_Width": "2"}, "R32(0xFFD0501C) = 4",
                 "brgmodrst, 0xFFD0501C")):
            self.copier(processor, port, f"{register}; R32(0xFF200000) = 5;"
                        + COPY.format(to=0x20010000, there=0))
            done = self.played("delay: 30ms", 'expect-leds: "0000000101"')
            self.assertIn(f"nothing is answered for 20 ms, since the program holds it in reset "
                          f"({name})", done.stderr)

    def test_an_address_of_nobody_is_reported(self):
        self.copier({"F2S_Width": "2"}, "f2h_axi_slave",
                    "R32(0xFF200000) = 1; R32(0xFF201000) = 0x20000000; "
                    "R32(0xFF201004) = 0xFF200000; R32(0xFF201008) = 1;")
        self.assertIn("(fpga2hps): writes 0xFF200000, where nobody is; the answer is DECERR",
                      self.shows(1).stderr)

    def test_a_port_at_the_top(self):
        modules, wires = pio("leds", 0)
        for kind, width in (("Avalon-MM Bidirectional", 64), ("Avalon-MM Bidirectional", 128)):
            hps = ("hps_0", "altera_hps", {**BASE[1][2], "F2SDRAM_Type": kind,
                                           "F2SDRAM_Width": str(width)})
            self.write(
                sys_qsys=qsys([BASE[0], hps, *modules],
                              [*CLOCKS, *wires, ("clock", "clk_0.clk", "hps_0.f2h_sdram0_clock")],
                              [("leds", "leds.external_connection"),
                               ("ram", "hps_0.f2h_sdram0_data")]),
                top_v=f"""module top(input CLOCK_50, output [9:0] LEDR);
wire waits; reg begun = 0, write = 0; reg [7:0] left = 9; reg [{width - 1}:0] data = 7;
sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), .leds_export(LEDR), .ram_address(32'h1000000),
    .ram_burstcount(8'd9), .ram_waitrequest(waits), .ram_read(1'b0), .ram_readdata(),
    .ram_readdatavalid(), .ram_writedata(data), .ram_byteenable(~0), .ram_write(write));
always @(posedge CLOCK_50) begin
    begun <= 1;
    if (!begun) write <= 1;
    if (write && !waits) begin left <= left - 1; data <= data + 1; write <= left != 1; end
end
endmodule
""",
                top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                        "set_global_assignment -name VERILOG_FILE top.v\n"
                        "set_global_assignment -name QSYS_FILE sys.qsys\n")
            address = 0x1000000 * width // 8
            self.program(f"while (R32({address + width:#x}) != 15) {{}}\n"
                         f"R32(0xFF200000) = R32({address + width:#x}) << 4 | R32({address:#x});")
            self.shows(0xF7)


    def test_an_axi_port_at_the_top(self):
        """Four words of its bus, each of a number more."""
        modules, wires = pio("leds", 0)
        for port, width, processor in (
                ("f2h_axi_slave", 64, {"F2S_Width": "2"}),
                ("f2h_sdram0_data", 32, {"F2SDRAM_Type": "AXI-3", "F2SDRAM_Width": "32"}),
                ("f2h_sdram1_data", 256, {"F2SDRAM_Type": "AXI-3,AXI-3",
                                          "F2SDRAM_Width": "64,256"})):
            clocks = [("clock", "clk_0.clk", f"hps_0.{name}_clock") for name in
                      (["f2h_axi"] if "F2S_Width" in processor else ["f2h_sdram0", "f2h_sdram1"]
                       [:len(processor["F2SDRAM_Width"].split(","))])]
            self.write(
                sys_qsys=qsys([BASE[0], ("hps_0", "altera_hps", {**BASE[1][2], **processor}),
                               *modules], [*CLOCKS, *wires, *clocks],
                              [("leds", "leds.external_connection"), ("ram", f"hps_0.{port}")]),
                top_v=f"""module top(input CLOCK_50, output [9:0] LEDR);
wire awready, wready; reg begun = 0, asks = 0, writes = 0; reg [1:0] place = 0;
sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), .leds_export(LEDR),
    .ram_awid(8'd5), .ram_awaddr(32'h1000000), .ram_awlen(4'd3), .ram_awburst(2'd1),
    .ram_awsize(3'd{(width // 8).bit_length() - 1}), .ram_awvalid(asks), .ram_awready(awready),
    .ram_wdata({{{width - 2}'d3, place}}), .ram_wstrb({{{width // 8}{{1'b1}}}}),
    .ram_wlast(place == 3), .ram_wvalid(writes), .ram_wready(wready),
    .ram_bready(1'b1), .ram_arvalid(1'b0), .ram_rready(1'b1));
always @(posedge CLOCK_50) begin
    begun <= 1;
    if (!begun) begin asks <= 1; writes <= 1; end
    if (awready) asks <= 0;
    if (writes && wready) begin place <= place + 1; writes <= place != 3; end
end
endmodule
""",
                top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                        "set_global_assignment -name VERILOG_FILE top.v\n"
                        "set_global_assignment -name QSYS_FILE sys.qsys\n")
            last = 0x1000000 + 3 * width // 8
            self.program(f"while (R32({last:#x}) != 15) {{}}\n"
                         f"R32(0xFF200000) = R32({last:#x}) << 4 | R32(0x1000000);")
            self.shows(0xFC)


class Primitives(SystemCase):
    def test_a_design_without_a_program_is_not_answered(self):
        self.write(top_v="""module top(input CLOCK_50, output [9:0] LEDR);
reg wants = 1;
wire ready;
assign LEDR = {9'd0, ready};
cyclonev_hps_interface_fpga2hps bridge(.clk(CLOCK_50), .port_size_config(2'd1),
    .arvalid(wants), .arready(ready), .rready(1'b1));
endmodule
""")
        done = self.plays("delay: 1ms", 'expect-leds: "0000000000"', arguments=("--top", "top"))
        self.assertIn("bridge (fpga2hps): nothing is answered, since no program (--elf) has set up "
                      "the processor's memory", done.stderr)

    # Answers with address bits 9 to 2; what is in `connected` is.
    BRIDGE = """module top(input CLOCK_50, output [9:0] LEDR);
wire awvalid, wvalid, arvalid; wire [11:0] awid, arid; wire [20:0] araddr; wire [31:0] wdata;
reg bvalid = 0, rvalid = 0; reg [31:0] rdata; reg [9:0] leds = 0;
assign LEDR = leds;
cyclonev_hps_interface_hps2fpga_light_weight bridge(.awvalid(awvalid), .wvalid(wvalid),
    .awid(awid), .bid(awid), .arid(arid), .rid(arid), .rlast(1'b1),
    .wdata(wdata), .arvalid(arvalid), .araddr(araddr), .rdata(rdata), {connected});
always @(posedge CLOCK_50) begin
    bvalid <= awvalid && wvalid; rvalid <= arvalid; rdata <= araddr[9:2];
    if (wvalid) leds <= wdata;
end
endmodule
"""

    def bridge(self, body, without="", code=0):
        connected = [f".{port}({wire})" for port, wire in (
            ("clk", "CLOCK_50"), ("awready", "awvalid"), ("wready", "wvalid"),
            ("bvalid", "bvalid"), ("arready", "arvalid"), ("rvalid", "rvalid")) if port != without]
        self.write(top_v=self.BRIDGE.replace("{connected}", ", ".join(connected)),
                   top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                           "set_global_assignment -name TOP_LEVEL_ENTITY top\n"
                           "set_global_assignment -name VERILOG_FILE top.v\n")
        self.program(body)
        return self.played("delay: 30ms", 'expect-leds: "0001010101"', code=code)

    def test_a_top_with_one_primitive_has_the_processor(self):
        self.bridge("R32(0xFF200000) = R32(0xFF200154);")

    def test_half_of_a_bridge_is_named(self):
        for signal in "clk", "awready", "wready", "bvalid":
            self.assertIn(f"the design did not answer: its bridge waits for {signal}",
                          self.bridge("R32(0xFF200000) = 0x155;", signal, code=1).stderr)
        for signal in "arready", "rvalid":
            self.assertIn(f"the design did not answer: its bridge waits for {signal}",
                          self.bridge("R32(0xFF200000) = R32(0xFF200154);", signal, code=1).stderr)

    def test_a_bridge_that_the_design_has_not(self):
        self.assertIn("the design has nothing at the full bridge",
                      self.bridge("R32(0xC0000000) = 1;", code=1).stderr)


run()
