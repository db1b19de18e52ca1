"""hps_case.py - a design at the processor's primitives, or a system with the processor alone"""
from systems import BASE, CLOCKS, SystemCase, qsys

TOP = """module top(input CLOCK_50, input [9:0] SW, input [3:0] KEY, output [9:0] LEDR,
    inout [35:0] GPIO_0, output HPS_LED);
wire [31:0] gpo;
cyclonev_hps_interface_mpu_general_purpose gp(.gp_in({gpi}), .gp_out(gpo));
{body}
endmodule
"""
# What fails first has its number on the lamps.
CHECK = """#define GPO R32(0xFF706010)
#define GPI R32(0xFF706014)
#define CHECK(n, c) if (!(c)) { GPO = n; for (;;) {} }
"""


class PeripheralCase(SystemCase):
    def top(self, body, gpi="32'd0"):
        self.write(top_v=TOP.format(body=body, gpi=gpi),
                   top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                           "set_global_assignment -name TOP_LEVEL_ENTITY top\n"
                           "set_global_assignment -name VERILOG_FILE top.v\n")

    def system(self, exports, body, ports, **processor):
        """A system with the processor alone."""
        self.write(sys_qsys=qsys([BASE[0], ("hps_0", "altera_hps", {
            **BASE[1][2], "GP_Enable": "true", **processor})], CLOCKS,
            [("gp", "hps_0.h2f_gp"), *exports]),
            top_v="module top(input CLOCK_50, input [9:0] SW, output [9:0] LEDR, output HPS_LED);\n"
                  "wire [31:0] gpo; assign LEDR = gpo;\n" + body +
                  "\nsys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1),\n"
                  "    .gp_gp_in({22'd0, SW}), .gp_gp_out(gpo)" + ports + ");\nendmodule\n",
            top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                    "set_global_assignment -name VERILOG_FILE top.v\n"
                    "set_global_assignment -name QSYS_FILE sys.qsys\n")
