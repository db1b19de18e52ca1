"""other_slaves_test.py DE1SIM FOLDER [CASE...] - slaves of APB and of AXI"""
from case import run
from systems import FULL, HW_TCL, LW, OWN_CLOCK, SystemCase, clocked

APB_TCL = HW_TCL + "add_parameter BYTES INTEGER 4\nadd_interface s apb end\n" + OWN_CLOCK + """\
add_interface_port s paddr paddr Input 6
add_interface_port s psel psel Input 1
add_interface_port s penable penable Input 1
add_interface_port s pwrite pwrite Input 1
add_interface_port s pwdata pwdata Input 8*bytes
add_interface_port s prdata prdata Output 32
{pready}
"""
APB_V = """module {name}(input clk, input reset, input [5:0] paddr, input psel, input penable,
                      input pwrite, input [31:0] pwdata, output [31:0] prdata {pready});
    reg [31:0] words [0:14];
    reg [38:0] was_q;
    reg [7:0]  wrong_q = 0;
    reg [1:0]  waits_q = 0;
    reg        selected_q = 0, ended_q = 0;
    wire       ends = psel && penable && {done};
    {ready}
    assign prdata = !ends ? 32'hdeadbeef : paddr == 60 ? wrong_q : words[paddr[5:2]];
    always @(posedge clk) begin
        selected_q <= psel && !ends;
        was_q      <= {{paddr, pwrite, pwrite ? pwdata : 32'd0}};
        waits_q    <= ends || !penable ? 2'd0 : waits_q + 2'd1;
        if (ends && pwrite) words[paddr[5:2]] <= pwdata;
        if (penable != (psel && selected_q)
            || selected_q && (!psel || was_q != {{paddr, pwrite, pwrite ? pwdata : 32'd0}}))
            wrong_q <= wrong_q + 8'd1;
    end
endmodule
"""

# Role, width and direction of an AXI4 slave's ports, as HDL generators describe one.
AXI_PORTS = [(role, width, "Input") for role, width in (
    ("awid", 12), ("awaddr", 6), ("awlen", 8), ("awsize", 3), ("awburst", 2), ("awvalid", 1),
    ("wdata", 32), ("wstrb", 4), ("wlast", 1), ("wvalid", 1), ("bready", 1), ("arid", 12),
    ("araddr", 6), ("arlen", 8), ("arsize", 3), ("arburst", 2), ("arvalid", 1), ("rready", 1))] + [
    (role, width, "Output") for role, width in (
        ("awready", 1), ("wready", 1), ("bid", 12), ("bresp", 2), ("bvalid", 1), ("arready", 1),
        ("rid", 12), ("rdata", 32), ("rresp", 2), ("rlast", 1), ("rvalid", 1))]
AXI_V = """module {name}(input clk, input reset,
    input [11:0] awid, input [5:0] awaddr, input [7:0] awlen, input [2:0] awsize,
    input [1:0] awburst, input awvalid, output awready,
    input [31:0] wdata, input [3:0] wstrb, input wlast, input wvalid, output wready,
    output [11:0] bid, output [1:0] bresp, output bvalid, input bready,
    input [11:0] arid, input [5:0] araddr, input [7:0] arlen, input [2:0] arsize,
    input [1:0] arburst, input arvalid, output arready,
    output [11:0] rid, output [31:0] rdata, output [1:0] rresp, output rlast, output rvalid,
    input rready);
    reg [31:0] words [0:14];
    reg [15:0] chance_q = 16'hace1;
    reg [7:0]  wrong_q = 0;
    reg        aw_q = 0, w_q = 0, ar_q = 0, waits_q = 0;
    reg [5:0]  at_q;
    reg [31:0] data_q;
    reg [3:0]  strobe_q;
    reg [81:0] was_q;
    wire [81:0] now = {{awvalid, wvalid, arvalid, awvalid ? awaddr : 6'd0, wvalid ? wdata : 32'd0,
                       wvalid ? wstrb : 4'd0, arvalid ? araddr : 6'd0}};
    assign {{awready, wready, arready}} = {{chance_q[0] && !aw_q, chance_q[3] && !w_q,
                                          chance_q[5] && !ar_q}};
    assign bvalid = aw_q && w_q && chance_q[7];
    assign rvalid = ar_q && waits_q;
    assign rdata  = !rvalid ? 32'hdeadbeef : at_q == 60 ? wrong_q : words[at_q[5:2]];
    reg [11:0] id_q;
    assign {{bid, bresp, rid, rresp, rlast}} = {{id_q, 2'd0, id_q, 2'd0, 1'b1}};
    integer n;
    always @(posedge clk) begin
        chance_q <= {{chance_q[14:0], chance_q[15] ^ chance_q[13] ^ chance_q[12] ^ chance_q[10]}};
        if (awvalid && awready) {{aw_q, at_q, id_q}} <= {{1'b1, awaddr, awid}};
        if (wvalid && wready) {{w_q, data_q, strobe_q}} <= {{1'b1, wdata, wstrb}};
        if (arvalid && arready) {{ar_q, at_q, id_q}} <= {{1'b1, araddr, arid}};
        waits_q <= ar_q && (waits_q || chance_q[9]) && !(rvalid && rready);
        if (rvalid && rready) ar_q <= 0;
        if (bvalid && bready) begin
            {{aw_q, w_q}} <= 0;
            for (n = 0; n < 4; n = n + 1)
                if (strobe_q[n]) words[at_q[5:2]][8*n +: 8] <= data_q[8*n +: 8];
        end
        was_q <= now;
        // What was offered and not taken is offered still, and one word at a time.
        if (was_q[81] && !aw_q && (!awvalid || awaddr != was_q[77:72])
            || was_q[80] && !w_q && (!wvalid || now[75:40] != was_q[75:40])
            || was_q[79] && !ar_q && (!arvalid || araddr != was_q[5:0])
            || awvalid && (awlen != 0 || awsize != 2) || wvalid && !wlast
            || arvalid && (arlen != 0 || arsize != 2))
            wrong_q <= wrong_q + 8'd1;
    end
endmodule
"""


class OtherSlaves(SystemCase):
    # Words, halves and bytes; the last word counts what the protocol does not allow.
    PROGRAM = """uint32_t bad = 0;
for (uint32_t base = 0xFF200100; base; base = base == 0xFF200100 ? 0xC0000200 : 0) {
    for (uint32_t n = 0; n < 15; ++n) R32(base + 4 * n) = 0x01020304 * (n + 1);
    for (uint32_t n = 0; n < 15; ++n) bad |= R32(base + 4 * n) != 0x01020304 * (n + 1);
    NARROW
    bad |= R32(base + 60) << 1;
}
R32(0xFF200000) = bad ? bad : 0x3FF;"""
    NARROW = """R8(base + 5) = 0xAA; R16(base + 10) = 0xBBCC;
    bad |= R32(base + 4) != 0x0204AA08 || R32(base + 8) != 0xBBCC090C || R8(base + 7) != 2;"""

    def joined(self, slaves):
        """One behind each of the processor's bridges."""
        self.with_leds([(name, kind, {}) for name, kind in slaves],
                       [("avalon", LW, "a.s", 0x100), ("avalon", FULL, "b.s", 0x200)]
                       + clocked("a", "clock") + clocked("b", "clock"))

    def test_an_apb_slave(self):
        """Its last word counts what APB does not allow; each access waits for 0 to 3 clocks.

        The width of its data is a parameter's, whose name is written in small letters.
        """
        for name, waits in (("apb", True), ("prompt", False)):
            self.write(**{f"{name}_hw_tcl": APB_TCL.format(
                name=name, pready="add_interface_port s pready pready Output 1" if waits else ""),
                          f"{name}_v": APB_V.format(
                name=name, pready=", output pready" if waits else "",
                ready="assign pready = waits_q == paddr[3:2];" if waits else "",
                done="pready" if waits else "1'b1")})
        self.joined([("a", "apb"), ("b", "prompt")])
        self.program(self.PROGRAM.replace("NARROW", ""))
        self.shows(0x3FF)

    def axi4(self, verilog):
        ports = "".join(f"add_interface_port s {role} {role} {direction} {width}\n"
                        for role, width, direction in AXI_PORTS)
        text = APB_TCL[:APB_TCL.index("add_interface_port s paddr")].replace("s apb", "s axi4")
        self.write(axi_hw_tcl=text.format(name="axi") + ports, axi_v=verilog)
        self.joined([("a", "axi"), ("b", "axi")])

    def test_an_axi4_slave(self):
        """Its last word counts what AXI does not allow; it is ready, and answers, by chance."""
        self.axi4(AXI_V.format(name="axi"))
        self.program(self.PROGRAM.replace("NARROW", self.NARROW))
        self.shows(0x3FF)

    def test_an_axi4_slave_that_does_not_return_the_id(self):
        self.axi4(AXI_V.format(name="axi").replace("{id_q, 2'd0, id_q, ", "{12'd0, 2'd0, 12'd0, "))
        for access, what in (("R32(0xFF200100) = 1;", "write of 4 bytes at 0xFF200100 (a did not"),
                             ("(void)R32(0xC0000200);", "read of 4 bytes at 0xC0000200 (b did")):
            self.program(access)
            self.assertIn(what, self.played("delay: 30ms", code=1).stderr)


class InstanceModules(SystemCase):
    def test_a_design_may_instance_the_module_of_an_instance(self):
        """As Platform Designer names it: SYSTEM_INSTANCE."""
        self.with_leds([("tones", "altera_avalon_onchip_memory2",
                         {"memorySize": "64", "dataWidth": "32", "initMemContent": "false"})],
                       [*clocked("tones", "clk1", "reset1"), ("avalon", LW, "tones.s1", 0x100)],
                       top=");\nwire [31:0] word;\nsys_tones other(.clk(CLOCK_50), "
                           ".address(4'd3), .clken(1'b1), .reset_req(1'b0), .reset(1'b0), "
                           ".chipselect(1'b1), .write(SW[0]), .writedata(32'd99), "
                           ".byteenable(4'd15), .readdata(word)")
        self.program("R32(0xFF20010C) = 5; R32(0xFF200000) = R32(0xFF20010C);")
        self.shows(5)


if __name__ == "__main__":
    run()
