"""small_components_test.py DE1SIM FOLDER [CASE...] - counters, mutexes, mailboxes, bus bridges"""
from case import run
from systems import LW, SystemCase, clocked

# In the programs: what fails first has its number on the LEDs.
CHECK = """#define LEDS R32(0xFF200000)
#define CHECK(n, c) if (!(c)) { LEDS = n; for (;;) {} }
#define W(n) R32(0xFF200100 + 4 * (n))
#define IRQ(n) (R32(0xFFFED208) >> (8 + (n)) & 1)
"""


class Small(SystemCase):
    def checks(self, modules, wires, body, exports=(), top=""):
        self.with_leds(modules, wires, exports)
        if top:
            self.write(top_v=top)
        self.program(body + "\nLEDS = 0x3FF;", CHECK)
        self.shows(0x3FF)


class PerformanceCounter(Small):
    def counter(self, sections, body):
        self.checks([("perf", "altera_avalon_performance_counter",
                      {"numberOfSections": str(sections)})],
                    [*clocked("perf"), ("avalon", LW, "perf.control_slave", 0x100)],
                    """#define LOOK(n) ((uint64_t)W(4 * (n) + 1) << 32 | W(4 * (n)))
#define TIMES(n) W(4 * (n) + 2)
#define BEGIN(n) (W(4 * (n) + 1) = 0)
#define END(n) (W(4 * (n)) = 0)
""" + body)

    def test_sections_count_clocks_and_beginnings_within_the_whole(self):
        self.counter(3, """BEGIN(1); CHECK(1, LOOK(1) == 0 && TIMES(1) == 0); END(1);
BEGIN(0);
for (unsigned n = 0; n < 5; ++n) { BEGIN(1); BEGIN(3); END(3); END(1); }
BEGIN(2);
END(0);
uint64_t all = LOOK(0), one = LOOK(1), two = LOOK(2), three = LOOK(3);
CHECK(2, TIMES(0) == 1 && TIMES(1) == 5 && TIMES(2) == 1 && TIMES(3) == 5);
CHECK(3, two > 0 && three >= 5 && one > three && all > one + two);
CHECK(4, LOOK(0) == all && LOOK(2) == two);
BEGIN(0); END(0); CHECK(5, TIMES(0) == 2 && LOOK(0) > all && LOOK(2) > two && LOOK(1) == one);
W(0) = 1; CHECK(6, !LOOK(0) && !LOOK(2) && !TIMES(0) && !TIMES(1));
BEGIN(0); END(0); CHECK(7, LOOK(2) == 0 && TIMES(0) == 1 && LOOK(0) > 0);
CHECK(8, W(3) == 0 && W(7) == 0);""")

    def test_seven_sections_and_one(self):
        self.counter(7, """BEGIN(0);
for (unsigned n = 1; n <= 7; ++n) for (unsigned k = 0; k < n; ++k) { BEGIN(n); END(n); }
END(0); for (unsigned n = 1; n <= 7; ++n) CHECK(n, TIMES(n) == n);""")
        self.setUp()
        self.counter(1, "BEGIN(0); BEGIN(1); END(1); END(0); CHECK(1, TIMES(1) == 1);")

    def test_eight_sections_are_refused(self):
        self.refuses("perf does not take its parameters: numberOfSections is 8, expected 1 to 7",
                     [("perf", "altera_avalon_performance_counter", {"numberOfSections": "8"})])


class Mutex(Small):
    def test_one_has_it_until_it_gives_it_back(self):
        self.checks([("mutex", "altera_avalon_mutex", {}),
                     ("taken", "altera_avalon_mutex", {"initialValue": "5", "initialOwner": "7"})],
                    [*clocked("mutex"), *clocked("taken"), ("avalon", LW, "mutex.s1", 0x100),
                     ("avalon", LW, "taken.s1", 0x110)],
                    """CHECK(1, W(0) == 0 && W(1) == 1);
W(1) = 0; CHECK(2, W(1) == 1); W(1) = 1; CHECK(3, W(1) == 0);
W(0) = 0x20001; CHECK(4, W(0) == 0x20001);
W(0) = 0x30001; CHECK(5, W(0) == 0x20001);
W(0) = 0x30000; CHECK(6, W(0) == 0x20001);
W(0) = 0x20009; CHECK(7, W(0) == 0x20009);
W(0) = 0x20000; CHECK(8, W(0) == 0x20000);
W(0) = 0x30001; CHECK(9, W(0) == 0x30001);
CHECK(10, W(4) == 0x70005 && W(5) == 1);
W(4) = 1; CHECK(11, W(4) == 0x70005); W(4) = 0x70000; W(4) = 1; CHECK(12, W(4) == 1);""")

    def test_an_owner_that_there_is_not(self):
        self.refuses("mutex does not take its parameters: initialOwner is 65536, expected 0 to",
                     [("mutex", "altera_avalon_mutex", {"initialOwner": "65536"})])

    def test_an_old_mailbox_has_two(self):
        self.checks([("box", "altera_avalon_mailbox", {})],
                    [*clocked("box"), ("avalon", LW, "box.s1", 0x100)],
                    """CHECK(1, W(0) == 0 && W(1) == 1 && W(2) == 0 && W(3) == 1);
W(0) = 0x10001; W(2) = 0x20002; W(3) = 1;
CHECK(2, W(0) == 0x10001 && W(1) == 1 && W(2) == 0x20002 && W(3) == 0);
W(2) = 0x10001; W(0) = 0x10000; CHECK(3, W(0) == 0x10000 && W(2) == 0x20002);""")


class Mailbox(Small):
    def test_a_message_goes_to_the_receiver(self):
        self.checks([("box", "altera_avalon_mailbox_simple", {})],
                    [*clocked("box", "clk", "rst_n"),
                     ("avalon", LW, "box.avmm_msg_sender", 0x100),
                     ("avalon", LW, "box.avmm_msg_receiver", 0x110),
                     ("interrupt", "hps_0.f2h_irq0", "box.interrupt_space", 1),
                     ("interrupt", "hps_0.f2h_irq0", "box.interrupt_msg", 2)],
                    """CHECK(1, W(2) == 0 && W(6) == 0 && !IRQ(1) && !IRQ(2));
W(1) = 0x3A11B045; CHECK(2, W(1) == 0x3A11B045);
W(5) = 7; W(4) = 7; CHECK(3, W(5) == 0x3A11B045 && W(2) == 0 && W(4) == 0);
W(3) = 3; CHECK(4, W(3) == 2 && IRQ(1) && !IRQ(2));
W(7) = 3; CHECK(5, W(7) == 1 && !IRQ(2));
W(1) = 0x12; CHECK(6, W(6) == 0); W(0) = 0x34;
CHECK(7, W(2) == 3 && W(6) == 3 && !IRQ(1) && IRQ(2));
W(0) = 0x56; CHECK(8, W(0) == 0x34 && W(2) == 3);
CHECK(9, W(5) == 0x12 && W(6) == 3 && W(4) == 0x34);
CHECK(10, W(2) == 0 && W(6) == 0 && IRQ(1) && !IRQ(2));
W(3) = 0; CHECK(11, !IRQ(1)); W(7) = 0; W(0) = 1; CHECK(12, !IRQ(2) && W(4) == 1);""")


class SourcesAndProbes(Small):
    def test_a_source_keeps_its_first_value(self):
        self.checks([("issp", "altera_in_system_sources_probes",
                      {"source_width": "10", "probe_width": "4", "source_initial_value": "2A5",
                       "create_source_clock": "true"}),
                     ("in", "altera_avalon_pio", {"width": "10", "direction": "Input"})],
                    [("clock", "clk_0.clk", "issp.source_clk"), *clocked("in"),
                     ("avalon", LW, "in.s1", 0x100)],
                    "CHECK(1, W(0) == 0x2A5);",
                    [("sources", "issp.sources"), ("probes", "issp.probes"),
                     ("in", "in.external_connection")],
                    """module top(input CLOCK_50, input [9:0] SW, output [9:0] LEDR);
wire [9:0] source;
sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), .leds_export(LEDR), .in_export(source),
           .sources_source(source), .probes_probe(SW[3:0]));
endmodule
""")

    def test_513_bits_are_refused(self):
        self.refuses("issp does not take its parameters: probe_width is 513, expected 0 to 512",
                     [("issp", "altera_in_system_sources_probes", {"probe_width": "513"})])


# A memory that acknowledges after as many clocks as its address says, but for 60, never; word 0 of
# `odd` counts changes of what is asked while bus_enable.
MEMORY = """
module memory #(parameter WIDTH = 32, ADDRESS = 8) (
    input clk, input [ADDRESS-1:0] address, input bus_enable, input [WIDTH/8-1:0] byte_enable,
    input rw, input [WIDTH-1:0] write_data, output acknowledge, output [WIDTH-1:0] read_data,
    output irq);
    reg [WIDTH-1:0] words [0:255]; reg [7:0] clocks = 0, odd = 0; reg was_on = 0;
    reg [ADDRESS+WIDTH+WIDTH/8:0] was;
    wire [7:0] at = address / (WIDTH / 8);
    wire [ADDRESS+WIDTH+WIDTH/8:0] now = {address, byte_enable, rw, write_data};
    assign acknowledge = bus_enable && clocks == at[3:0] && at != 60, irq = words[1] == 1;
    assign read_data = !acknowledge ? 32'hDEADBEEF : at == 61 ? odd : words[at];
    integer n;
    always @(posedge clk) begin
        was <= now; was_on <= bus_enable;
        if (was_on && bus_enable && was != now) odd <= odd + 1;
        if (bus_enable && address % (WIDTH / 8) != 0) odd <= odd + 1;
        clocks <= bus_enable && !acknowledge ? clocks + 1 : 0;
        for (n = 0; n < WIDTH / 8; n = n + 1)
            if (acknowledge && !rw && byte_enable[n]) words[at][8*n +: 8] <= write_data[8*n +: 8];
    end
endmodule
"""
SIGNALS = ("address", "bus_enable", "byte_enable", "rw", "write_data", "acknowledge", "read_data",
           "irq")


class BusBridges(Small):
    def outside(self, width, bits, body, **parameters):
        ports = ", ".join(f".{s}({s})" for s in SIGNALS)
        out = ", ".join(f".bus_{s}({s})" for s in SIGNALS)
        self.checks([("bus", "altera_up_avalon_to_external_bus_bridge",
                      {"data_size": str(width), **parameters})],
                    [*clocked("bus"), ("avalon", LW, "bus.avalon_slave", 0x10000),
                     ("interrupt", "hps_0.f2h_irq0", "bus.interrupt", 1)],
                    body, [("bus", "bus.external_interface")], MEMORY + f"""
module top(input CLOCK_50, output [9:0] LEDR);
wire [{bits - 1}:0] address; wire [{width // 8 - 1}:0] byte_enable;
wire [{width - 1}:0] write_data, read_data; wire bus_enable, rw, acknowledge, irq;
sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), .leds_export(LEDR), {out});
memory #({width}, {bits}) m (.clk(CLOCK_50), {ports});
endmodule
""")

    def test_an_outside_bus_of_words(self):
        self.outside(32, 8, """#define M(n) R32(0xFF210000 + 4 * (n))
for (unsigned n = 0; n < 60; ++n) M(n) = 0x1234567 * n;
for (unsigned n = 0; n < 60; ++n) CHECK(n + 1, M(n) == 0x1234567 * n);
R8(0xFF210009) = 0xAA; CHECK(61, M(2) == (0x1234567 * 2 & 0xFFFF00FF | 0xAA00));
M(1) = 0; CHECK(62, !IRQ(1)); M(1) = 1; CHECK(63, IRQ(1)); CHECK(64, M(61) == 0);
M(60) = 5; M(60); CHECK(65, M(61) == 0 && M(59) == 0x1234567 * 59);""",
                     addr_size="256", addr_size_multiplier="bytes")

    def test_an_outside_bus_of_half_words_and_of_bytes(self):
        self.outside(16, 10, """#define M(n) R16(0xFF210000 + 2 * (n))
for (unsigned n = 0; n < 60; ++n) M(n) = 0x4567 * n;
for (unsigned n = 0; n < 60; ++n) CHECK(n + 1, M(n) == (uint16_t)(0x4567 * n));
R32(0xFF210008) = 0x87654321; CHECK(61, M(4) == 0x4321 && M(5) == 0x8765);
CHECK(62, M(61) == 0);""",
                     addr_size="1")
        self.setUp()
        self.outside(8, 9, """#define M(n) R8(0xFF210000 + (n))
for (unsigned n = 0; n < 60; ++n) M(n) = 67 * n;
for (unsigned n = 0; n < 60; ++n) CHECK(n + 1, M(n) == (uint8_t)(67 * n));
CHECK(62, M(61) == 0);""",
                     addr_size="512", addr_size_multiplier="bytes")

    def test_a_master_outside(self):
        """It fills the memory from 0x20 on, reads that back, and writes the sum to the LEDs."""
        self.with_leds([("bus", "altera_up_external_bus_to_avalon_bridge",
                         {"data_size": "32", "addr_size": "64", "addr_size_multiplier": "Kbytes"}),
                        ("ram", "altera_avalon_onchip_memory2",
                         {"memorySize": "4096", "dataWidth": "32"})],
                       [*clocked("bus"), *clocked("ram", "clk1", "reset1"),
                        ("avalon", "bus.avalon_master", "ram.s1", 0x1000),
                        ("avalon", "bus.avalon_master", "leds.s1", 0x2000),
                        ("avalon", LW, "ram.s1", 0x1000)], [("bus", "bus.external_interface")])
        self.write(top_v="""module top(input CLOCK_50, output [9:0] LEDR);
reg [15:0] address = 16'h1020; reg [3:0] byte_enable = 15; reg read = 0, write = 1;
reg [31:0] write_data = 3, sum = 0; wire [31:0] read_data; wire acknowledge;
sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), .leds_export(LEDR), .bus_address(address),
           .bus_byte_enable(byte_enable), .bus_read(read), .bus_write(write),
           .bus_write_data(write_data), .bus_acknowledge(acknowledge), .bus_read_data(read_data));
always @(posedge CLOCK_50) if (acknowledge) begin
    address <= address + 4;
    if (write) write_data <= write_data + 5;
    if (read) sum <= sum + read_data;
    byte_enable <= write && address == 16'h1048 ? 4'b0001 : 15;
    if (write && address == 16'h1048) write_data <= 32'hFFFFFF00 | write_data + 5;
    if (address == 16'h104C) begin address <= 16'h1020; {read, write} <= {write, read}; end
    if (read && address == 16'h104C) begin address <= 16'h2000; write_data <= sum + read_data; end
    if (address == 16'h2000) begin write <= 0; read <= 0; end
end
endmodule
""")
        self.program("")
        self.shows(sum(3 + 5 * n for n in range(12)))

    def test_wrong_parameters(self):
        for kind in ("altera_up_avalon_to_external_bus_bridge",
                     "altera_up_external_bus_to_avalon_bridge"):
            for parameter, value, message in (
                    ("data_size", "24", "data_size is 24, expected 8, 16, 32, 64 or 128"),
                    ("addr_size_multiplier", "Gbytes",
                     'addr_size_multiplier is "Gbytes", expected bytes, Kbytes or Mbytes'),
                    ("addr_size", "0", "addr_size is 0 bytes, expected two words to 1 Gbyte")):
                self.refuses("bus does not take its parameters: " + message,
                             [("bus", kind, {parameter: value})])


if __name__ == "__main__":
    run()
