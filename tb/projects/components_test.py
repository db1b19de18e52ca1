"""components_test.py DE1SIM FOLDER [CASE...] - what describes a component"""
import shutil

from case import run
from systems import LW, SystemCase, clocked

ADDER = """module {name} #(parameter WIDTH = 8)(
    input clk, input reset_n, input [1:0] avs_s0_address, input avs_s0_write, avs_s0_read,
    input [WIDTH-1:0] avs_s0_writedata, output reg [WIDTH-1:0] avs_s0_readdata,
    output [9:0] lamps, input [9:0] switches);
reg [WIDTH-1:0] a, b;
assign lamps = a[WIDTH-1 -: 10] ^ switches;
always @(posedge clk)
    if (!reset_n) a <= 0;
    else begin
        if (avs_s0_write && avs_s0_address == 0) a <= avs_s0_writedata;
        if (avs_s0_write && avs_s0_address == 1) b <= avs_s0_writedata;
        avs_s0_readdata <= avs_s0_address == 2 ? a + b : 0;
    end
endmodule
"""
VHDL_ADDER = """library ieee; use ieee.std_logic_1164.all; use ieee.numeric_std.all;
entity adder is generic (WIDTH : natural := 8); port (
    clk, reset_n, avs_s0_write, avs_s0_read : in std_logic;
    avs_s0_address : in std_logic_vector(1 downto 0);
    avs_s0_writedata : in std_logic_vector(WIDTH - 1 downto 0);
    avs_s0_readdata : out std_logic_vector(WIDTH - 1 downto 0);
    lamps : out std_logic_vector(9 downto 0); switches : in std_logic_vector(9 downto 0)); end;
architecture a of adder is signal a, b : unsigned(WIDTH - 1 downto 0) := (others => '0'); begin
lamps <= std_logic_vector(a(WIDTH - 1 downto WIDTH - 10)) xor switches;
process (clk) begin if rising_edge(clk) then
    if avs_s0_write = '1' and avs_s0_address = "00" then a <= unsigned(avs_s0_writedata); end if;
    if avs_s0_write = '1' and avs_s0_address = "01" then b <= unsigned(avs_s0_writedata); end if;
    avs_s0_readdata <= std_logic_vector(a + b);
end if; end process; end;
"""
HW_TCL = """set_module_property NAME adder
add_fileset QUARTUS_SYNTH QUARTUS_SYNTH "" ""
set_fileset_property QUARTUS_SYNTH TOP_LEVEL adder
add_fileset_file adder.v VERILOG PATH adder.v TOP_LEVEL_FILE
add_parameter WIDTH INTEGER 8
set_parameter_property WIDTH HDL_PARAMETER true
add_interface clock clock end
add_interface_port clock clk clk Input 1
add_interface reset reset end
set_interface_property reset associatedClock clock
add_interface_port reset reset_n reset_n Input 1
add_interface s0 avalon end
set_interface_property s0 associatedClock clock
set_interface_property s0 associatedReset reset
add_interface_port s0 avs_s0_address address Input 2
add_interface_port s0 avs_s0_write write Input 1
add_interface_port s0 avs_s0_read read Input 1
add_interface_port s0 avs_s0_writedata writedata Input WIDTH
add_interface_port s0 avs_s0_readdata readdata Output WIDTH
add_interface pins conduit end
add_interface_port pins lamps lamps Output 10
add_interface_port pins switches switches Input 10
"""


def sopcinfo(kind="adder", width=32):
    def interface(name, type_, properties, ports):
        text = f'<interface name="{name}" kind="{type_}_x" version="21.1">'
        for p, value in properties.items():
            text += f'<parameter name="{p}"><type>int</type><value>{value}</value></parameter>'
        text += f"<type>{type_}</type><isStart>false</isStart>"
        for port, role, direction, bits in ports:
            text += (f"<port><name>{port}</name><direction>{direction}</direction>"
                     f"<width>{bits}</width><role>{role}</role></port>")
        return text + "</interface>\n"
    own = {"associatedClock": "clock", "associatedReset": "reset"}
    return ('<?xml version="1.0"?>\n<EnsembleReport name="sys" kind="sys">\n'
            f'<module name="adder_0" kind="{kind}" version="1.0" path="adder_0">\n'
            + interface("clock", "clock", {}, [("clk", "clk", "Input", 1)])
            + interface("reset", "reset", {"associatedClock": "clock"},
                        [("reset_n", "reset_n", "Input", 1)])
            + interface("s0", "avalon", {**own, "readWaitTime": 1, "addressUnits": "WORDS"},
                        [("avs_s0_address", "address", "Input", 2),
                         ("avs_s0_write", "write", "Input", 1),
                         ("avs_s0_read", "read", "Input", 1),
                         ("avs_s0_writedata", "writedata", "Input", width),
                         ("avs_s0_readdata", "readdata", "Output", width)])
            + interface("pins", "conduit", {}, [("lamps", "lamps", "Output", 10),
                                                ("switches", "switches", "Input", 10)])
            + "</module>\n</EnsembleReport>\n")


class Components(SystemCase):
    def adder(self, kind="adder", verilog="adder", clocks=clocked("adder_0", "clock"), **files):
        self.system([("adder_0", kind, {"WIDTH": "32"})],
                    [*clocks, ("avalon", LW, "adder_0.s0", 0x40)], [("pins", "adder_0.pins")],
                    ", .pins_lamps(LEDR), .pins_switches(SW)", **files)
        (self.folder / f"{verilog}.v").write_text(ADDER.format(name=verilog))
        self.program("R32(0xFF200040) = 0x41234567; R32(0xFF200044) = 0x3FFFFFFF;\n"
                     "R32(0xFF200040) = R32(0xFF200048);")

    def list_verilog(self, name):
        with (self.folder / "top.qsf").open("a") as settings:
            settings.write(f"set_global_assignment -name VERILOG_FILE {name}.v\n")

    def test_a_hw_tcl_goes_by_the_name_that_it_gives_itself(self):
        self.adder()
        (self.folder / "some_hw.tcl").write_text(HW_TCL)
        self.shows(0x81234566 >> 22)

    def test_a_hw_tcl_beside_a_file_of_the_project_elsewhere(self):
        self.adder()
        cores = self.folder.parent / "cores"
        cores.mkdir(exist_ok=True)
        (self.folder / "adder.v").replace(cores / "adder.v")
        (cores / "some_hw.tcl").write_text(HW_TCL)
        self.list_verilog("../cores/adder")
        self.shows(0x81234566 >> 22)

    def test_a_hw_tcl_in_a_folder_ip_beside_the_projects(self):
        self.adder()
        shared = self.folder.parent / "ip"
        self.addCleanup(shutil.rmtree, shared)
        (shared / "adder").mkdir(parents=True)
        (self.folder / "adder.v").replace(shared / "adder" / "adder.v")
        (shared / "adder" / "some_hw.tcl").write_text(HW_TCL)
        self.shows(0x81234566 >> 22)

    def test_a_hw_tcl_looks_for_its_verilog(self):
        self.adder()
        path = self.folder / "adder_hw.tcl"
        path.write_text(HW_TCL.replace(
            "add_fileset_file adder.v VERILOG PATH adder.v",
            "foreach f {no/adder.v adder.v} {\n    set f [file normalize $f]\n"
            "    if {[file exists $f]} { break }\n}\n"
            "if {![file exists $f]} { error \"not in [pwd]\" }\n"
            "add_fileset_file adder.v VERILOG PATH $f"))
        self.assertIn("[pwd]", path.read_text())
        self.shows(0x81234566 >> 22)

    def test_the_name_of_the_module_that_the_component_editor_leaves(self):
        self.adder(verilog="other")
        (self.folder / "adder_hw.tcl").write_text(
            HW_TCL.replace("TOP_LEVEL adder", "TOP_LEVEL new_component")
            .replace("adder.v VERILOG PATH adder.v", "other.v VERILOG PATH other.v"))
        (self.folder / "other.v").write_text(
            "module helper(input a, output b); assign b = a; endmodule\n"
            + ADDER.format(name="other"))
        self.assertIn("adder_hw.tcl names the module new_component, which its files do not have; "
                      "module other of other.v is taken\n", self.shows(0x81234566 >> 22).stderr)

    def test_a_clock_with_a_reset_among_its_ports_is_two_interfaces(self):
        self.adder(clocks=clocked("adder_0", "clock_reset", "clock_reset_reset"))
        old = (HW_TCL.replace("add_interface clock clock", "add_interface clock_reset clock")
               .replace("add_interface_port clock ", "add_interface_port clock_reset ")
               .replace("add_interface_port reset ", "add_interface_port clock_reset ")
               .replace("s0 associatedClock clock", "s0 ASSOCIATED_CLOCK clock_reset"))
        (self.folder / "adder_hw.tcl").write_text("".join(
            line for line in old.splitlines(True) if "interface reset" not in line
            and "_property reset" not in line and "associatedReset" not in line))
        self.shows(0x81234566 >> 22)

    def test_a_pin_that_the_processor_lends_is_high_and_no_request_is_answered(self):
        self.system(exports=[("loan", "hps_0.h2f_loan_io"), ("dma", "hps_0.f2h_dma_req1")],
                    top=", .loan_in(lent), .loan_out(67'd1), .loan_oe(67'd1), .dma_dma_req(1'b1), "
                        ".dma_dma_single(1'b0), .dma_dma_ack(ack)")
        for file, old, new in [
                ("sys.qsys", '  <parameter name="S2F_Width"',
                 '  <parameter name="LOANIO_Enable" value="No,Yes,No" />\n'
                 '  <parameter name="DMA_Enable">No,Yes,No,No,No,No,No,No</parameter>\n'
                 '  <parameter name="S2F_Width"'),
                ("top.v", "sys system", "wire [66:0] lent; wire ack;\n"
                                        "assign LEDR = {8'h55, ack, lent[1]};\nsys system")]:
            path = self.folder / file
            path.write_text(path.read_text().replace(old, new))
        self.program("")
        self.shows(0x155)

    def test_vhdl_with_generics(self):
        self.adder()
        (self.folder / "adder.v").unlink()
        (self.folder / "adder.vhd").write_text(VHDL_ADDER)
        (self.folder / "adder_hw.tcl").write_text(
            HW_TCL.replace("adder.v VERILOG PATH adder.v", "adder.vhd VHDL PATH adder.vhd"))
        self.shows(0x81234566 >> 22)

    def test_a_sopcinfo_with_the_verilog_of_the_kinds_name(self):
        self.adder()
        (self.folder / "sys.sopcinfo").write_text(sopcinfo())
        self.assertIn("sys.qsys: adder_0 is of the kind adder, which has no _hw.tcl: sys.sopcinfo "
                      "describes it, module adder\n", self.shows(0x81234566 >> 22).stderr)

    def test_a_sopcinfo_with_verilog_of_the_same_ports(self):
        self.adder("bus_adder", "other")
        (self.folder / "sys.sopcinfo").write_text(sopcinfo("bus_adder"))
        self.refused("adder_0 is of the kind bus_adder, which is not known here, and the project "
                     "has no bus_adder_hw.tcl, bus_adder.qsys or module bus_adder",
                     "check", "top.qsf")
        self.list_verilog("other")
        self.shows(0x81234566 >> 22)
        (self.folder / "twin.v").write_text(ADDER.format(name="twin"))
        self.list_verilog("twin")
        self.refused("sys.sopcinfo: adder_0 is of the kind bus_adder, which has no _hw.tcl; the "
                     "modules other and twin have its ports", "check", "top.qsf")

    def test_wrong_sopcinfo(self):
        self.adder()
        for text, message in (("<module", "sys.sopcinfo: this is broken XML: "),
                              (sopcinfo().replace("<name>clk</name>", "<name>a b</name>"),
                               "sys.sopcinfo: the name `a b`, expected letters, digits and _"),
                              (sopcinfo(width=9999), "sys.sopcinfo: port avs_s0_writedata is 9999 "
                                                     "bits wide, expected 1 to 4096")):
            (self.folder / "sys.sopcinfo").write_text(text)
            self.refused(message, "check", "top.qsf")

    def test_verilog_alone(self):
        self.adder()
        self.assertIn("sys.qsys: adder_0 is of the kind adder, which has no _hw.tcl: adder.v "
                      "describes it, module adder\n", self.shows(0x81234566 >> 22).stderr)

    def test_verilog_without_the_names_of_a_slaves_data(self):
        self.adder()
        verilog = ADDER.format(name="adder").replace("writedata", "x").replace("readdata", "y")
        (self.folder / "adder.v").write_text(verilog)
        self.refused("no port has the name of data of s0", "check", "top.qsf")


run()
