"""burst_slaves_test.py DE1SIM FOLDER [CASE...] - which bursts a slave with burstcount gets"""
from case import run
from systems import HW_TCL, SystemCase, qsys

# Writes 16 words from word 3 on, then reads as many from there, and compares.
MASTER = """module master(input clk, reset, output [1:0] result, output [31:0] address,
    output [4:0] burstcount, output read, write, output [31:0] writedata,
    input [31:0] readdata, input readdatavalid, waitrequest);
reg [4:0] put, got;
reg asked, bad;
assign address = 12, burstcount = 16, write = put < 16 && !reset;
assign read = put == 16 && !asked, writedata = 32'h01010101 * put + 32'h00112233;
assign result = {bad, got == 16};
always @(posedge clk) begin
    if (write && !waitrequest) put <= put + 1;
    if (read && !waitrequest) asked <= 1;
    if (readdatavalid) begin
        got <= got + 1;
        if (readdata != 32'h01010101 * got + 32'h00112233) bad <= 1;
    end
    if (reset) {put, got, asked, bad} <= 0;
end
endmodule
"""
# Prints each burst: R or W, its first word, its length.
SLAVE = """module slave(input clk, reset, input [7:0] address, input [{most}:0] burstcount,
    input read, write, input [{width}-1:0] writedata, input [{width}/8-1:0] byteenable,
    input beginbursttransfer,
    output reg [{width}-1:0] readdata, output reg readdatavalid, output waitrequest);
reg [{width}-1:0] words [0:255];
reg [7:0] to, from;
reg [15:0] left, reads;
reg begun;
integer i;
wire [7:0] at = left == 0 ? address : to;
assign waitrequest = reads != 0;
always @(posedge clk) begin
    readdatavalid <= 0;
    begun <= (begun || beginbursttransfer) && waitrequest;
    if ((read || write) && !waitrequest && left == 0) begin
        $display("%s %0d %0d%s", write ? "W" : "R", address, burstcount,
                 beginbursttransfer || begun ? "" : " without its begin");
        if (read) {{from, reads}} <= {{address, 16'd0 + burstcount}};
    end
    if (write && !waitrequest) begin
        for (i = 0; i < {width} / 8; i = i + 1)
            if (byteenable[i]) words[at][8*i +: 8] <= writedata[8*i +: 8];
        to <= {next};
        left <= (left == 0 ? burstcount : left) - 1;
    end
    if (reads != 0) begin
        readdatavalid <= 1;
        readdata <= words[from];
        from <= {next_read};
        reads <= reads - 1;
    end
    if (reset) {{left, reads, begun}} <= 0;
end
endmodule
"""
TOP = """module top(input CLOCK_50, output [9:0] LEDR);
reg slow = 0;
always @(posedge CLOCK_50) slow <= !slow;
assign LEDR[9:2] = 0;
sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), .second_clk(slow), .reset_1_reset_n(1'b1),
           .result_export(LEDR[1:0]));
endmodule
"""
OWN = "set_interface_property bus associatedClock clock\n" \
      "set_interface_property bus associatedReset reset\n"


class BurstSlaves(SystemCase):
    def bursts(self, width=32, most=4, clock="clk_0", **properties):
        """Of a slave whose burstcount has most + 1 bits: the writes and the reads."""
        up = "{} + 1"
        if "linewrapBursts" in properties:
            up = f"({{}} & ~({1 << most} - 1)) | ({{}} + 1 & ({1 << most} - 1))"
        ports = {"master": [("address", "Output", 32), ("burstcount", "Output", 5),
                            ("read", "Output", 1), ("write", "Output", 1),
                            ("writedata", "Output", 32), ("readdata", "Input", 32),
                            ("readdatavalid", "Input", 1), ("waitrequest", "Input", 1)],
                 "slave": [("address", "Input", 8), ("burstcount", "Input", most + 1),
                           ("read", "Input", 1), ("write", "Input", 1),
                           ("writedata", "Input", width), ("readdata", "Output", width),
                           ("byteenable", "Input", width // 8),
                           ("beginbursttransfer", "Input", 1),
                           ("readdatavalid", "Output", 1), ("waitrequest", "Output", 1)]}
        properties["maximumPendingReadTransactions"] = "1"
        tcl = {}
        for name, end in (("master", "start"), ("slave", "end")):
            text = HW_TCL.format(name=name) + f"add_interface bus avalon {end}\n" + OWN
            if name == "master":
                text += "add_interface result conduit end\n" \
                        "add_interface_port result result export Output 2\n"
            else:
                text += "".join(f"set_interface_property bus {key} {value}\n"
                                for key, value in properties.items())
            tcl[name] = text + "".join(f"add_interface_port bus {role} {role} {way} {bits}\n"
                                       for role, way, bits in ports[name])
        modules = [("clk_0", "clock_source", {}), ("clk_1", "clock_source", {}),
                   ("m", "master", {}), ("s", "slave", {})]
        wires = [(kind, f"{source}.clk{end}", f"{name}.{kind}")
                 for name, source in (("m", "clk_0"), ("s", clock))
                 for kind, end in (("clock", ""), ("reset", "_reset"))]
        self.write(
            master_v=MASTER, master_hw_tcl=tcl["master"], slave_hw_tcl=tcl["slave"],
            slave_v=SLAVE.format(width=width, most=most, next=up.replace("{}", "at"),
                                 next_read=up.replace("{}", "from")),
            sys_qsys=qsys(modules, [*wires, ("avalon", "m.bus", "s.bus", 0)],
                          [("second", "clk_1.clk_in"), ("reset_1", "clk_1.clk_in_reset"),
                           ("result", "m.result")]),
            top_v=TOP, top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                               "set_global_assignment -name VERILOG_FILE top.v\n"
                               "set_global_assignment -name QSYS_FILE sys.qsys\n",
            s_yaml="name: s\nversion: 1\nproject: top.qsf\nsteps:\n"
                   "  - expect-leds: {equals: 1, timeout: 1ms}\n")
        done = self.de1sim("run", "s.yaml")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        lines = (done.stdout + done.stderr).splitlines()
        return [line.rstrip() for line in lines if line[:2] in ("W ", "R ")]

    def both(self, *bursts):
        return [f"{way} {burst}" for way in "WR" for burst in bursts]

    def test_a_burst_that_fits_is_passed_whole(self):
        self.assertEqual(self.bursts(), self.both("3 16"))
        self.assertEqual(self.bursts(clock="clk_1"), self.both("3 16"))

    def test_a_burst_is_cut_at_the_slaves_maximum(self):
        self.assertEqual(self.bursts(most=2), self.both("3 4", "7 4", "11 4", "15 4"))

    def test_a_slave_of_another_width_has_bursts_of_its_words(self):
        self.assertEqual(self.bursts(width=16, most=5), self.both("6 32"))
        self.assertEqual(self.bursts(width=16, most=4), self.both("6 16", "22 16"))
        self.assertEqual(self.bursts(width=64), self.both("1 9"))

    def test_bursts_begin_at_a_multiple_of_their_length(self):
        self.assertEqual(self.bursts(most=3, burstOnBurstBoundariesOnly="true"),
                         self.both("3 1", "4 4", "8 8", "16 2", "18 1"))

    def test_a_burst_ends_where_the_slave_would_wrap(self):
        self.assertEqual(self.bursts(most=3, linewrapBursts="true"),
                         self.both("3 5", "8 8", "16 3"))


if __name__ == "__main__":
    run()
