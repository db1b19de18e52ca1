"""tristate_test.py DE1SIM FOLDER [CASE...] - a memory on a bus outside of the system"""
from case import run
from systems import LW, SystemCase, clocked, pio

# An SRAM of 512 words of 16 bits.  Its data are there READ clocks after the address; a write counts
# if its strobe lasts for WRITE clocks, with SETUP clocks before and HOLD after it.
SRAM = """module sram #(parameter READ = 1, WRITE = 1, SETUP = 0, HOLD = 0) (input clk,
    input [9:0] address, input cs_n, input oe_n, input we_n, input [1:0] be_n,
    inout [15:0] data, output reg bad);
reg [15:0] words [0:511];
reg [15:0] written;
reg [9:0] was; reg [1:0] bytes;
reg [7:0] stable = 0, strobe = 0, before = 0, after = 0; // clocks
reg wrote = 0, lasted = 0;
initial bad = 0;
wire drives = !cs_n && !oe_n && we_n;
wire [7:0] age = address == was ? stable : 0;
assign data = drives ? (age >= READ - 1 ? words[address[9:1]] : 16'hDEAD) : 16'bz;
always @(posedge clk) begin
    was <= address;
    stable <= drives ? age + 1 : 0;
    if (cs_n) before <= 0; else if (we_n && !wrote) before <= address == was ? before + 1 : 1;
    if (!cs_n && !we_n) begin
        strobe <= strobe + 1; written <= data; bytes <= be_n; wrote <= 1; after <= 0;
        if (!wrote && before < SETUP) bad <= 1;
    end else if (wrote) begin
        after <= after + 1;
        if (after < HOLD && (cs_n || address != was || data != written)) bad <= 1;
        if (after == 0) begin
            if (strobe != WRITE) bad <= 1;
            if (!bytes[0]) words[was[9:1]][7:0] <= written[7:0];
            if (!bytes[1]) words[was[9:1]][15:8] <= written[15:8];
        end
        if (after >= HOLD) begin wrote <= 0; strobe <= 0; end
    end
    if (!oe_n && !we_n) bad <= 1;
end
endmodule
"""
TOP = """module top(input CLOCK_50, output [9:0] LEDR);
wire [9:0] address; wire cs_n, oe_n, we_n, bad; wire [1:0] be_n; wire [15:0] data;
sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), .leds_export(LEDR[8:0]),
    .pins_tcm_address_out(address), .pins_tcm_chipselect_n_out(cs_n),
    .pins_tcm_{read}_n_out(oe_n), .pins_tcm_write_n_out(we_n),
    .pins_tcm_byteenable_n_out(be_n), .pins_tcm_data_out(data));
sram #({timing}) memory(CLOCK_50, address, cs_n, oe_n, we_n, be_n, data, bad);
assign LEDR[9] = bad;
endmodule
"""
PROGRAM = """enum { SRAM = 0xFF201000 };
uint32_t wrong = 0;
for (uint32_t n = 0; n < 64; ++n) R32(SRAM + 4 * n) = 0x01020304 * n + 0x11;
R8(SRAM + 4 * 5 + 1) = 0xAB;
R8(SRAM + 4 * 6 + 2) = 0xCD;
R16(SRAM + 4 * 7 + 2) = 0x1234;
for (uint32_t n = 0; n < 64; ++n) {
    uint32_t expected = 0x01020304 * n + 0x11;
    if (n == 5) expected = (expected & ~0xFF00) | 0xAB00;
    if (n == 6) expected = (expected & ~0xFF0000) | 0xCD0000;
    if (n == 7) expected = (expected & 0xFFFF) | 0x12340000;
    wrong += R32(SRAM + 4 * n) != expected;
}
for (uint32_t n = 0; n < 64; ++n) {
    R16(SRAM + 2 * n) = 7 * n;
    wrong += R16(SRAM + 2 * n) != 7 * n;
}
R32(0xFF200000) = 0x80 + wrong;"""


class Tristate(SystemCase):
    def memory(self, timing, read="read", **parameters):
        """The program on it, in clocks of the SRAM."""
        pins = [("address", 10), ("chipselect_n", 1), (f"{read}_n", 1), ("write_n", 1),
                ("byteenable_n", 2)]
        info = "".join(f'&lt;pin role=&quot;{role}&quot; width=&quot;{width}&quot; '
                       f'type=&quot;Output&quot; output_name=&quot;tcm_{role}_out&quot; '
                       'output_enable_name=&quot;&quot; input_name=&quot;&quot; /&gt;'
                       for role, width in pins)
        info += ("&lt;pin role=&quot;data&quot; width=&quot;16&quot; "
                 "type=&quot;Bidirectional&quot; output_name=&quot;tcm_data_out&quot; "
                 "output_enable_name=&quot;tcm_data_outen&quot; "
                 "input_name=&quot;tcm_data_in&quot; /&gt;")
        leds, wires = pio("leds", 0, width="9")
        use = {"USE_OUTPUTENABLE" if read == "outputenable" else "USE_READ": "1"}
        if read == "outputenable":
            use.update(USE_READ="0", ACTIVE_LOW_OUTPUTENABLE="1")
        self.system(
            [*leds, ("sram", "altera_generic_tristate_controller", {
                "TCM_ADDRESS_W": "10", "TCM_DATA_W": "16", "TCM_BYTEENABLE_W": "2",
                "USE_BYTEENABLE": "1", "USE_CHIPSELECT": "1", "ACTIVE_LOW_READ": "1",
                "ACTIVE_LOW_WRITE": "1", "ACTIVE_LOW_CHIPSELECT": "1",
                "ACTIVE_LOW_BYTEENABLE": "1", "TCM_READLATENCY": "2",
                "TCM_TURNAROUND_TIME": "1", **use, **parameters}),
             ("pins", "altera_tristate_conduit_bridge",
              {"INTERFACE_INFO": f"&lt;info&gt;{info}&lt;/info&gt;"})],
            [*wires, *clocked("sram"), *clocked("pins"), ("avalon", LW, "sram.uas", 0x1000),
             ("tristate_conduit", "sram.tcm", "pins.tcs")],
            [("leds", "leds.external_connection"), ("pins", "pins.out")])
        self.write(top_v=SRAM + TOP.format(timing=timing, read=read))

    def test_a_program_writes_and_reads_it(self):
        self.memory(".READ(1), .WRITE(1), .SETUP(1)", TCM_READ_WAIT="0", TCM_WRITE_WAIT="0",
                    TCM_SETUP_WAIT="1")
        self.program(PROGRAM)
        self.shows(0x80)

    def test_its_times_are_kept(self):
        self.memory(".READ(4), .WRITE(3), .SETUP(2), .HOLD(1)", TCM_READ_WAIT="3",
                    TCM_WRITE_WAIT="2", TCM_SETUP_WAIT="2", TCM_DATA_HOLD="1")
        self.program(PROGRAM)
        self.shows(0x80)

    def test_times_may_be_in_nanoseconds(self):
        self.memory(".READ(4), .WRITE(3), .SETUP(1), .HOLD(1)", read="outputenable",
                    TCM_TIMING_UNITS="0", CLOCK_RATE="50000000", TCM_READ_WAIT="55",
                    TCM_WRITE_WAIT="40", TCM_SETUP_WAIT="5", TCM_DATA_HOLD="20",
                    TCM_TURNAROUND_TIME="40")
        self.program(PROGRAM)
        self.shows(0x80)

    def test_what_is_not_simulated_is_named(self):
        self.memory("", USE_IRQ="1")
        self.refused("sram does not take its parameters: USE_IRQ is 1, expected 0: not simulated",
                     "check", "top.qsf")


if __name__ == "__main__":
    run()
