"""dma_test.py DE1SIM FOLDER [CASE...] - Platform Designer's DMA controllers on the memories"""
import subprocess

from case import run
from systems import BASE, CLOCKS, FULL, GCC, LW, TOP, SystemCase, clocked, pio, qsys

HEAD = """#define LEDS R32(0xFF200000)
#define PENDING (R32(0xFFFED208) >> 11 & 1)
enum { GO = 1u << 31, TC = 1 << 14 };
volatile uint32_t* const csr = (uint32_t*)0xFF201000;
volatile uint32_t* const slave = (uint32_t*)0xFF201020;
volatile uint32_t* const response = (uint32_t*)0xFF201040;
#define RAM(n) (*(volatile uint8_t*)(0xFF208000 + (n)))
#define DDR(n) (*(volatile uint8_t*)(0x20000000 + (n)))
#define CHIP(n) (*(volatile uint8_t*)(0xC0000000 + (n)))
#define MORE(n) DDR(0x1000 + (n))
static void give(uint32_t from, uint32_t to, uint32_t length, uint32_t control) {
    slave[0] = from; slave[1] = to; slave[2] = length; slave[3] = control | GO;
}
static void wait(void) { while (csr[0] & 1) {} }
int main(void) {
    uint32_t all = 0;
    %s
    LEDS = all;
    for (;;) {}
}
"""
RAM = ("ram", "altera_avalon_onchip_memory2", {"memorySize": "8192"})
FIFO = {"bitsPerSymbol": "8", "symbolsPerBeat": "4", "channelWidth": "8", "errorWidth": "8",
        "fifoDepth": "256", "useReadControl": "false", "useWriteControl": "false"}


class Dma(SystemCase):
    def memories(self, modules, wires, port="f2h_axi_slave", **processor):
        """Beside 8 KiB of memory in the FPGA, at 0x8000 of the lightweight bridge."""
        leds, lit = pio("leds", 0)
        hps = ("hps_0", "altera_hps", {**BASE[1][2], **processor})
        clock = "f2h_axi_clock" if port == "f2h_axi_slave" else "f2h_sdram0_clock"
        self.write(
            sys_qsys=qsys([BASE[0], hps, *leds, RAM, *modules],
                          [*CLOCKS, *lit, *clocked("ram", "clk1", "reset1"),
                           ("avalon", LW, "ram.s1", 0x8000),
                           ("clock", "clk_0.clk", f"hps_0.{clock}"), *wires],
                          [("leds", "leds.external_connection")]),
            top_v=TOP.format(", .leds_export(LEDR)", ""),
            top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                    "set_global_assignment -name VERILOG_FILE top.v\n"
                    "set_global_assignment -name QSYS_FILE sys.qsys\n")

    def program(self, body):
        super().program("")  # the macros
        text = (self.folder / "program.c").read_text()
        self.write(program_c=text[:text.index("int main")] + HEAD % body)
        subprocess.run([*GCC, "program.c", "-o", "program.elf"], cwd=self.folder, check=True)

    SLAVES = [*clocked("dma", "clock", "reset_n"), ("avalon", LW, "dma.csr", 0x1000),
              ("avalon", LW, "dma.descriptor_slave", 0x1020),
              ("interrupt", "hps_0.f2h_irq0", "dma.csr_irq", 3)]

    def msgdma(self, wires=(), modules=(), read="hps_0.f2h_axi_slave", write="ram.s1",
               port="f2h_axi_slave", processor=None, **parameters):
        """The masters read from one slave, and write to another."""
        mode = parameters.get("MODE", "0")
        masters = [("avalon", f"dma.mm_{name}", slave, 0)
                   for name, slave, without in (("read", read, "2"), ("write", write, "1"))
                   if mode != without]
        self.memories([("dma", "altera_msgdma", {"MAX_BYTE": "4096", **parameters}), *modules],
                      [*self.SLAVES, *masters, *wires], port,
                      **(processor or {"F2S_Width": "2"}))


class Msgdma(Dma):
    # From the processor's SDRAM.
    COPY = """
    for (uint32_t n = 0; n < 600; n++) { DDR(n) = 7 * n + 1; TO(n) = 0; }
    csr[1] = 1 << 4;                                    // interrupts
    all |= csr[0] == 2 && !PENDING;                     // no descriptors
    give(0x20000000 + from, there + to, 250, 0);
    give(0x20000000 + from + 250, there + to + 250, 501 - 250, TC);
    wait();
    all |= (PENDING && (csr[0] >> 16) == 1 && (csr[0] & 0x200)) << 1;
    csr[0] = 0x200;
    all |= !PENDING << 2;
    uint32_t wrong = 0;
    for (uint32_t n = 0; n < 600; n++)
        wrong += TO(n) != (n >= to && n < to + 501 ? (uint8_t)(7 * (n - to + from) + 1) : 0);
    all |= (wrong == 0) << 3;"""

    def copies(self, start, to, there, first=0, second=0):
        self.program(f"const uint32_t from = {first}, to = {second}, there = {there};\n"
                     + self.COPY.replace("TO(", to + "(").replace("250", str(start)))

    def test_copies_into_the_fpgas_memory(self):
        self.msgdma()
        self.copies(248, "RAM", 0, 4, 8)
        self.shows(0xF)

    def test_copies_unaligned_in_bursts_of_wide_words(self):
        port = "hps_0.f2h_sdram0_data"
        self.msgdma(DATA_WIDTH="64", BURST_ENABLE="1", MAX_BURST_COUNT="8",
                    TRANSFER_TYPE="Unaligned Accesses", read=port, write=port,
                    port="f2h_sdram0_data",
                    processor={"F2SDRAM_Type": "Avalon-MM Bidirectional", "F2SDRAM_Width": "64"})
        self.copies(250, "MORE", 0x20001000, 3, 13)
        self.shows(0xF)

    def test_copies_in_bursts_to_the_boards_sdram(self):
        modules = [
            *BASE, ("pll", "altera_up_avalon_sys_sdram_pll", {"gui_outclk": "100.0"}),
            ("sdram", "altera_avalon_new_sdram_controller", {"clockRate": "100000000"}),
            ("leds", "altera_avalon_pio", {"width": "10", "direction": "Output"}),
            ("dma", "altera_msgdma", {"MAX_BYTE": "4096", "BURST_ENABLE": "1",
                                      "MAX_BURST_COUNT": "8"})]
        modules[1] = ("hps_0", "altera_hps", {**BASE[1][2], "F2S_Width": "2"})
        wires = [
            *(("clock", "pll.sys_clk", end) for end in (
                "hps_0.h2f_axi_clock", "hps_0.h2f_lw_axi_clock", "hps_0.f2h_axi_clock",
                "sdram.clk", "leds.clk", "dma.clock")),
            *(("reset", "pll.reset_source", end) for end in (
                "sdram.reset", "leds.reset", "dma.reset_n")),
            *clocked("pll", "ref_clk", "ref_reset"), *self.SLAVES[2:],
            ("avalon", FULL, "sdram.s1", 0), ("avalon", LW, "leds.s1", 0),
            ("avalon", "dma.mm_read", "hps_0.f2h_axi_slave", 0),
            ("avalon", "dma.mm_write", "sdram.s1", 0x4000000)]
        pins = "".join(f", .dram_{role}(DRAM_{pin})" for role, pin in (
            ("addr", "ADDR"), ("ba", "BA"), ("cas_n", "CAS_N"), ("cke", "CKE"), ("cs_n", "CS_N"),
            ("dq", "DQ"), ("ras_n", "RAS_N"), ("we_n", "WE_N"), ("clk_clk", "CLK")))
        self.memories([], [])
        self.write(
            sys_qsys=qsys(modules, wires, [("leds", "leds.external_connection"),
                                           ("dram", "sdram.wire"), ("dram_clk", "pll.sdram_clk")]),
            top_v=f"""module top(input CLOCK_50,
output [9:0] LEDR, output [12:0] DRAM_ADDR, output [1:0] DRAM_BA, output DRAM_CAS_N, DRAM_CKE,
DRAM_CS_N, DRAM_RAS_N, DRAM_WE_N, DRAM_CLK, DRAM_LDQM, DRAM_UDQM, inout [15:0] DRAM_DQ);
sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), .leds_export(LEDR),
           .dram_dqm({{DRAM_UDQM, DRAM_LDQM}}){pins});
endmodule
""")
        self.copies(248, "CHIP", 0x4000000, 0, 4)
        self.shows(0xF)
        self.assertEqual(self.report()["sdram_violations"]["count"], 0)

    def test_descriptors_wait_while_it_is_stopped(self):
        """With strides: every third word is read, every second written."""
        self.msgdma(ENHANCED_FEATURES="1", STRIDE_ENABLE="1", MAX_STRIDE="8",
                    DESCRIPTOR_FIFO_DEPTH="8")
        self.program("""
    for (uint32_t n = 0; n < 64; n++) { R32(0x20000000 + 4 * n) = n; R32(0xFF208000 + 4 * n) = 99; }
    csr[1] = 1 << 5;                                    // stop descriptors
    for (uint32_t n = 0; n < 3; n++) {
        slave[0] = 0x20000000 + 4 * n; slave[1] = 32 * n; slave[2] = 16;
        slave[3] = 5 + n; slave[4] = 2 << 16 | 3; slave[5] = 0; slave[6] = 0; slave[7] = GO;
    }
    all |= csr[2] == 0x00030003;
    all |= ((csr[0] & 0x7F) == 0x21) << 1;              // stopped, busy
    csr[1] = 0;
    wait();
    all |= (csr[2] == 0 && csr[4] == 0x00070007) << 2;
    uint32_t wrong = 0;
    for (uint32_t n = 0; n < 24; n++)
        wrong += R32(0xFF208000 + 4 * n) != (n & 1 ? 99 : n / 8 + 3 * (n % 8 / 2));
    all |= (wrong == 0) << 3;
    csr[1] = 1 << 5;
    slave[7] = GO;
    csr[1] = 2;                                         // a reset forgets it
    while (csr[0] & 0x40) {}
    all |= (csr[0] == 2 && csr[1] == 0) << 4;
                                                        // parked: until there is another
    R32(0x20000000) = 42; R32(0x20000008) = 5;
    slave[0] = 0x20000000; slave[1] = 0x100; slave[2] = 4; slave[4] = 1 << 16 | 1;
    slave[7] = 1 << 10 | 1 << 11 | GO;
    while (R32(0xFF208100) != 42) {}
    R32(0x20000000) = 43;
    while (R32(0xFF208100) != 43) {}
    all |= (csr[0] & 1) << 5;
    slave[0] = 0x20000008; slave[7] = GO;
    wait();
    all |= (R32(0xFF208100) == 5) << 6;""")
        self.shows(0x7F)

    def test_packets_to_a_stream(self):
        self.msgdma(
            [*clocked("rx", "clk_in", "reset_in"), ("avalon", LW, "rx.out", 0x1060),
             ("avalon_streaming", "dma.st_source", "rx.in")],
            [("rx", "altera_avalon_fifo", {**FIFO, "fifoInputInterfaceOptions": "AVALONST_SINK"})],
            MODE="1", PACKET_ENABLE="1", CHANNEL_ENABLE="1", ERROR_ENABLE="1")
        self.program("""
    volatile uint32_t* const rx = (uint32_t*)0xFF201060;
    for (uint32_t n = 0; n < 64; n++) DDR(n) = n;
    csr[1] = 1 << 4;
    give(0x20000000, 0, 10, 3 << 8 | 0x21 | 5 << 16 | TC);
    give(0x20000020, 0, 8, 1 << 9);
    all |= rx[0] == 0x03020100 && rx[1] == (1 | 0x21 << 8 | 5 << 16);
    all |= (rx[0] == 0x07060504 && rx[1] == (0x21 << 8 | 5 << 16)) << 1;
    all |= ((rx[0] & 0xFFFF) == 0x0908 && rx[1] == (2 | 2 << 2 | 0x21 << 8 | 5 << 16)) << 2;
    all |= (rx[0] == 0x23222120 && rx[1] == 0) << 3;
    all |= (rx[0] == 0x27262524 && rx[1] == 2) << 4;
    all |= PENDING << 5;""")
        self.shows(0x3F)

    def test_packets_from_a_stream(self):
        self.msgdma(
            [*clocked("tx", "clk_in", "reset_in"), ("avalon", LW, "tx.in", 0x1060),
             ("avalon", LW, "dma.response", 0x1040),
             ("avalon_streaming", "tx.out", "dma.st_sink")],
            [("tx", "altera_avalon_fifo", {**FIFO, "channelWidth": "0",
                                           "fifoOutputInterfaceOptions": "AVALONST_SOURCE"})],
            MODE="2", PACKET_ENABLE="1", ERROR_ENABLE="1", RESPONSE_PORT="0")
        self.program("""
    enum { SOP = 1, EOP = 2, TO_EOP = 1 << 12, EARLY = 1 << 15 };
    volatile uint32_t* const tx = (uint32_t*)0xFF201060;
    for (uint32_t n = 0; n < 64; n++) RAM(n) = 0xEE;
    csr[1] = 1 << 4 | 1 << 3;                           // stops on early termination
    give(0, 0, 40, TO_EOP);
    give(0, 0x10, 8, TO_EOP | EARLY);
    give(0, 0x18, 8, TO_EOP | 2 << 16);           // interrupts when error 1
    tx[1] = SOP; tx[0] = 0x03020100;
    tx[1] = EOP | 1 << 2; tx[0] = 0x07060504;           // 7 bytes
    while (csr[3] != 1) {}
    all |= response[0] == 7; all |= (response[1] == 0) << 1;
    all |= (csr[3] == 0 && RAM(6) == 6 && RAM(7) == 0xEE) << 2;
    tx[1] = SOP; tx[0] = 1; tx[0] = 2;                  // 12 bytes, of which 8 have place
    tx[1] = EOP | 2 << 16; tx[0] = 0x33;
    while (!PENDING) {}
    all |= ((csr[0] & 0x320) == 0x320) << 3;            // stopped on early termination
    all |= (response[0] == 8) << 4; all |= (response[1] == 0x100) << 5;
    csr[0] = 0x200; csr[1] = 1 << 4;
    while (!PENDING) {}
    all |= (response[0] == 4) << 6; all |= (response[1] == 2) << 7;
    all |= (RAM(0x18) == 0x33 && RAM(0x1C) == 0xEE && !(csr[0] & 1)) << 8;""")
        self.shows(0x1FF)

    def test_its_streams_at_the_outside(self):
        self.msgdma([*clocked("turn", "in_clk_0", "in_rst_0"),
                     ("avalon_streaming", "dma.st_source", "turn.in_0"),
                     ("avalon_streaming", "turn.out_0", "dma.st_sink")],
                    [("turn", "altera_avalon_st_adapter",
                      {"inDataWidth": "32", "outDataWidth": "32", "inChannelWidth": "0",
                       "outChannelWidth": "0", "inErrorWidth": "0", "outErrorWidth": "0"})],
                    EXPOSE_ST_PORT="1")
        self.copies(248, "RAM", 0, 0, 4)
        self.shows(0xF)

    def test_wrong_parameters_are_named(self):
        for parameters, message in (
                ({"DATA_WIDTH": "24"}, "DATA_WIDTH is 24, expected one of 8, 16"),
                ({"PREFETCHER_ENABLE": "1"}, "the prefetcher (PREFETCHER_ENABLE) cannot be"),
                ({"ENHANCED_FEATURES": "1", "STRIDE_ENABLE": "1", "BURST_ENABLE": "1"},
                 "STRIDE_ENABLE and BURST_ENABLE exclude each other"),
                ({"BURST_ENABLE": "1", "MAX_BURST_COUNT": "16"},
                 "DATA_FIFO_DEPTH is 32, expected at least four times MAX_BURST_COUNT, 16")):
            self.refuses(message, [("dma", "altera_msgdma", parameters)])


class SimpleDma(Dma):
    def dma(self, wires=(), modules=(), **parameters):
        self.memories(
            [("dma", "altera_avalon_dma", parameters), *modules],
            [*clocked("dma"), ("avalon", LW, "dma.control_port_slave", 0x1000),
             ("interrupt", "hps_0.f2h_irq0", "dma.irq", 3),
             ("avalon", "dma.read_master", "hps_0.f2h_axi_slave", 0),
             ("avalon", "dma.write_master", "ram.s1", 0), *wires], F2S_Width="2")

    def test_copies_in_units_of_each_size(self):
        self.dma()
        self.program("""
    enum { BYTE = 1, HW = 2, WORD = 4, RUN = 8, I_EN = 16, LEEN = 128, RCON = 256, QUAD = 2048 };
    volatile uint32_t* const dma = csr;
    for (uint32_t n = 0; n < 256; n++) { DDR(n) = 3 * n + 1; RAM(n) = 0; }
    all |= dma[6] == 0x84 && dma[0] == 0;
    dma[1] = 0x20000004; dma[2] = 0x10; dma[3] = 60; dma[6] = WORD | RUN | I_EN | LEEN;
    while (!PENDING) {}
    all |= (dma[0] == 0x11 && dma[3] == 0 && dma[1] == 0x20000040 && dma[2] == 0x4C) << 1;
    dma[6] = 0; dma[0] = 0;
    all |= (!PENDING && dma[0] == 0) << 2;
    dma[1] = 0x20000001; dma[2] = 0x53; dma[3] = 7; dma[6] = BYTE | RUN | LEEN;
    while (!(dma[0] & 1)) {}
    dma[6] = 0; dma[0] = 0;
    dma[1] = 0x20000006; dma[2] = 0x60; dma[3] = 10; dma[6] = HW | RUN | LEEN | RCON;
    while (!(dma[0] & 1)) {}
    dma[6] = 0; dma[0] = 0;
    dma[1] = 0x20000010; dma[2] = 0x80; dma[3] = 48; dma[6] = QUAD | RUN | LEEN;
    while (dma[0] & 2) {}
    uint32_t wrong = 0;
    for (uint32_t n = 0; n < 256; n++) {
        const uint32_t from = n >= 0x10 && n < 0x4C ? n - 0x0C : n >= 0x53 && n < 0x5A ? n - 0x52
            : n >= 0x60 && n < 0x6A ? 6 + n % 2 : n >= 0x80 && n < 0xB0 ? n - 0x70 : 256;
        wrong += RAM(n) != (from < 256 ? (uint8_t)(3 * from + 1) : 0);
    }
    all |= (wrong == 0) << 3;
    dma[6] = 0; dma[3] = 100;
    dma[6] = 1 << 12; all |= (dma[3] == 100) << 4;
    dma[6] = 1 << 12; all |= (dma[3] == 0 && dma[6] == 0x84) << 5;""")
        self.shows(0x3F)

    def test_one_address_takes_all(self):
        """A FIFO, to which it is as to a program."""
        self.dma([*clocked("fifo", "clk_in", "reset_in"), ("avalon", LW, "fifo.out", 0x1060),
                  ("avalon", "dma.write_master", "fifo.in", 0x2000)],
                 [("fifo", "altera_avalon_fifo", {**FIFO, "fifoDepth": "16"})],
                 allowQuadWordTransactions="false", fifoDepth="4")
        self.program("""
    volatile uint32_t* const fifo = (uint32_t*)0xFF201060;
    for (uint32_t n = 0; n < 40; n++) R32(0x20000000 + 4 * n) = 0x01010101 * n;
    csr[1] = 0x20000000; csr[2] = 0x2000; csr[3] = 160; csr[6] = 4 | 8 | 128 | 512;
    while (csr[3] > 160 - 4 * 16) {}
    all |= csr[0] == 2;                                 // the FIFO is full
    uint32_t n = 0;
    while (n < 40 && *fifo == 0x01010101 * n) n++;
    all |= (n == 40) << 1;
    while (!(csr[0] & 1)) {}
    all |= (csr[2] == 0x2000) << 2;""")
        self.shows(7)

    def test_wrong_parameters_are_named(self):
        kinds = ("Byte", "HalfWord", "Word", "DoubleWord", "QuadWord")
        for parameters, message in (
                ({"fifoDepth": "3"}, "fifoDepth is 3, expected a power of two, 4 to 4096"),
                ({"bigEndian": "true"}, "bigEndian cannot be simulated"),
                ({f"allow{kind}Transactions": "false" for kind in kinds},
                 "no transactions are allowed")):
            self.refuses(message, [("dma", "altera_avalon_dma", parameters)])


class ScatterGather(Dma):
    PREPARE = """
    enum { HW = 1u << 31, RUN = 1 << 5 };
    #define D(n, k) R32(0x20002000 + 32 * (n) + 4 * (k))    // word k of descriptor n
    #define CHAIN(n, from, to, count, more) do { D(n, 0) = from; D(n, 2) = to; \\
        D(n, 4) = 0x20002020 + 32 * (n); D(n, 6) = count; D(n, 7) = HW | (more); } while (0)
    for (uint32_t n = 0; n < 512; n++) { DDR(n) = 5 * n + 2; MORE(n) = 0; RAM(n) = 0; }
    for (uint32_t n = 0; n < 64; n++) R32(0x20002000 + 4 * n) = 0;"""

    def sgdma(self, name, base, irq, mode, **parameters):
        """All it does is on the processor's memory, but what it writes from memory to memory."""
        slave = "hps_0.f2h_axi_slave"
        masters = ["descriptor_read", "descriptor_write"] + ["m_read"] * mode.startswith("MEM")
        wires = [*clocked(name), ("avalon", LW, f"{name}.csr", base),
                 ("interrupt", "hps_0.f2h_irq0", f"{name}.csr_irq", irq),
                 *(("avalon", f"{name}.{master}", slave, 0) for master in masters)]
        if mode.endswith("MEMORY"):
            to = "ram.s1" if mode == "MEMORY_TO_MEMORY" else slave
            wires.append(("avalon", f"{name}.m_write", to, 0))
        return (name, "altera_avalon_sgdma", {"transferMode": mode, **parameters}), wires

    def test_a_chain_of_descriptors(self):
        dma, wires = self.sgdma("dma", 0x1000, 3, "MEMORY_TO_MEMORY",
                                enableUnalignedTransfers="true")
        self.memories([dma], wires, F2S_Width="2")
        self.program(self.PREPARE + """
    CHAIN(0, 0x20000001, 0x13, 100, 0);
    CHAIN(1, 0x20000100, 0x80, 9, 0);
    CHAIN(2, 0x20000010, 0x100, 16, 1 << 25);           // of one word
    all |= csr[1] == 1 && csr[0] == 0;
    csr[8] = 0x20002000;
    csr[4] = RUN | 1 << 4 | 1 << 3;                     // interrupts at the end of the chain
    while (!PENDING) {}
    all |= (csr[0] == 0xC && csr[8] == 0x20002060) << 1;
    csr[4] = 1u << 31; csr[0] = 0xC;
    all |= (csr[0] == 0 && !PENDING) << 2;
    uint32_t wrong = 0;
    for (uint32_t n = 0; n < 512; n++) {
        const uint32_t from = n >= 0x13 && n < 0x13 + 100 ? n - 0x12
            : n >= 0x80 && n < 0x89 ? n + 0x80 : n >= 0x100 && n < 0x110 ? 0x10 + n % 4 : 512;
        wrong += RAM(n) != (from < 512 ? (uint8_t)(5 * from + 2) : 0);
    }
    all |= (wrong == 0) << 3;
    all |= (D(0, 7) == 100 && D(1, 7) == 9 && D(2, 7) == (16 | 1 << 25)) << 4;
    D(3, 0) = 0x20000000; D(3, 2) = 0x180; D(3, 4) = 0x20002060; D(3, 6) = 4;
    csr[4] = RUN | 1 << 18;                             // looks until there is one
    for (volatile int n = 0; n < 99; n++) {}
    all |= ((csr[0] & 8) == 0 && RAM(0x180) == 0) << 5;
    D(3, 7) = HW;
    while (RAM(0x180) != 2) {}
    while (!(csr[0] & 4)) {}
    csr[4] = 1 << 16; csr[4] = 1 << 16;
    all |= (csr[4] == 0 && csr[8] == 0 && csr[0] == 0) << 6;""")
        self.shows(0x7F)

    def test_packets_from_one_to_another(self):
        tx, tx_wires = self.sgdma("tx", 0x1040, 4, "MEMORY_TO_STREAM")
        rx, rx_wires = self.sgdma("rx", 0x1000, 3, "STREAM_TO_MEMORY")
        splitter = ("both", "altera_avalon_st_splitter", {"DATA_WIDTH": "32", "USE_PACKETS": "1"})
        fifo = {**FIFO, "channelWidth": "0", "errorWidth": "0",
                "fifoInputInterfaceOptions": "AVALONST_SINK"}
        self.memories(
            [tx, rx, splitter, ("fifo", "altera_avalon_fifo", fifo)],
            [*tx_wires, *rx_wires, *clocked("both"), *clocked("fifo", "clk_in", "reset_in"),
             ("avalon", LW, "fifo.out", 0x1080), ("avalon_streaming", "tx.out", "both.in"),
             ("avalon_streaming", "both.out0", "rx.in"),
             ("avalon_streaming", "both.out1", "fifo.in")], F2S_Width="1")
        self.program(self.PREPARE + """
    volatile uint32_t* const tx = (uint32_t*)0xFF201040;
    CHAIN(0, 0x20000000, 0, 40, 0); CHAIN(1, 0x20000040, 0, 11, 1 << 24);   // one packet
    CHAIN(2, 0x20000080, 0, 8, 1 << 24); CHAIN(3, 0, 0, 0, 0); D(3, 7) = 0;
    CHAIN(4, 0, 0x20001000, 44, 0); CHAIN(5, 0, 0x20001040, 64, 0); CHAIN(6, 0, 0x20001080, 0, 0);
    csr[8] = 0x20002080; csr[4] = RUN | 1 << 4 | 1 << 3;
    tx[8] = 0x20002000; tx[4] = RUN;
    while (!PENDING) {}
    all |= (csr[0] == 0xE);                             // also the end of a packet
    uint32_t wrong = 0;
    for (uint32_t n = 0; n < 256; n++) {
        const uint32_t from = n < 40 ? n : n < 44 ? n + 24 : n >= 64 && n < 71 ? n + 4
            : n >= 128 && n < 136 ? n : 512;
        wrong += MORE(n) != (from < 512 ? (uint8_t)(5 * from + 2) : 0);
    }
    all |= (wrong == 0) << 1;
    all |= (D(4, 7) == 44 && D(5, 7) == (7 | 1 << 23) && D(6, 7) == (8 | 1 << 23)) << 2;
    all |= (D(0, 7) == 40 && D(1, 7) == (11 | 1 << 24) && tx[0] == 0xC) << 3;
    volatile uint32_t* const fifo = (uint32_t*)0xFF201080;
    wrong = 0;
    for (uint32_t n = 0; n < 15; n++) {
        (void)fifo[0];
        wrong += fifo[1] != (n == 0 || n == 13 ? 1 : n == 12 ? 2 | 1 << 2 : n == 14 ? 2 : 0);
    }
    all |= (wrong == 0) << 4;""")
        self.shows(0x1F)

    def test_wrong_parameters_are_named(self):
        for parameters, message in (
                ({"transferMode": "STREAM"}, "transferMode is STREAM, expected MEMORY_TO_MEMORY"),
                ({"readBlockDataWidth": "24"}, "readBlockDataWidth is 24, expected 8, 16"),
                ({"avalonMMByteReorderMode": "1"}, "avalonMMByteReorderMode cannot be simulated")):
            self.refuses(message, [("dma", "altera_avalon_sgdma", parameters)])


run()
