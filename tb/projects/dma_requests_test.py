"""dma_requests_test.py DE1SIM FOLDER [CASE...] - requests of a design to the DMA controller"""
from case import run
from hps_case import CHECK, PeripheralCase

DMA = CHECK + """static uint8_t code[64] __attribute__((aligned(4)));
static uint32_t to[64];
static uint32_t put(uint32_t n, uint32_t bytes, uint32_t low, uint32_t high) {
    for (uint32_t i = 0; i < bytes; i++) code[n + i] = (i < 4 ? low >> 8 * i : high >> 8 * (i - 4));
    return n + bytes;
}
static uint32_t move(uint32_t n, uint32_t where, uint32_t value) {
    return put(n, 6, 0xBC | where << 8 | value << 16, value >> 16);
}
static void start(void) {
    while (R32(0xFFE01D00) & 1) {}
    R32(0xFFE01D08) = 0xA0 << 16; R32(0xFFE01D0C) = (uint32_t)code; R32(0xFFE01D04) = 0;
}
static uint32_t state(void) { return R32(0xFFE01100); }
"""
# A word each time that there is a request, by the lightweight bridge; ACKs are counted.
SOURCE = """wire [20:0] araddr; wire arvalid; wire [11:0] arid; wire rready; wire ack;
reg rvalid = 0; reg [11:0] rid = 0; reg [7:0] left = 0; reg [31:0] value = 32'h100;
reg [7:0] acks = 0; reg was_ack = 0, ask = 0; reg [3:0] wait_ = 0;
wire [3:0] arlen;
wire rlast = left == 1;
cyclonev_hps_interface_hps2fpga_light_weight lw(.clk(CLOCK_50), .awready(1'b1), .wready(1'b1),
    .bid(12'd0), .bresp(2'd0), .bvalid(1'b0), .araddr(araddr), .arvalid(arvalid), .arlen(arlen),
    .arready(left == 0), .arid(arid), .rid(rid), .rdata(value), .rresp(2'd0), .rlast(rlast),
    .rvalid(left != 0), .rready(rready));
cyclonev_hps_interface_dma dma(.channel3_{}(ask), .channel3_xx_ack(ack));
always @(posedge CLOCK_50) begin
    was_ack <= ack;
    if (!was_ack && ack) acks <= acks + 1'b1;
    wait_ <= ack ? 4'd0 : wait_ + (wait_ != 15);
    ask <= gpo[16] && !ack && wait_ == 15;
    if (arvalid && left == 0) begin left <= arlen + 1'b1; rid <= arid; end
    if (left != 0) begin left <= left - 1'b1; value <= value + 1'b1; end
end
assign LEDR = gpo;"""


class DmaRequests(PeripheralCase):
    # Five times: DMAWFP, DMALDP, DMAST with words that rise; DMASEV 0 and DMAEND.
    PROGRAM = """uint32_t n = 0, loop;
n = move(n, 0, 0xFF200000); n = move(n, 1, {control}); n = move(n, 2, (uint32_t)to);
n = put(n, 2, 0x20 | 4 << 8, 0); loop = n;
n = put(n, 2, {wait} | 3 << 11, 0); n = put(n, 2, {load} | 3 << 11, 0); n = put(n, 1, {store}, 0);
n = put(n, 2, {end} | (n - loop) << 8, 0); n = put(n, 1, 0, 0);
start();
for (volatile uint32_t i = 0; i < 1000; i++) {{}}
CHECK(1, (state() & 0xF) == 7) CHECK(2, (GPI & 0xFF) == 0)
GPO = 0x10000;
while (state() & 0xF) {{}}
for (volatile uint32_t i = 0; i < 1000; i++) {{}}
CHECK(3, (GPI & 0xFF) == 5)
for (n = 0; n < 5 * {beats}; n++) CHECK(4, to[n] == 0x100 + n)
CHECK(5, to[5 * {beats}] == 0)
GPO = 0x155;"""

    def transfers(self, signal, **program):
        self.top(SOURCE.format(signal), gpi="{24'd0, acks}")
        self.program(self.PROGRAM.format(**program), DMA)
        self.shows(0x155)

    def test_single_transfers(self):
        """Of one word, whatever the control register says, by DMAWFPS, DMALDPS, DMASTS."""
        self.transfers("single", control="0xD4034", wait="0x30", load="0x25",
                       store="0x09", end="0x38", beats=1)

    def test_bursts(self):
        self.transfers("req", control="0xD4034", wait="0x32", load="0x27",
                       store="0x0B", end="0x38", beats=4)

    def test_of_the_kind_that_the_peripheral_asks_for(self):
        self.transfers("req", control="0xD4034", wait="0x31", load="0x27",
                       store="0x0B", end="0x38", beats=4)


run()
