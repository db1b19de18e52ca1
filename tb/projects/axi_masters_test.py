"""axi_masters_test.py DE1SIM FOLDER [CASE...] - components with masters of AXI3, AXI4, AXI4-Lite"""
from case import run
from systems import BASE, CLOCKS, HW_TCL, LW, SystemCase, clocked, pio, qsys

OUTPUTS = (("awid", 4), ("awaddr", 32), ("awlen", 8), ("awsize", 3), ("awburst", 2), ("awvalid", 1),
           ("wdata", 64), ("wstrb", 8), ("wlast", 1), ("wvalid", 1), ("bready", 1), ("arid", 4),
           ("araddr", 32), ("arlen", 8), ("arsize", 3), ("arburst", 2), ("arvalid", 1),
           ("rready", 1))
INPUTS = (("awready", 1), ("wready", 1), ("bid", 4), ("bresp", 2), ("bvalid", 1), ("arready", 1),
          ("rid", 4), ("rdata", 64), ("rresp", 2), ("rlast", 1), ("rvalid", 1))


def hw_tcl(name, kind, ports):
    """`ports` are (role, bits, direction)."""
    return (HW_TCL.format(name=name) + f"add_interface m {kind} start\n"
            "set_interface_property m associatedClock clock\n"
            "set_interface_property m associatedReset reset\n" +
            "".join(f"add_interface_port m {role} {role} {direction} {bits}\n"
                    for role, bits, direction in ports))


# Waits for 0x600D at 0x2000000, copies sixteen words of 64 bits in reverse, reads a wrapping burst
# of the copy, writes four bytes, and then whether something went wrong.
COPIER = """module copier(input clk, input reset,
    output [3:0] awid, output [31:0] awaddr, output [7:0] awlen, output [2:0] awsize,
    output [1:0] awburst, output awvalid, input awready,
    output [63:0] wdata, output [7:0] wstrb, output wlast, output wvalid, input wready,
    input [3:0] bid, input [1:0] bresp, input bvalid, output bready,
    output [3:0] arid, output [31:0] araddr, output [7:0] arlen, output [2:0] arsize,
    output [1:0] arburst, output arvalid, input arready,
    input [3:0] rid, input [63:0] rdata, input [1:0] rresp, input rlast, input rvalid,
    output rready);
reg [63:0] words [0:15];
reg [2:0] state; reg asked; reg [4:0] n; reg [15:0] chance; reg bad;
wire reads = state == 0 || state == 1 || state == 3;
wire [4:0] last = state == 1 || state == 2 ? 15 : state == 3 || state == 4 ? 3 : 0;
assign arvalid = reads && !asked && chance[0] && !reset;
assign araddr = state == 0 ? 32'h2000000 : state == 1 ? 32'h2000008 : 32'h2001018;
assign {arlen, arsize, arburst, arid} = {3'd0, last, 3'd3, state == 3 ? 2'd2 : 2'd1, 1'b1, state};
assign rready = reads && asked && chance[3];
assign awvalid = !reads && state != 6 && !asked && !reset;
assign awaddr = state == 2 ? 32'h2001000 : state == 4 ? 32'h2002001 : 32'h2003000;
assign {awlen, awsize, awburst, awid} = {3'd0, last, state == 4 ? 3'd0 : 3'd3, 2'd1, 1'b0, state};
assign wvalid = !reads && state != 6 && chance[5] && n <= last && !reset;
assign wdata = state == 2 ? words[15 - n] : state == 4 ? {8{4'hA, n[3:0]}} : {63'd0, bad} + 64'd1;
assign wstrb = state == 4 ? 8'd2 << n : 8'hFF;
assign wlast = n == last;
assign bready = chance[7];
always @(posedge clk) begin
    chance <= {chance[14:0], chance[15] ^ chance[13] ^ chance[12] ^ chance[10]};
    if (arvalid && arready || awvalid && awready) asked <= 1;
    if (wvalid && wready) n <= n + 1;
    if (rvalid && rready) begin
        n <= rlast ? 0 : n + 1;
        if (rlast) asked <= 0;
        if (rlast != (n == last) || rid != {1'b1, state} || rresp != 0) bad <= 1;
        if (state == 1) words[n] <= rdata;
        if (state == 3 && rdata != words[n == 0 ? 12 : 16 - n]) bad <= 1;
        if (rlast && (state != 0 || rdata[31:0] == 32'h600D)) state <= state + 1;
    end
    if (bvalid && bready) begin
        {asked, n} <= 0;
        if (bid != {1'b0, state} || bresp != 0 || n != last + 1) bad <= 1;
        state <= state + 1;
    end
    if (reset) {state, asked, n, chance, bad} <= {3'd0, 1'b0, 5'd0, 16'h1234, 1'b0};
end
endmodule
"""

# Writes 1 to 10 into the memory at 0x1000, adds what it reads there, and shows the sum.
ADDER = """module adder(input clk, input reset,
    output [31:0] awaddr, output [2:0] awprot, output reg awvalid, input awready,
    output [31:0] wdata, output [3:0] wstrb, output reg wvalid, input wready,
    input [1:0] bresp, input bvalid, output bready,
    output [31:0] araddr, output [2:0] arprot, output reg arvalid, input arready,
    input [31:0] rdata, input [1:0] rresp, input rvalid, output rready);
reg [4:0] n; reg [31:0] sum; reg ends;
assign {awprot, arprot, wstrb, bready, rready} = {6'd0, 4'hF, 2'b11};
assign awaddr = ends ? 32'd0 : 32'h1000 + 4 * n;
assign araddr = 32'h1000 + 4 * (n - 10);
assign wdata = ends ? sum : n + 1;
always @(posedge clk) begin
    if (awready) awvalid <= 0;
    if (wready) wvalid <= 0;
    if (arready) arvalid <= 0;
    if (rvalid) sum <= sum + rdata;
    if (bvalid || rvalid) begin
        n <= n + 1;
        awvalid <= n < 9 || n == 19; wvalid <= n < 9 || n == 19; ends <= n == 19;
        arvalid <= n >= 9 && n < 19;
    end
    if (reset) {n, sum, ends, awvalid, wvalid, arvalid} <= {5'd0, 32'd0, 1'b0, 3'b110};
end
endmodule
"""


class AxiMasters(SystemCase):
    def test_bursts_reach_the_processors_memory(self):
        for kind in "axi", "axi4":
            with self.subTest(kind):
                length = 4 if kind == "axi" else 8
                ports = [(role, length if role.endswith("len") else bits, direction)
                         for all_of, direction in ((OUTPUTS, "Output"), (INPUTS, "Input"))
                         for role, bits in all_of]
                self.write(copier_hw_tcl=hw_tcl("copier", kind, ports),
                           copier_v=COPIER.replace("[7:0] awlen", f"[{length - 1}:0] awlen")
                           .replace("[7:0] arlen", f"[{length - 1}:0] arlen")
                           .replace("{3'd0, last,", f"{{{length - 4}'d0, last[3:0],"
                                    if length > 4 else "{last[3:0],"))
                leds, wires = pio("leds", 0)
                processor = ("hps_0", "altera_hps", {**BASE[1][2], "F2S_Width": "2"})
                self.write(
                    sys_qsys=qsys([BASE[0], processor, ("copier", "copier", {}), *leds],
                                  [*CLOCKS, *wires, *clocked("copier", "clock"),
                                   ("clock", "clk_0.clk", "hps_0.f2h_axi_clock"),
                                   ("avalon", "copier.m", "hps_0.f2h_axi_slave", 0)],
                                  [("leds", "leds.external_connection")]),
                    top_v="module top(input CLOCK_50, output [9:0] LEDR);\n"
                          "sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), "
                          ".leds_export(LEDR));\nendmodule\n",
                    top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                            "set_global_assignment -name VERILOG_FILE top.v\n"
                            "set_global_assignment -name QSYS_FILE sys.qsys\n")
                self.program("""
uint32_t n, good = 0;
for (n = 0; n < 32; n++) R32(0x2000008 + 4 * n) = n * 0x01234567;
R32(0x2002000) = R32(0x2002004) = 0x55555555;
R32(0x2000000) = 0x600D;
while (!R32(0x2003000)) {}
for (n = 0; n < 32; n++)
    good += R32(0x2001000 + 4 * n) == (n % 2 + 30 - n / 2 * 2) * 0x01234567;
good += R32(0x2002000) == 0xA2A1A055 && R32(0x2002004) == 0x555555A3;
R32(0xFF200000) = good << 2 | R32(0x2003000);""")
                self.shows(33 << 2 | 1)

    def test_a_master_of_axi4_lite_reaches_avalon_slaves(self):
        roles = [("awaddr", 32), ("awprot", 3), ("awvalid", 1), ("wdata", 32), ("wstrb", 4),
                 ("wvalid", 1), ("bready", 1), ("araddr", 32), ("arprot", 3), ("arvalid", 1),
                 ("rready", 1)]
        answers = [("awready", 1), ("wready", 1), ("bresp", 2), ("bvalid", 1), ("arready", 1),
                   ("rdata", 32), ("rresp", 2), ("rvalid", 1)]
        self.write(adder_v=ADDER,
                   adder_hw_tcl=hw_tcl("adder", "axi4lite",
                                       [*((r, b, "Output") for r, b in roles),
                                        *((r, b, "Input") for r, b in answers)]))
        self.system([("adder", "adder", {}),
                     ("memory", "altera_avalon_onchip_memory2", {"memorySize": "256"}),
                     ("leds", "altera_avalon_pio", {"width": "10", "direction": "Output"})],
                    [*clocked("adder", "clock"), *clocked("memory", "clk1", "reset1"),
                     *clocked("leds"), ("avalon", "adder.m", "leds.s1", 0),
                     ("avalon", "adder.m", "memory.s1", 0x1000),
                     ("avalon", LW, "memory.s1", 0x1000)],
                    [("leds", "leds.external_connection")], ", .leds_export(LEDR)")
        self.program("")
        self.shows(55)


run()
