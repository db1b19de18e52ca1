"""bursts_test.py DE1SIM FOLDER [CASE...] - the processor's bursts at a design's own AXI3 slaves"""
from case import run
from systems import SystemCase

# Prints a line for each burst: R or W, bus, ID, address, len, size, burst, lock, cache, prot; and
# of a write, the strobes of each word.  It is a memory, whose IDs are wrong by WRONG; it answers
# with SLVERR where bit 14 of the address is 1, with DECERR where bit 13 is, too; and to exclusive
# accesses with EXOKAY where bit 12 is 1.
RECORDER = """module recorder #(parameter BYTES = 4, BITS = 21, WRONG = 0, LAST = 0) (
    input clk,
    input [11:0] awid, input [BITS-1:0] awaddr, input [3:0] awlen, input [2:0] awsize,
    input [1:0] awburst, awlock, input [3:0] awcache, input [2:0] awprot, input awvalid,
    output awready,
    input [11:0] wid, input [8*BYTES-1:0] wdata, input [BYTES-1:0] wstrb, input wlast, wvalid,
    output wready, output [11:0] bid, output [1:0] bresp, output bvalid,
    input [11:0] arid, input [BITS-1:0] araddr, input [3:0] arlen, input [2:0] arsize,
    input [1:0] arburst, arlock, input [3:0] arcache, input [2:0] arprot, input arvalid,
    output arready,
    output [11:0] rid, output reg [8*BYTES-1:0] rdata, output [1:0] rresp,
    output rlast, rvalid);
reg [7:0] bytes [0:4095];
reg [11:0] id = 0, at = 0;
reg [4:0] left = 0;
reg [2:0] size = 0;
reg fixed = 0, writes = 0, answers = 0;
reg [1:0] error = 0;
integer n;
function [11:0] next(input [11:0] at, input [2:0] size, input fixed);
    next = fixed ? at : (at >> size << size) + (12'd1 << size);
endfunction
initial for (n = 0; n < 4096; n = n + 1) bytes[n] = 0;
assign {awready, arready} = {2{left == 0 && !answers}};
assign wready = writes && left != 0;
assign {bid, rid} = {2{id ^ WRONG[11:0]}};
assign {bresp, rresp} = {2{error}};
assign bvalid = answers;
assign rvalid = !writes && left != 0;
assign rlast = LAST || left == 1;
always @* for (n = 0; n < BYTES; n = n + 1) rdata[8*n +: 8] = bytes[at / BYTES * BYTES + n];
always @(posedge clk) begin
    answers <= wready && wvalid && left == 1;
    if (awvalid && awready)
        error <= awaddr[14] ? {1'b1, awaddr[13]} : {1'b0, awlock[0] && awaddr[12]};
    if (arvalid && arready)
        error <= araddr[14] ? {1'b1, araddr[13]} : {1'b0, arlock[0] && araddr[12]};
    if (awvalid && awready) begin
        $write("W%0d %h %h %0d %0d %0d %0d %b %b :", 8 * BYTES, awid, awaddr, awlen, awsize,
               awburst, awlock, awcache, awprot);
        {id, at, size, fixed, writes, left} <= {awid, awaddr[11:0], awsize, awburst == 2'd0, 1'b1,
                                                {1'b0, awlen} + 5'd1};
    end else if (arvalid && arready) begin
        $display("R%0d %h %h %0d %0d %0d %0d %b %b", 8 * BYTES, arid, araddr, arlen, arsize,
                 arburst, arlock, arcache, arprot);
        {id, at, size, fixed, writes, left} <= {arid, araddr[11:0], arsize, arburst == 2'd0, 1'b0,
                                                {1'b0, arlen} + 5'd1};
    end
    if (wready && wvalid) begin
        $write(" %h", wstrb);
        if (wlast) $write("\\n");
        if (wlast != (left == 1) || wid != id) $display("wrong WLAST or WID");
        for (n = 0; n < BYTES; n = n + 1)
            if (wstrb[n]) bytes[at / BYTES * BYTES + n] <= wdata[8*n +: 8];
    end
    if (wready && wvalid || rvalid) begin
        left <= left - 1;
        at <= next(at, size, fixed);
    end
end
endmodule
"""
# A word each: what comes after the first is not looked at.
SINGLE = """module recorder #(parameter BYTES = 4, BITS = 21, WRONG = 0, LAST = 0) (
    input clk,
    input [11:0] awid, input [BITS-1:0] awaddr, input [3:0] awlen, input [2:0] awsize,
    input [1:0] awburst, awlock, input [3:0] awcache, input [2:0] awprot, input awvalid,
    output awready,
    input [11:0] wid, input [8*BYTES-1:0] wdata, input [BYTES-1:0] wstrb, input wlast, wvalid,
    output wready, output reg [11:0] bid, output [1:0] bresp, output reg bvalid,
    input [11:0] arid, input [BITS-1:0] araddr, input [3:0] arlen, input [2:0] arsize,
    input [1:0] arburst, arlock, input [3:0] arcache, input [2:0] arprot, input arvalid,
    output arready,
    output reg [11:0] rid, output [8*BYTES-1:0] rdata, output [1:0] rresp, output rlast,
    output reg rvalid);
initial {bvalid, rvalid} = 0;
assign awready = awvalid && wvalid, wready = awready || LAST, arready = 1, rdata = 5;
assign {bresp, rresp} = 0;
assign rlast = LAST;
always @(posedge clk) begin
    {bvalid, bid} <= {awready, awid};
    {rvalid, rid} <= {arvalid, arid};
end
endmodule
"""
# Takes single words, up to three before it answers, and then answers the last first: when there are
# three, or 64 clocks after the first.  Prints A with ID, address, and how many it has by then; B
# with the ID.  With SLVERR where bit 14 of the address is 1, with DECERR where bit 13 is, too.
LATE = """module recorder #(parameter BYTES = 4, BITS = 21, WRONG = 0, LAST = 0) (
    input clk,
    input [11:0] awid, input [BITS-1:0] awaddr, input [3:0] awlen, input [2:0] awsize,
    input [1:0] awburst, awlock, input [3:0] awcache, input [2:0] awprot, input awvalid,
    output awready,
    input [11:0] wid, input [8*BYTES-1:0] wdata, input [BYTES-1:0] wstrb, input wlast, wvalid,
    output wready, output reg [11:0] bid, output reg [1:0] bresp, output reg bvalid,
    input [11:0] arid, input [BITS-1:0] araddr, input [3:0] arlen, input [2:0] arsize,
    input [1:0] arburst, arlock, input [3:0] arcache, input [2:0] arprot, input arvalid,
    output arready,
    output reg [11:0] rid, output [8*BYTES-1:0] rdata, output [1:0] rresp, output rlast,
    output reg rvalid);
reg [13:0] held [0:3];
reg [1:0] n = 0;
reg [6:0] waited = 0;
initial {bvalid, rvalid} = 0;
assign awready = n != 3 && waited < 64 && awvalid && wvalid, wready = awready, arready = 1;
assign rdata = 5, rresp = 0, rlast = 1;
always @(posedge clk) begin
    {rvalid, rid} <= {arvalid, arid};
    if (arvalid) $display("R %h", arid);
    bvalid <= 0;
    if (awready) begin
        $display("A %h %h %0d", awid, awaddr, n + 1);
        held[n] <= {awaddr[14], awaddr[14] & awaddr[13], awid ^ WRONG[11:0]};
        n <= n + 1;
        waited <= n == 2 ? 64 : waited + 1;
    end else if (n != 0 && waited < 64) waited <= waited + 1;
    else if (n != 0) begin
        {bvalid, bresp, bid} <= {1'b1, held[n - 1]};
        $display("B %h", held[n - 1][11:0]);
        n <= n - 1;
        if (n == 1) waited <= 0;
    end
end
endmodule
"""
PORTS = ("awid awaddr awlen awsize awburst awlock awcache awprot awvalid awready wid wdata wstrb "
         "wlast wvalid wready bid bresp bvalid arid araddr arlen arsize arburst arlock arcache "
         "arprot arvalid arready rid rdata rresp rlast rvalid").split()
# Sections of 1 MB: Strongly-ordered at 0xC00, Normal without caches at 0xC01, Device at 0xC02.
HEAD = """static uint32_t table[4096] __attribute__((aligned(0x4000)));
static void map(void) {
    for (uint32_t n = 0; n < 4096; ++n) table[n] = n << 20 | 0xC02;
    table[0xC01] |= 1 << 12; table[0xC02] |= 1 << 2;
    __asm__ volatile("mcr p15, 0, %0, c2, c0, 0\\nmcr p15, 0, %1, c3, c0, 0\\ndsb\\n"
                     "mrc p15, 0, r3, c1, c0, 0\\norr r3, r3, #1\\nmcr p15, 0, r3, c1, c0, 0\\n"
                     "isb" :: "r"(table), "r"(1) : "r3", "memory");
}
#define AT(a, text) { register uint32_t to __asm__("r0") = a; __asm__ volatile(".fpu neon\\n" text \
    : "+r"(to) :: "r1", "r2", "r3", "r4", "r5", "r6", "r7", "r8", "r9", "r10", "memory"); }
"""


class Bursts(SystemCase):
    def recorders(self, width=64, slave=RECORDER, wrong=0, last=0):
        """One behind each bridge."""
        text = "module top(input CLOCK_50, output [9:0] LEDR);\nassign LEDR = 0;\n"
        for name, primitive, bits, size in (
                ("lw", "hps2fpga_light_weight", 21, 32), ("full", "hps2fpga", 30, width)):
            widths = {"addr": bits, "len": 4, "size": 3, "burst": 2, "lock": 2, "cache": 4,
                      "prot": 3, "id": 12, "data": size, "strb": size // 8, "resp": 2}
            for port in PORTS:
                wide = widths.get(port[2 if port[0] == "a" else 1:], 1)
                text += f"wire [{wide - 1}:0] {name}_{port};\n"
            connected = ", ".join(f".{port}({name}_{port})" for port in PORTS)
            config = ", .port_size_config(2'd%d)" % {32: 0, 64: 1, 128: 2}[size]
            text += (f"cyclonev_hps_interface_{primitive} {name}(.clk(CLOCK_50), {connected}"
                     f"{config if name == 'full' else ''});\n"
                     f"recorder #(.BYTES({size // 8}), .BITS({bits}), .WRONG({wrong}), "
                     f".LAST({last})) {name}_slave(.clk(CLOCK_50), {connected});\n")
        self.write(top_v=text + "endmodule\n" + slave,
                   top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                           "set_global_assignment -name TOP_LEVEL_ENTITY top\n"
                           "set_global_assignment -name VERILOG_FILE top.v\n")

    def bursts(self, body, code=0):
        """What is printed when the program has done that."""
        self.program(body, HEAD)
        done = self.played("delay: 30ms", code=code)
        lines = [line for line in done.stdout.splitlines() if line[0] in "ABRW"]
        return done if code else lines

    def test_strongly_ordered_memory(self):
        self.recorders()

        def done(window, *instructions):
            return self.bursts("".join(f'AT({window}, "{text}")\n' for text in instructions))
        self.assertEqual(
            done("0xC0000040", "stm r0, {r1-r8}", "add r0, #4\\nstm r0, {r1-r4}",
                 "strd r2, [r0]", "vstm r0, {d0-d1}", "strb r1, [r0, #3]",
                 "add r0, #64\\nstmdb r0!, {r1-r3}"),
            [f"W64 002 000000{start} 2 1 0 0000 001 : {strobes}" for start, strobes in (
                ("40 1", "0f f0"), ("48 1", "0f f0"), ("50 1", "0f f0"), ("58 1", "0f f0"),
                ("44 0", "f0"), ("48 1", "0f f0"), ("50 0", "0f"), ("40 1", "0f f0"),
                ("40 1", "0f f0"), ("48 1", "0f f0"))]
            + ["W64 002 00000043 0 0 1 0 0000 001 : 08"]
            + [f"W64 002 000000{start} 2 1 0 0000 001 : {strobes}" for start, strobes in (
                ("74 0", "f0"), ("78 1", "0f f0"))])
        self.assertEqual(
            done("0xC0000040", "ldm r0, {r1-r8}", "ldrd r2, [r0]", "vldm r0, {d0-d3}",
                 "vldr d0, [r0]", "vld1.32 {d0-d3}, [r0]", "ldrh r1, [r0, #2]"),
            ["R64 01a 00000040 7 2 1 0 0000 001", "R64 03a 00000040 1 2 1 0 0000 001",
             "R64 05a 00000040 7 2 1 0 0000 001", "R64 07a 00000040 1 2 1 0 0000 001",
             "R64 01a 00000040 7 2 1 0 0000 001", "R64 03a 00000042 0 1 1 0 0000 001"])
        # No burst crosses 4 KB; a loop of one instruction is one each time.
        self.assertEqual(done("0xFF200FF0", "ldm r0, {r1-r8}", "strd r2, [r0]"),
                         ["R32 01a 000ff0 3 2 1 0 0000 001", "R32 03a 001000 3 2 1 0 0000 001",
                          "W32 002 000ff0 1 2 1 0 0000 001 : f f"])
        self.assertEqual(done("0xFF200000", "mov r4, #3\\n1: ldm r0, {r1-r3}\\n"
                              "subs r4, #1\\nbne 1b"),
                         [f"R32 0{n}a 000000 2 2 1 0 0000 001" for n in (1, 3, 5)])

    MAPPED = """map(); R32(0xC0100000) = 1; R32(0xC0200000) = 1;
AT(0xC0100004, "stm r0!, {r1-r10}") R32(0xC0200000) = 1; R32(0xC0200004) = 2;
AT(0xC0100008, "ldm r0, {r1-r8}") AT(0xC010000C, "ldm r0, {r1-r8}") (void)R32(0xC0100004);
AT(0xC0200004, "ldm r0, {r1-r2}") """

    # The first time that a STREX is executed it may fail.
    EXCLUSIVE = """uint32_t old, failed, tries = 0;
for (int n = 0; n < 2; n++) { tries = 0;
    do __asm__ volatile("ldrex %0, [%2]\\nadd %0, %0, #1\\nstrex %1, %0, [%2]" : "=&r"(old),
        "=&r"(failed) : "r"(0xC0001040) : "memory");
    while (failed && ++tries < 5);
}
R32(0xC0000000 + 8 * failed) = tries << 8 | R32(0xC0001040);
"""

    def test_exclusive_accesses(self):
        self.recorders()
        lines = self.bursts(self.EXCLUSIVE)
        self.assertEqual([line[7:] for line in lines[-4:-2]],
                         [" 00001040 0 2 1 1 0000 001", " 00001040 0 2 1 1 0000 001 : 0f"])
        self.assertEqual([line[:3] + line[7:16] for line in lines[-2:]],
                         ["R64 00001040", "W64 00000000"])

    def test_nobody_keeps_exclusive_accesses_apart(self):
        self.recorders()
        self.program(self.EXCLUSIVE.replace("1040", "0040"), HEAD)
        done = self.played("delay: 5ms")
        self.assertIn("an exclusive store (STREX) fails, as on the board: the design answers it "
                      "with OKAY, not with EXOKAY", done.stderr)
        self.assertIn("W64 002 00000008", done.stdout)

    def test_memory_types(self):
        """Normal, Device; the first store to a page goes alone."""
        self.recorders()
        self.assertEqual(self.bursts(self.MAPPED), [
            "W64 02a 00100000 0 2 1 0 0011 001 : 0f", "W64 04a 00200000 0 2 1 0 0001 001 : 0f",
            "W64 06a 00100004 0 2 1 0 0011 001 : f0",
            "W64 02a 00100008 2 3 1 0 0011 001 : ff ff ff",
            "W64 04a 00100020 1 3 1 0 0011 001 : ff 0f", "W64 06a 00200000 0 2 1 0 0001 001 : 0f",
            "W64 02a 00200004 0 2 1 0 0001 001 : f0", "R64 01a 00100008 3 3 1 0 0011 001",
            "R64 03a 0010000c 4 3 1 0 0011 001", "R64 05a 00100004 0 2 1 0 0011 001",
            "R64 07a 00200004 1 2 1 0 0001 001"])

    def test_widths_of_the_bridge(self):
        self.recorders(32)
        self.assertEqual(self.bursts(self.MAPPED)[3:10], [
            "W32 02a 00100008 5 2 1 0 0011 001 : f f f f f f",
            "W32 04a 00100020 2 2 1 0 0011 001 : f f f", "W32 06a 00200000 0 2 1 0 0001 001 : f",
            "W32 02a 00200004 0 2 1 0 0001 001 : f", "R32 01a 00100008 7 2 1 0 0011 001",
            "R32 03a 0010000c 7 2 1 0 0011 001", "R32 05a 00100004 0 2 1 0 0011 001"])
        self.recorders(128)
        self.assertEqual(self.bursts(self.MAPPED)[3:], [
            "W128 02a 00100008 1 4 1 0 0011 001 : ff00 ffff",
            "W128 04a 00100020 0 4 1 0 0011 001 : 0fff",
            "W128 06a 00200000 0 2 1 0 0001 001 : 000f",
            "W128 02a 00200004 0 2 1 0 0001 001 : 00f0", "R128 01a 00100008 2 4 1 0 0011 001",
            "R128 03a 0010000c 2 4 1 0 0011 001", "R128 05a 00100004 0 2 1 0 0011 001",
            "R128 07a 00200004 1 2 1 0 0001 001"])

    # At each place in a line, in each type of memory: words, pairs, several and NEON.
    STORED = """map(); uint32_t bad = 0;
static const uint32_t windows[] = {0xC0000000, 0xC0100000, 0xC0200000, 0xFF200000};
for (uint32_t n = 0; n < 4; ++n) for (uint32_t at = windows[n]; at < windows[n] + 64; at += 4) {
    for (uint32_t n = 0; n < 24; ++n) R32(at + 4 * n) = 0;
    __asm__ volatile(".fpu neon\\nmov r2, #1\\nmov r3, #2\\nmov r4, #3\\nmov r5, #4\\n"
        "vmov d0, r2, r3\\nvmov d1, r4, r5\\nstm %0, {r2-r5}\\nldr r2, [%0, #12]\\n"
        "strd r2, [%0, #16]\\nadd r6, %0, #24\\nvstm r6, {d0-d1}\\nvldm %0, {d2-d3}\\n"
        "add r6, #16\\nvstm r6, {d2-d3}\\nldm %0, {r2-r4}\\nadd r6, #16\\nstm r6, {r2-r4}\\n"
        :: "r"(at) : "r2", "r3", "r4", "r5", "r6", "memory");
    static const uint32_t expected[] = {1, 2, 3, 4, 4, 2, 1, 2, 3, 4, 1, 2, 3, 4, 1, 2, 3, 0};
    for (uint32_t n = 0; n < 18; ++n) bad |= R32(at + 4 * n) != expected[n];
}
R32(bad ? 0xFF200F00 : 0xFF200E00) = 0;"""

    def test_what_is_stored_is_loaded(self):
        for width in 32, 64, 128:
            self.recorders(width)
            self.assertIn(" 000e00 ", self.bursts(self.STORED)[-1])

    def test_dma_controller(self):
        """Bursts of 8 and 16 beats, FIXED ones, of 8 bytes for a bus of 4."""
        self.recorders()
        code = [0xBC, 0, *(0xC0000100).to_bytes(4, "little"),
                0xBC, 2, *(0xFF200204).to_bytes(4, "little"),
                # 16 of 4 bytes, cacheable, to 16 of 4 bytes; PROT 0 and 2
                0xBC, 1, *(1 | 2 << 1 | 15 << 4 | 1 << 14 | 2 << 15 | 15 << 18 | 2 << 22
                           | 1 << 25).to_bytes(4, "little"), 4, 8,
                # 8 of 8 bytes, at one address both
                0xBC, 1, *(3 << 1 | 7 << 4 | 3 << 15 | 7 << 18).to_bytes(4, "little"), 4, 8, 0]
        self.assertEqual(self.bursts(f"""static const uint8_t code[] = {{
{", ".join(map(str, code))}}};
R32(0xFFD05018) = 0;
R32(0xFFE01D08) = 0xA0 << 16 | 5 << 24; R32(0xFFE01D0C) = (uint32_t)code; R32(0xFFE01D04) = 0;"""),
                         ["R64 029 00000100 15 2 1 0 0000 000",
                          "W32 029 000204 15 2 1 0 0001 010 : " + " ".join("f" * 16),
                          "R64 029 00000140 7 3 0 0 0000 000",
                          *["W32 029 000244 1 2 1 0 0000 000 : f f"] * 8])

    def test_a_wrong_id_is_not_answered(self):
        self.recorders(wrong=0x7F8)
        for access, what in (
                ("R32(0xC0000000) = 1;", "bvalid with ID 0x002: the design answers with ID 0x7FA"),
                ("(void)R32(0xFF200000);",
                 "rvalid with ID 0x01A: the design answers with ID 0x7E2")):
            done = self.bursts(access, code=1)
            self.assertIn("the design did not answer: its bridge waits for " + what, done.stderr)

    def test_writes_to_device_and_normal_memory_are_posted(self):
        """Up to three, also over both bridges; Strongly-ordered ones, and reads, wait for all."""
        self.recorders(slave=LATE)
        write = "R32(0xC0200000) = 1; R32(0xC0200008) = 2; R32(0xC0200010) = 3; "
        self.assertEqual(self.bursts("map(); " + write + "R32(0xC0200018) = 4; "
                                     "(void)R32(0xC0200020); R32(0xC0000000) = 5;"), [
            "A 02a 00200000 1", "A 04a 00200008 2", "A 06a 00200010 3", "B 06a", "B 04a", "B 02a",
            "A 06a 00200018 1", "B 06a", "R 01a", "A 002 00000000 1", "B 002"])
        self.assertEqual(self.bursts("map(); table[0xFF2] |= 1 << 2; R32(0xC0200000) = 1; "
                                     "R32(0xFF200008) = 2; R32(0xC0000010) = 3;"), [
            "A 02a 00200000 1", "A 04a 000008 1", "B 02a", "B 04a", "A 002 00000010 1", "B 002"])

    # Vectors: of a data abort one that stores a byte at DFSR's offset.
    VECTORS = """__attribute__((naked)) static void aborted(void) {
    __asm__ volatile("mrc p15, 0, r0, c5, c0, 0\\nadd r0, #0xC0000000\\nstrb r0, [r0]\\n"
                     "subs pc, lr, #8");
}
static uint32_t vectors[16] __attribute__((aligned(64)));
static void install(void) {
    for (int n = 0; n < 8; ++n) vectors[n] = 0xE59FF018;
    vectors[12] = (uint32_t)aborted;
    __asm__ volatile("mcr p15, 0, %0, c12, c0, 0\\nisb" :: "r"(vectors));
}
"""
    # No instruction after the store is left out, or executed twice.
    COUNTED = """map(); install();
uint32_t count = 0;
__asm__ volatile("cpsie a\\nstr %0, [%1]\\n.rept 800\\nadd %0, #1\\n.endr"
                 : "+r"(count) : "r"(ADDRESS) : "r0", "memory");
R32(count == 800 ? 0xC0000100 : 0xC0000200) = 6;"""

    def test_a_refused_posted_write_is_an_asynchronous_abort(self):
        """DFSR: asynchronous external, a write, SLVERR or DECERR."""
        self.recorders()
        for address, status in (0xC0204000, 0x1C06), (0xC0206000, 0x0C06):
            self.program(self.COUNTED.replace("ADDRESS", hex(address)), HEAD + self.VECTORS)
            done = self.played("delay: 5ms")
            lines = [line for line in done.stdout.splitlines() if line[0] == "W"]
            self.assertEqual([line[4:16] for line in lines],
                             [f"02a {address - 0xC0000000:08x}", f"002 {status:08x}",
                              "002 00000100"], done.stderr)

    def test_a_refused_posted_write_is_said_where_aborts_are_masked(self):
        self.recorders()
        self.program("map(); R32(0xC0204000) = 1; R32(0xC0000100) = 6;", HEAD)
        done = self.played("delay: 5ms")
        self.assertIn("the design answered the posted write to 0xC0204000 with an error: BRESP "
                      "SLVERR; the processor masks asynchronous aborts (CPSR.A), and goes on",
                      done.stderr)
        self.assertIn(" 00000100 ", done.stdout)

    def test_a_posted_write_without_an_answer(self):
        """The program goes on until it needs the bridge."""
        self.recorders(slave=LATE, wrong=0x7F8)
        missing = "bvalid with ID 0x02A: the design answers with ID 0x7D2"
        self.program("map(); R32(0xC0200000) = 1;", HEAD)
        self.assertIn("the posted write to 0xC0200000 is not answered: its bridge waits for " +
                      missing, self.played("delay: 30ms").stderr)
        self.program("map(); R32(0xC0200000) = 1; (void)R32(0xFF200000);", HEAD)
        self.assertIn("read of 4 bytes at 0xFF200000 (the design did not answer: its bridge waits "
                      f"for {missing}, of the posted write to 0xC0200000)",
                      self.played("delay: 30ms", code=1).stderr)

    def test_an_error_is_an_abort(self):
        self.recorders()
        for access, what in (("R32(0xC0004000) = 1;", "BRESP SLVERR"),
                             ("(void)R32(0xFF206000);", "RRESP DECERR"),
                             ('AT(0xC0106000, "ldm r0, {r1-r4}")', "RRESP DECERR")):
            done = self.bursts(access, code=1)
            self.assertIn(f"the design answered with an error: {what}", done.stderr)

    def test_a_slave_of_single_words_hangs_at_a_burst(self):
        for last, access, what in (
                (0, "stm r0, {r1-r2}", "write of 8 bytes at 0xC0100000 (the design did not answer: "
                 "its bridge waits for wready of word 2 of a burst of 2)"),
                (1, 'str r1, [r0]") map(); R32(0xC0100000) = 1; AT(0xC0100000, "stm r0, {r1-r8}',
                 "its bridge waits for bvalid after the last word: it came at the time of word 2 "
                 "of a burst of 4"),
                (1, "ldm r0, {r1-r4}", "read of 16 bytes at 0xC0100000 (the design did not answer: "
                 "its bridge waits for rvalid of word 2 of a burst of 4: rlast came with the one "
                 "before)"),
                (0, "ldm r0, {r1-r4}", "its bridge waits for rvalid of word 2 of a burst of 4)"),
                (0, "ldr r1, [r0]", "its bridge waits for rlast with the last word)")):
            self.recorders(slave=SINGLE, last=last)
            self.program(f'AT(0xC0100000, "{access}")', HEAD)
            posted = "map()" in access  # and nothing waits for it
            self.assertIn(what, self.played("delay: 30ms", code=int(not posted)).stderr)


run()
