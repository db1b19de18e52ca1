"""streaming_test.py DE1SIM FOLDER [CASE...] - components of streams, and what is put between them

    program -> tx -> what is tested -> rx -> program

tx and rx are FIFOs between a slave and a stream; their second register is what goes with a word.
"""
import subprocess

from case import run
from systems import GCC, HW_TCL, LW, SystemCase, clocked

FIFO = {"bitsPerSymbol": "8", "symbolsPerBeat": "4", "channelWidth": "0", "errorWidth": "0",
        "fifoDepth": "64", "useReadControl": "false", "useWriteControl": "false"}
PACKETS = {"USE_PACKETS": "1", "BITS_PER_SYMBOL": "8"}
HEAD = """#define LEDS R32(0xFF200000)
enum { SOP = 1, EOP = 2 };
volatile uint32_t* const tx = (uint32_t*)0xFF200100;
volatile uint32_t* const rx = (uint32_t*)0xFF200110;
volatile uint32_t* const rx2 = (uint32_t*)0xFF200118;
volatile uint32_t* const csr = (uint32_t*)0xFF200120;
static void put(uint32_t info, uint32_t data) { tx[1] = info; tx[0] = data; }
static int got(volatile uint32_t* from, uint32_t info, uint32_t data, uint32_t mask) {
    return ((from[0] ^ data) & mask) == 0 && from[1] == info;
}
int main(void) {
    uint32_t all = 0;
    %s
    LEDS = all;
    for (;;) {}
}
"""


def tx(**parameters):
    return ("tx", "altera_avalon_fifo", {**FIFO, "fifoOutputInterfaceOptions": "AVALONST_SOURCE",
                                         **parameters})


def rx(name="rx", **parameters):
    return (name, "altera_avalon_fifo", {**FIFO, "fifoInputInterfaceOptions": "AVALONST_SINK",
                                         **parameters})


def stream(*ends):
    """From each to the next: "tx.out", "fifo.in", "fifo.out" ..."""
    return [("avalon_streaming", ends[n], ends[n + 1]) for n in range(0, len(ends), 2)]


class Streaming(SystemCase):
    WIRES = [*clocked("tx", "clk_in", "reset_in"), *clocked("rx", "clk_in", "reset_in"),
             ("avalon", LW, "tx.in", 0x100), ("avalon", LW, "rx.out", 0x110)]

    def program(self, body):
        super().program("")  # the macros
        text = (self.folder / "program.c").read_text()
        self.write(program_c=text[:text.index("int main")] + HEAD % body)
        subprocess.run([*GCC, "program.c", "-o", "program.elf"], cwd=self.folder, check=True)

    def test_packets_wait_in_a_store_and_forward_fifo(self):
        """Its beats are bytes, those before and after it words: adapters are put between."""
        self.with_leds(
            [tx(errorWidth="1"), rx(),
             ("sc", "altera_avalon_sc_fifo", {**PACKETS, "ERROR_WIDTH": "1", "USE_FILL_LEVEL": "1",
                                              "USE_STORE_FORWARD": "1"})],
            [*self.WIRES, *clocked("sc", "clk", "clk_reset"), ("avalon", LW, "sc.csr", 0x120),
             *stream("tx.out", "sc.in", "sc.out", "rx.in")])
        self.program("""
    all |= csr[2] == 15 && csr[3] == 0 && csr[4] == 0 && csr[5] == 0;
    put(SOP, 0x44332211);
    while (csr[0] != 4) {}
    put(EOP | 2 << 2, 0x77776655);
    all |= got(rx, SOP, 0x44332211, ~0u) << 1;
    all |= got(rx, EOP | 2 << 2, 0x6655, 0xFFFF) << 2;
    all |= (csr[0] == 0) << 3;
    csr[5] = 1;                       // the first packet of two is dropped
    put(SOP | EOP | 1 << 16, 0x1111);
    put(SOP | EOP | 3 << 2, 0x99);
    all |= got(rx, SOP | EOP | 3 << 2, 0x99, 0xFF) << 4;
    csr[4] = 2;                       // goes before its end is here
    put(SOP, 0x03020100);
    all |= got(rx, SOP, 0x03020100, ~0u) << 5;
    put(EOP, 0x07060504);
    all |= got(rx, EOP, 0x07060504, ~0u) << 6;
    csr[4] = 0;                       // 20 bytes do not fit
    put(SOP, 0); put(0, 1); put(0, 2); put(0, 3); put(EOP, 4);
    all |= (got(rx, SOP, 0, ~0u) && rx[0] == 1 && rx[0] == 2 && rx[0] == 3) << 7;
    all |= got(rx, EOP, 4, ~0u) << 8;""")
        self.shows(0x1FF)

    def test_a_fifo_of_two_clocks(self):
        self.with_leds(
            [tx(usePacket="false"), rx(usePacket="false", singleClockMode="false"),
             ("slow", "clock_source", {}),
             ("dc", "altera_avalon_dc_fifo",
              {"SYMBOLS_PER_BEAT": "4", "FIFO_DEPTH": "32", "USE_IN_FILL_LEVEL": "1",
               "STREAM_ALMOST_FULL": "1"})],
            [*clocked("tx", "clk_in", "reset_in"), *clocked("dc", "in_clk", "in_clk_reset"),
             ("clock", "slow.clk", "dc.out_clk"), ("clock", "slow.clk", "rx.clk_in"),
             ("reset", "clk_0.clk_reset", "dc.out_clk_reset"),
             ("reset", "clk_0.clk_reset", "rx.reset_in"), *clocked("rx", "clk_out", "reset_out"),
             ("avalon", LW, "tx.in", 0x100), ("avalon", LW, "rx.out", 0x110),
             ("avalon", LW, "dc.in_csr", 0x120), *stream("tx.out", "dc.in", "dc.out", "rx.in")],
            [("slow", "slow.clk_in"), ("slow_reset", "slow.clk_in_reset"),
             ("full", "dc.almost_full")],
            top=", .slow_clk(slow[10]), .slow_reset_reset_n(1'b1), .full_valid(valid),"
                " .full_data(full)")
        top = self.folder / "top.v"
        top.write_text(top.read_text().replace("sys system", """wire valid, full;
reg [10:0] slow = 0;
always @(posedge CLOCK_50) slow <= slow + 1;
sys system""").replace("LEDR(LEDR)", "LEDR(LEDR[8:0])").replace(
            "leds_export(LEDR)", "leds_export(leds)").replace("wire valid", """reg was = 0;
reg never = 1;
wire [9:0] leds;
assign LEDR = {was && never, leds[8:0]};
always @(posedge CLOCK_50) if (valid && full && leds == 1) never <= 0;
    else if (valid && full && leds == 3) was <= 1;
wire valid"""))
        self.program("""
    csr[1] = 6;
    LEDS = 1;                         // not almost full
    LEDS = 2;
    for (uint32_t n = 0; n < 10; n++) tx[0] = n * 0x01010101;
    LEDS = 3;                         // almost full
    all |= 1 | (csr[1] == 6) << 1;
    all |= (csr[0] >= 6 && csr[0] <= 10) << 2;
    uint32_t n = 0;
    while (n < 10 && rx[0] == n * 0x01010101) n++;
    all |= (n == 10) << 3;
    all |= (csr[0] == 0) << 4;""")
        self.shows(0x21F)

    def test_channels_divide_and_join_streams(self):
        self.with_leds(
            [tx(channelWidth="1"), rx(channelWidth="1"), rx("rx2", channelWidth="1"),
             ("demux", "demultiplexer", {"usePackets": "true"}),
             ("mux", "multiplexer", {"usePackets": "true", "packetScheduling": "true"}),
             ("both", "altera_avalon_st_splitter",
              {"DATA_WIDTH": "32", "USE_PACKETS": "1", "USE_CHANNEL": "1"}),
             ("delay", "altera_avalon_st_delay",
              {"DATA_WIDTH": "32", "USE_PACKETS": "1", "USE_CHANNEL": "1",
               "NUMBER_OF_DELAY_CLOCKS": "3"}),
             *((name, "altera_avalon_sc_fifo", {**PACKETS, "SYMBOLS_PER_BEAT": "4"})
               for name in "ab")],
            [*self.WIRES, *clocked("rx2", "clk_in", "reset_in"), ("avalon", LW, "rx2.out", 0x118),
             *clocked("delay", "clk", "clk_reset"),
             *(wire for name in ("demux", "mux", "both") for wire in clocked(name)),
             *(wire for name in "ab" for wire in clocked(name, "clk", "clk_reset")),
             *stream("tx.out", "demux.in", "demux.out0", "a.in", "demux.out1", "b.in",
                     "a.out", "mux.in1", "b.out", "mux.in0", "mux.out", "both.in",
                     "both.out0", "rx.in", "both.out1", "delay.in", "delay.out", "rx2.in")])
        self.program("""
    enum { ONE = 1 << 8 };
    put(SOP, 10); put(EOP, 11);               // channel 0 comes out as 1
    for (volatile int n = 0; n < 50; n++) {}
    put(SOP | ONE, 20); put(EOP | ONE, 21);
    all |= got(rx, SOP | ONE, 10, ~0u); all |= got(rx, EOP | ONE, 11, ~0u) << 1;
    all |= got(rx, SOP, 20, ~0u) << 2;  all |= got(rx, EOP, 21, ~0u) << 3;
    all |= got(rx2, SOP | ONE, 10, ~0u) << 4; all |= got(rx2, EOP | ONE, 11, ~0u) << 5;
    all |= got(rx2, SOP, 20, ~0u) << 6;  all |= got(rx2, EOP, 21, ~0u) << 7;""")
        self.shows(0xFF)

    def test_a_chain_of_adapters(self):
        both = {"inUsePackets": "true", "inChannelWidth": "2", "inMaxChannel": "3"}
        two = {**both, "inSymbolsPerBeat": "2", "inErrorWidth": "2"}
        self.with_leds(
            [tx(channelWidth="2", errorWidth="2"), rx(channelWidth="1", errorWidth="3"),
             ("timing", "timing_adapter", {**both, "inSymbolsPerBeat": "4", "inErrorWidth": "2",
                                           "inReadyLatency": "1"}),
             ("width", "data_format_adapter", {**both, "inSymbolsPerBeat": "4", "inErrorWidth": "2",
                                               "outSymbolsPerBeat": "2"}),
             ("channel", "channel_adapter", {**two, "outChannelWidth": "1", "outMaxChannel": "1"}),
             ("error", "error_adapter", {**two, "inChannelWidth": "1", "inMaxChannel": "1",
                                         "inErrorDescriptor": "crc,parity",
                                         "outErrorWidth": "3",
                                         "outErrorDescriptor": "parity,late,other"}),
             ("last", "altera_avalon_st_adapter",
              {"inUsePackets": "1", "inDataWidth": "16", "inChannelWidth": "1", "inMaxChannel": "1",
               "inErrorWidth": "3", "inUseEmptyPort": "1", "outChannelWidth": "1",
               "outMaxChannel": "1", "outErrorWidth": "3", "outUseEmptyPort": "1",
               "outReadyLatency": "1"})],
            [*self.WIRES, *clocked("last", "in_clk_0", "in_rst_0"),
             *(wire for name in ("timing", "width", "channel", "error") for wire in clocked(name)),
             *stream("tx.out", "timing.in", "timing.out", "width.in", "width.out", "channel.in",
                     "channel.out", "error.in", "error.out", "last.in_0", "last.out_0", "rx.in")])
        self.program("""
    put(SOP, 0x44332211);
    put(EOP | 1 << 2 | 1 << 16, 0x00776655);              // three bytes, parity
    put(SOP | EOP | 2 << 8, 0x12345678);                  // of a channel that does not pass
    put(SOP | EOP | 1 << 8 | 2 << 16, 0xCCBBAA99);        // crc
    all |= got(rx, SOP, 0x44332211, ~0u);
    all |= got(rx, EOP | 1 << 2 | 4 << 16, 0x776655, 0xFFFFFF) << 1;
    all |= got(rx, SOP | EOP | 1 << 8 | 1 << 16, 0xCCBBAA99, ~0u) << 2;
    for (uint32_t n = 0; n < 64; n++) put(n ? EOP * (n == 63) : SOP, n);
    uint32_t n = 0;
    while (n < 64 && rx[0] == n) n++;
    all |= (n == 64) << 3;
    all |= (rx[1] == EOP) << 4;""")
        self.shows(0x1F)

    def test_packets_as_bytes(self):
        eight = {"DATA_WIDTH": "8"}
        self.with_leds(
            [tx(channelWidth="8"), rx(channelWidth="8"), rx("rx2", usePacket="false"),
             ("out", "altera_avalon_st_packets_to_bytes", {}),
             ("back", "altera_avalon_st_bytes_to_packets", {}),
             ("both", "altera_avalon_st_splitter", eight)],
            [*self.WIRES, *clocked("rx2", "clk_in", "reset_in"), ("avalon", LW, "rx2.out", 0x118),
             *clocked("both"), *clocked("out", "clk", "clk_reset"),
             *clocked("back", "clk", "clk_reset"),
             *stream("tx.out", "out.in_packets_stream", "out.out_bytes_stream", "both.in",
                     "both.out0", "back.in_bytes_stream", "back.out_packets_stream", "rx.in",
                     "both.out1", "rx2.in")])
        self.program("""
    enum { CHANNEL = 0x7B << 8 };
    put(SOP | EOP | CHANNEL, 0x33227D11);
    put(SOP | EOP | CHANNEL | 3 << 2, 0x44);
    all |= got(rx, SOP | EOP | CHANNEL, 0x33227D11, ~0u);
    all |= got(rx, SOP | EOP | CHANNEL | 3 << 2, 0x44, 0xFF) << 1;
    all |= (rx2[0] == 0x7A5B7D7C) << 2;     // channel, begins
    all |= (rx2[0] == 0x225D7D11) << 3;
    all |= (rx2[0] == 0x7D7C337B) << 4;     // ends; channel
    all |= (rx2[0] == 0x447B7A5B) << 5;""")
        self.shows(0x3F)

    # A word in each clock in which `ready` was 1 the clock before; and what takes a byte at a time.
    SOURCE = """module counter(input clk, reset, input ready, output [31:0] data);
reg was = 0;
reg [31:0] n = 0;
assign data = n;
always @(posedge clk) begin was <= ready && !reset; if (was) n <= n + 1; end
endmodule
"""
    SINK = """module shower(input clk, reset, input valid, input [7:0] data, output [9:0] shown);
reg [7:0] sum = 0; reg [7:0] count = 0;
assign shown = {count == 250, sum, 1'b1};
always @(posedge clk) if (valid && count != 250) begin sum <= sum + data; count <= count + 1; end
endmodule
"""

    PORT = "add_interface_port {0} {1} {1} {2} {3}\n"
    SHOWN = "add_interface shown conduit end\n" + PORT.format("shown", "shown", "Output", 10)

    def with_shown(self, component, modules, wires, **files):
        """The LEDs are those of a component's conduit."""
        self.with_leds(modules, wires, [("shown", f"{component}.shown")],
                       top=", .shown_shown(shown)", **files)
        top = self.folder / "top.v"
        top.write_text(top.read_text().replace("sys system", "wire [9:0] shown;\n"
                                               "assign LEDR = shown;\nsys system")
                       .replace("leds_export(LEDR)", "leds_export()"))
        self.program("")

    def test_own_sources_and_sinks_without_valid_or_ready(self):
        port = self.PORT
        ends = "add_interface {0} avalon_streaming {1}\n" + "".join(
            "set_interface_property {0} %s %s\n" % item for item in
            (("associatedClock", "clock"), ("associatedReset", "reset"), ("dataBitsPerSymbol", 8)))
        self.with_shown(
            "shower", [("counter", "counter", {}), ("shower", "shower", {})],
            [*clocked("counter", "clock"), *clocked("shower", "clock"),
             *stream("counter.out", "shower.in")],
            counter_v=self.SOURCE, shower_v=self.SINK,
            counter_hw_tcl=HW_TCL.format(name="counter") + ends.format("out", "start")
            + "set_interface_property out readyLatency 1\n"
            + port.format("out", "data", "Output", 32) + port.format("out", "ready", "Input", 1),
            shower_hw_tcl=HW_TCL.format(name="shower") + ends.format("in", "end")
            + port.format("in", "data", "Input", 8) + port.format("in", "valid", "Input", 1)
            + self.SHOWN)
        self.shows(0x201 | sum(n // 4 if n % 4 == 3 else 0 for n in range(250)) % 256 << 1)

    def test_a_projects_own_multiplexer_is_another(self):
        self.with_shown(
            "mux", [("mux", "multiplexer", {})], clocked("mux", "clock"),
            multiplexer_v="module multiplexer(input clk, reset, output [9:0] shown);\n"
                          "assign shown = 10'h155;\nendmodule\n",
            multiplexer_hw_tcl=HW_TCL.format(name="multiplexer") + self.SHOWN)
        self.shows(0x155)

    def test_what_does_not_fit_is_refused(self):
        wires = [*self.WIRES, *stream("tx.out", "rx.in")]
        for source, sink, message in (
                ({"usePacket": "false"}, {}, "rx.in has a startofpacket signal, but tx.out does"),
                ({}, {"usePacket": "false"}, "tx.out has a startofpacket signal, but rx.in does"),
                ({"bitsPerSymbol": "16", "symbolsPerBeat": "2"}, {"symbolsPerBeat": "2"},
                 "tx.out has 32 bits of data in symbols of 16, rx.in has 16 in symbols of 8")):
            self.refuses(message, [tx(**source), rx(**sink)], wires)

    def test_wrong_parameters_are_named(self):
        for kind, parameters, message in (
                ("altera_avalon_sc_fifo", {"FIFO_DEPTH": "20"}, "FIFO_DEPTH is 20, expected a"),
                ("altera_avalon_sc_fifo", {"USE_STORE_FORWARD": "1"},
                 "USE_STORE_FORWARD needs USE_FILL_LEVEL"),
                ("altera_avalon_dc_fifo", {"FIFO_DEPTH": "1"}, "FIFO_DEPTH is 1, expected"),
                ("timing_adapter", {"inReadyLatency": "5"}, "inReadyLatency is 5, expected 0 to 4"),
                ("data_format_adapter", {"inReadyLatency": "-1"}, "inReadyLatency is -1"),
                ("channel_adapter", {"inReadyLatency": "9"}, "inReadyLatency is 9"),
                ("error_adapter", {"inErrorDescriptor": "a", "inErrorWidth": "1",
                                   "outErrorWidth": "2"}, "outErrorDescriptor is needed"),
                ("altera_avalon_st_adapter", {"inDataWidth": "12"}, "inDataWidth is 12, which"),
                ("altera_avalon_st_splitter", {"NUMBER_OF_OUTPUTS": "17"},
                 "NUMBER_OF_OUTPUTS is 17, expected 1 to 16"),
                ("altera_avalon_st_delay", {"NUMBER_OF_DELAY_CLOCKS": "17"},
                 "NUMBER_OF_DELAY_CLOCKS is 17, expected 0 to 16"),
                ("multiplexer", {"numInputInterfaces": "4"}, "outChannelWidth is 1, expected at "
                                                             "least 2 for 4 inputs"),
                ("multiplexer", {"packetScheduling": "true"}, "packetScheduling needs usePackets"),
                ("altera_avalon_st_bytes_to_packets", {"ENCODING": "1"}, "ENCODING is 1: channels"),
                ("demultiplexer", {"numOutputInterfaces": "17"},
                 "numOutputInterfaces is 17, expected 1 to 16")):
            self.refuses(message, [("it", kind, parameters)])


run()
