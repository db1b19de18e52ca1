"""committed_test.py DE1SIM FOLDER [CASE...] - the generated Verilog of a system, without a .qsys"""
from case import run
from systems import SystemCase, qsys

# A memory behind AXI3 that takes address and data in the order that `DATA_FIRST` says, each after
# two clocks, and shows wrong strobes in `bad`.  Bytes 16 and 17 are lamps, byte 18 an interrupt.
MEMORY = """module axi_memory #(parameter BYTES = 4, DATA_FIRST = 0) (
    input clk, input [11:0] awid, input [4:0] awaddr, input [2:0] awsize, input awvalid,
    output reg awready,
    input [8*BYTES-1:0] wdata, input [BYTES-1:0] wstrb, input wvalid, wlast, output reg wready,
    output reg [11:0] bid, output reg bvalid, input bready, input [11:0] arid, input [4:0] araddr,
    input [3:0] arlen, input [2:0] arsize, input arvalid, output reg arready,
    output reg [11:0] rid, output reg [8*BYTES-1:0] rdata, output reg rlast, rvalid, input rready,
    output [9:0] lamps, output irq, output reg bad);
reg [7:0] bytes [0:31];
reg [4:0] address, at, left = 0;
reg [2:0] size, step;
reg last = 1;
reg [8*BYTES-1:0] data;
reg [BYTES-1:0] strobes;
reg has_address = 0, has_data = 0;
reg [1:0] wait_q = 0;
integer n;
initial begin
    for (n = 0; n < 32; n = n + 1) bytes[n] = 0;
    awready = 0; wready = 0; bvalid = 0; arready = 0; rvalid = 0; bad = 0;
end
assign lamps = {bytes[17][1:0], bytes[16]};
assign irq = bytes[18][0];
always @(posedge clk) begin
    wait_q <= awvalid || wvalid || arvalid ? wait_q + 1'b1 : 2'd0;
    awready <= awvalid && !awready && !has_address && &wait_q && (!DATA_FIRST || has_data);
    wready <= wvalid && !wready && !has_data && &wait_q && (DATA_FIRST || has_address);
    arready <= arvalid && !arready && &wait_q;
    if (awvalid && awready) begin
        {bid, address, size} <= {awid, awaddr, awsize}; has_address <= 1;
    end
    if (wvalid && wready) begin {data, strobes, last} <= {wdata, wstrb, wlast}; has_data <= 1; end
    if (has_address && awvalid || has_data && last && wvalid) bad <= 1;
    bvalid <= 0;
    if (has_address && has_data) begin
        for (n = 0; n < BYTES; n = n + 1)
            if (strobes[n]) begin
                if ((n >> size) != ((address % BYTES) >> size)) bad <= 1;
                bytes[address / BYTES * BYTES + n] <= data[8*n +: 8];
            end
        address <= (address >> size << size) + (5'd1 << size);
        has_address <= !last; has_data <= 0; bvalid <= last && bready;
    end
    if (arvalid && arready) {rid, at, step, left} <= {arid, araddr, arsize, {1'b0, arlen} + 5'd1};
    rvalid <= left != 0 && rready;
    rlast <= left == 1;
    if (left != 0) begin left <= left - 1; at <= (at >> step << step) + (5'd1 << step); end
    for (n = 0; n < BYTES; n = n + 1) rdata[8*n +: 8] <= bytes[at / BYTES * BYTES + n];
end
endmodule
"""
AXI = ("awid awaddr awlen awsize awburst awlock awcache awprot awvalid awready wid wdata wstrb "
       "wlast wvalid wready bid bresp bvalid bready arid araddr arlen arsize arburst arlock "
       "arcache arprot arvalid arready rid rdata rresp rlast rvalid rready").split()
TO_PROCESSOR = {"awready", "wready", "bid", "bvalid", "arready", "rid", "rlast", "rvalid", "rdata"}


def bridge(primitive, name, data, more=""):
    """The primitive with wires NAME_awaddr ..., and the memory behind it."""
    widths = {"awaddr": 30 if more else 21, "araddr": 30 if more else 21, "wdata": data,
              "rdata": data, "wstrb": data // 8, "awsize": 3, "arsize": 3, "arlen": 4,
              "awid": 12, "bid": 12, "arid": 12, "rid": 12}
    used = [p for p in AXI if p in widths or p in TO_PROCESSOR
            or p in ("awvalid", "wvalid", "wlast", "bready", "arvalid", "rready")]
    text = "".join(f"wire [{widths.get(p, 1) - 1}:0] {name}_{p};\n" for p in used)
    text += f"cyclonev_hps_interface_{primitive} {primitive}(\n .clk({{\n    clk[0:0] // 0:0\n}})\n"
    text += more + "".join(
        f",.{p}({{\n    {name}_{p}[{widths.get(p, 1) - 1}:0] // 0:0\n  }})\n" for p in used)
    text += (f");\naxi_memory #(.BYTES({data // 8}), .DATA_FIRST({int(bool(more))})) "
             f"{name}_memory (\n")
    text += "    .clk(clk), " + ", ".join(
        f".{p}({name}_{p}{'[4:0]' if 'addr' in p else ''})" for p in used)
    return text + f", .lamps({name}_lamps), .irq({name}_irq), .bad({name}_bad));\n"


def interfaces(data=64):
    size = {32: "00", 64: "01", 128: "10"}[data]
    return ("\nmodule sys_hps_0_fpga_interfaces(input wire [0:0] clk,output wire [0:0] h2f_rst_n,\n"
            "    output wire [9:0] lamps);\n"
            "wire [9:0] lw_lamps, full_lamps; wire lw_irq, full_irq, lw_bad, full_bad;\n"
            "assign lamps = {lw_bad | full_bad, lw_lamps[8:0] ^ full_lamps[8:0]};\n"
            "cyclonev_hps_interface_clocks_resets clocks_resets(.f2h_pending_rst_ack(1'b1),\n"
            "    .f2h_cold_rst_req_n(1'b1), .h2f_rst_n(h2f_rst_n));\n"
            "cyclonev_hps_interface_dbg_apb debug_apb(.DBG_APB_DISABLE(1'b0), .P_CLK_EN(1'b0));\n"
            "cyclonev_hps_interface_tpiu_trace tpiu(.traceclk_ctl(1'b1));\n"
            "cyclonev_hps_interface_fpga2hps fpga2hps(.port_size_config(2'b11));\n"
            "cyclonev_hps_interface_interrupts interrupts(.irq({31'd0, full_irq, 31'd0,lw_irq}));\n"
            + bridge("hps2fpga_light_weight", "lw", 32)
            + bridge("hps2fpga", "full", data,
                     f",.port_size_config({{\n    2'b{size} // 1:0\n  }})\n") + "endmodule\n")


BORDER = """
module sys_hps_0_hps_io_border(
  output wire [15 - 1 : 0 ] mem_a
);

this is no Verilog of which anything can be made
endmodule
"""
SYSTEM = """module sys(input wire clk_clk, output wire [9:0] leds, output wire [14:0] mem_a);
wire reset_n;
sys_hps_0_fpga_interfaces fpga_interfaces(.clk(clk_clk), .h2f_rst_n(reset_n), .lamps(leds));
sys_hps_0_hps_io_border border(.mem_a(mem_a));
endmodule
"""
QIP = "".join(f'set_global_assignment -library "sys" -name {kind} '
              f'[file join $::quartus(qip_path) "{file}"]\n' for kind, file in
              (("VERILOG_FILE", "sys.v"), ("VERILOG_FILE", "submodules/axi_memory.v"),
               ("SYSTEMVERILOG_FILE", "submodules/sys_hps_0_fpga_interfaces.sv"),
               ("SYSTEMVERILOG_FILE", "submodules/sys_hps_0_hps_io_border.sv"),
               ("SDC_FILE", "submodules/sys.sdc")))
SOPCINFO = """<?xml version="1.0"?>
<EnsembleReport name="sys" kind="sys"><module name="hps_0" kind="altera_hps" version="18.1">
<interface name="h2f_lw_axi_master" kind="altera_axi_master">
<memoryBlock><isBridge>false</isBridge><moduleName>memory</moduleName><slaveName>s1</slaveName>
<name>memory.s1</name><baseAddress>0</baseAddress><span>32</span></memoryBlock></interface>
<interface name="f2h_axi_slave" kind="altera_axi_slave"></interface></module></EnsembleReport>
"""


class Committed(SystemCase):
    def committed(self, data=64, **files):
        self.write(top_v="module top(input CLOCK_50, output [9:0] LEDR);\n"
                         "sys u(.clk_clk(CLOCK_50), .leds(LEDR)); endmodule\n",
                   top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                           "set_global_assignment -name VERILOG_FILE top.v\n"
                           "set_global_assignment -name QIP_FILE sys/synthesis/sys.qip\n",
                   sys__synthesis__sys_qip=QIP, sys__synthesis__sys_v=SYSTEM,
                   **files)
        submodules = self.folder / "sys/synthesis/submodules"
        submodules.mkdir(exist_ok=True)
        (submodules / "axi_memory.v").write_text(MEMORY)
        (submodules / "sys_hps_0_fpga_interfaces.sv").write_text(interfaces(data))
        (submodules / "sys_hps_0_hps_io_border.sv").write_text(BORDER)
        (submodules / "sys.sdc").write_text("if {$::TimeQuestInfo(nameofexecutable)} {}\n")

    ACCESSES = """#define A 0x{0:X}
R32(A) = 0x11223344; R8(A + 1) = 0xAA; R16(A + 2) = 0xBBCC; R64(A + 8) = 0x0102030405060708;
R8(A + 15) = R8(A + 2); R16(A + 4) = R16(A + 14); R16(A + 6) = R32(A + 12);
R64(A + 24) = R64(A); R16(A + 16) = R16(A + 24) ^ R16(A + 26) ^ R16(A + 28) ^ R16(A + 30)
                                    ^ R32(A + 8);"""
    SHOWN = (0xAA44 ^ 0xBBCC ^ 0xCC02 ^ 0x0304 ^ 0x0708) & 0x1FF

    def test_accesses_of_all_sizes_by_both_bridges(self):
        for data in 32, 64, 128:
            self.committed(data)
            for base in 0xFF200000, 0xC0000000:
                self.program(self.ACCESSES.format(base))
                self.shows(self.SHOWN)

    def test_interrupts(self):
        self.committed()
        self.program("""R32(0xFFFED100 + 72 / 32 * 4) = 0x100;
R32(0xFFFED100 + 104 / 32 * 4) = 0x100;
uint32_t none = R32(0xFFFED200 + 104 / 32 * 4) | R32(0xFFFED200 + 72 / 32 * 4);
R8(0xC0000012) = 1;
uint32_t full = R32(0xFFFED200 + 104 / 32 * 4);
R8(0xFF200012) = 1;
R16(0xFF200010) = none | full >> 7 | R32(0xFFFED200 + 72 / 32 * 4) >> 6;""")
        self.shows(6)

    def test_the_note_and_the_map(self):
        self.committed()
        done = self.de1sim("check", "top.qsf")
        self.assertIn("sys/synthesis/submodules/sys_hps_0_fpga_interfaces.sv: the Verilog that "
                      "Platform Designer has made of this system is taken as it is\n", done.stdout)
        self.assertNotIn("addresses of", done.stdout)
        (self.folder / "sys.sopcinfo").write_text(SOPCINFO)
        self.assertEqual("addresses of hps_0.h2f_lw_axi_master:\n"
                         "  0xFF200000 - 0xFF20001F  memory.s1\n",
                         self.de1sim("check", "--map", "top.qsf").stdout)
        self.refused("of its Platform Designer system that is taken which was made of the .qsys, "
                     "which does not tell the kinds of its components", "check", "--header",
                     "top.qsf")

    def test_it_is_taken_for_a_qsys_with_an_unknown_component(self):
        self.committed(sys_qsys=qsys([("clk_0", "clock_source", {}), ("hps_0", "altera_hps", {}),
                                      ("part", "made_elsewhere", {})], []))
        self.program(self.ACCESSES.format(0xFF200000))
        self.assertIn("sys.qsys: part is of the kind made_elsewhere, which is not known here, and "
                      "the project has no made_elsewhere_hw.tcl, made_elsewhere.qsys or module "
                      "made_elsewhere; what Platform Designer has made of it is taken, "
                      "sys/synthesis/sys.qip\n", self.de1sim("check", "top.qsf").stdout)
        self.shows(self.SHOWN)

    def test_an_access_of_nobody(self):
        self.committed()
        (self.folder / "sys.sopcinfo").write_text(SOPCINFO)
        self.program("R32(0xFF200020) = 5; R32(0xC0000024) = 1; R16(0xFF200010) = 5;")
        told = self.shows(5).stderr
        self.assertIn("write to 0xFF200020: the interconnect sees memory there, as at 0xFF200000: "
                      "addresses repeat each 0x20 bytes", told)
        self.assertIn("write to 0xC0000024: nobody is there, at", told)


run()
