"""hps_peripherals_test.py DE1SIM FOLDER [CASE...] - the processor's peripherals in the FPGA

By the device's primitives, and by Platform Designer where a peripheral's pins are "FPGA".
"""
from case import run
from hps_case import CHECK, PeripheralCase

UART = CHECK + """#define UART(base, n) R32(base + (n))
enum { RBR = 0, IER = 4, FCR = 8, LCR = 0xC, MCR = 0x10, LSR = 0x14, MSR = 0x18 };
#define U0 0xFFC02000
#define U1 0xFFC03000
static void begin(uint32_t base, uint32_t divisor, uint32_t format) {
    UART(base, LCR) = format | 0x80; UART(base, RBR) = divisor & 0xFF;
    UART(base, IER) = divisor >> 8; UART(base, LCR) = format; UART(base, FCR) = 7;
}
static void put(uint32_t base, uint32_t c) {
    while (!(UART(base, LSR) & 0x20)) {}
    UART(base, RBR) = c;
}
static uint32_t got(uint32_t base) {            // the errors above the character
    uint32_t status;
    while (!((status = UART(base, LSR)) & 1)) {}
    return (status & 0x1E) << 7 | UART(base, RBR);
}
"""
LOOP = """wire line;
cyclonev_hps_interface_peripheral_uart uart1(.txd(line), .rxd({}){});
assign LEDR = gpo;
"""


class Uart(PeripheralCase):
    def test_a_loop_in_the_design(self):
        self.top(LOOP.format("line", ""))
        self.program("begin(U1, 2, 3);\n"
                     "for (uint32_t c = 0; c < 256; c++) { put(U1, c); CHECK(1, got(U1) == c) }\n"
                     "GPO = 0x155;", UART)
        self.shows(0x155)

    def test_a_bit_has_the_time_of_the_baud_rate(self):
        """115,200 baud by a divisor of 54: 16 * 54 clocks of 100 MHz, 432 of the design's."""
        self.top("""wire line; reg was = 1; reg [15:0] low = 0;
cyclonev_hps_interface_peripheral_uart uart1(.txd(line), .rxd(1'b1));
always @(posedge CLOCK_50) begin was <= line; if (!line) low <= low + 1'b1; end
assign LEDR = gpo;""", gpi="{16'd0, low}")
        self.program("begin(U1, 54, 3);\nput(U1, 0xFF);\nwhile (!(UART(U1, LSR) & 0x40)) {}\n"
                     "GPO = GPI;", UART)
        self.shows(432)

    def test_frames_of_other_formats(self):
        """Seven bits with even parity and two stop bits; five with odd parity."""
        self.top(LOOP.format("line", ""))
        self.program("begin(U1, 4, 0x1E);\n"
                     "put(U1, 0x155); CHECK(1, got(U1) == 0x55)\n"
                     "put(U1, 0x2A); CHECK(2, got(U1) == 0x2A)\n"
                     "begin(U1, 4, 0x0C);\nput(U1, 0xF5); CHECK(3, got(U1) == 0x15)\n"
                     "GPO = 0x155;", UART)
        self.shows(0x155)

    def test_what_is_wrong_with_a_frame_is_told(self):
        """The design inverts the parity bit, and the stop bit; then there is a break."""
        self.top("""wire line; reg was = 1, runs = 0; reg [15:0] at = 0;
wire in_parity = at >= 9 * 80 && at < 10 * 80, in_stop = at >= 10 * 80 && at < 11 * 80;
cyclonev_hps_interface_peripheral_uart uart1(.txd(line),
    .rxd(runs ? line ^ (gpo[16] & in_parity) ^ (gpo[17] & in_stop) : line));
always @(posedge CLOCK_50) begin
    was <= line;
    at <= at + 1'b1;
    if (!runs && was && !line) begin runs <= 1; at <= 0; end
    else if (at == 11 * 80 - 20) runs <= 0;
end
assign LEDR = gpo;""")
        self.program("begin(U1, 10, 0x0B);\n"
                     "put(U1, 0x41); CHECK(1, got(U1) == 0x41)\n"
                     "while (!(UART(U1, LSR) & 0x40)) {}\n"
                     "GPO = 0x10000; put(U1, 0x42); CHECK(2, got(U1) == (4 << 7 | 0x42))\n"
                     "while (!(UART(U1, LSR) & 0x40)) {}\n"
                     "GPO = 0x20000; put(U1, 0x43); CHECK(3, got(U1) == (8 << 7 | 0x43))\n"
                     "while (!(UART(U1, LSR) & 0x40)) {}\n"
                     "GPO = 0; UART(U1, LCR) = 0x4B;\n"
                     "CHECK(4, (got(U1) & ~(4 << 7)) == 0x18 << 7)\n"
                     "UART(U1, LCR) = 0x0B; put(U1, 0x44); CHECK(5, got(U1) == 0x44)\n"
                     "GPO = 0x155;", UART)
        self.shows(0x155)

    def test_signals_of_the_modem(self):
        """MCR's outputs and MSR's inputs are active where the wires are low."""
        self.top("""wire dtr, rts, out1, out2;
cyclonev_hps_interface_peripheral_uart uart1(.rxd(1'b1), .dtr(dtr), .rts(rts), .out1_n(out1),
    .out2_n(out2), .cts(rts), .dsr(dtr), .ri(out1), .dcd(out2));
assign LEDR = gpo;""")
        self.program("UART(U1, MCR) = 0; (void)UART(U1, MSR); CHECK(1, UART(U1, MSR) == 0)\n"
                     "UART(U1, MCR) = 2; CHECK(2, UART(U1, MSR) == 0x11)\n"
                     "UART(U1, MCR) = 1; CHECK(3, UART(U1, MSR) == 0x23)\n"
                     "UART(U1, MCR) = 4; CHECK(4, UART(U1, MSR) == 0x42)\n"
                     "UART(U1, MCR) = 8; CHECK(5, UART(U1, MSR) == 0x8C)\n"
                     "CHECK(6, UART(U1, MSR) == 0x80)\nGPO = 0x155;", UART)
        self.shows(0x155)

    def test_a_character_from_the_design_interrupts(self):
        self.top(LOOP.format("line", ""))
        self.program("begin(U1, 10, 3); UART(U1, IER) = 1;\nR32(0xFFFED100 + 6 * 4) = 1 << 3;\n"
                     "CHECK(1, !(R32(0xFFFED200 + 6 * 4) & 1 << 3))\nput(U1, 0x35);\n"
                     "while (!(R32(0xFFFED200 + 6 * 4) & 1 << 3)) {}\n"
                     "CHECK(2, (UART(U1, FCR) & 0xF) == 4)\nGPO = UART(U1, RBR);", UART)
        self.shows(0x35)

    def test_uart0_of_a_system_is_no_console(self):
        self.system([("uart", "hps_0.uart0")], "wire line;",
                    ", .uart_txd(line), .uart_rxd(line), .uart_cts(1'b0), .uart_dsr(1'b0),\n"
                    "    .uart_dcd(1'b0), .uart_ri(1'b0), .uart_dtr(), .uart_rts(),\n"
                    "    .uart_out1_n(), .uart_out2_n()", UART0_PinMuxing="FPGA",
                    UART0_Mode="Full")
        self.program("put(U0, 'h'); GPO = got(U0);", UART)
        done = self.shows(ord("h"))
        self.assertIn("UART0 is routed to the FPGA: the board's serial port by USB is not "
                      "connected", done.stderr)
        self.assertEqual((self.folder / "out/console.txt").read_text(), "")

    def test_a_place_in_the_settings_says_which_it_is(self):
        self.top(LOOP.format("line", "").replace("uart1", "uart"))
        with open(self.folder / "top.qsf", "a", encoding="ascii") as file:
            file.write("set_instance_assignment -name HPS_LOCATION "
                       "HPSINTERFACEPERIPHERALUART_X52_Y67_N111 -entity top -to uart\n")
        self.program("begin(U1, 2, 3); put(U1, 0x5A); GPO = got(U1);", UART)
        self.shows(0x5A)

    def test_two_of_the_same_number_are_named(self):
        self.top("cyclonev_hps_interface_peripheral_uart one(.rxd(1'b1)), two(.rxd(1'b1));\n"
                 "assign LEDR = gpo;")
        self.program("")
        done = self.played("delay: 1ms", code=1)
        self.assertIn("two: number 0 of its kind is in the design already: expected instances "
                      "whose names end with different numbers, from 0 to 1", done.stderr)


I2C = CHECK + """#define I2C(n) R32(0xFFC05000 + (n))
enum { CON = 0, TAR = 4, DATA = 0x10, HIGH = 0x1C, LOW = 0x20, RAW = 0x34, EN = 0x6C, STAT = 0x70,
       RX = 0x78, ABRT = 0x80, EN_STAT = 0x9C };
static void begin(uint32_t address) {
    I2C(EN) = 0; I2C(CON) = 0x65; I2C(TAR) = address; I2C(HIGH) = 60; I2C(LOW) = 130; I2C(EN) = 1;
}
static uint32_t get(void) { while (!I2C(RX)) {} return I2C(DATA); }
static void rest(void) { while (I2C(STAT) & 0x21) {} }
"""
# A memory of 256 bytes at 0x50, which holds SCL low for `hold` clocks after each byte.
SLAVE = """
module slave(input clk, input scl, input sda, input [9:0] hold, output reg scl_low,
             output reg sda_low);
    reg [7:0] bytes [0:255], shift = 0, at = 0;
    reg [3:0] n = 0;      // rises of SCL in the byte
    reg [1:0] phase = 0;  // address, pointer, bytes to it, bytes from it
    reg [9:0] held = 0;
    reg was_scl = 1, was_sda = 1, on = 0, nack = 0;
    wire [7:0] next = at + 1'b1;
    initial {scl_low, sda_low} = 0;
    always @(posedge clk) begin
        was_scl <= scl; was_sda <= sda;
        if (held != 0) held <= held - 1'b1; else scl_low <= 0;
        if (scl && was_scl && was_sda != sda) begin
            on <= was_sda; n <= 0; phase <= 0; sda_low <= 0;
        end else if (on && !was_scl && scl) begin
            n <= n + 1'b1;
            if (n < 8) shift <= {shift[6:0], sda}; else nack <= sda;
        end else if (on && was_scl && !scl && n == 8) begin
            sda_low <= phase != 3;
            if (phase == 0 && shift[7:1] != 7'h50) begin on <= 0; sda_low <= 0; end
            if (phase == 1) at <= shift;
            if (phase == 2) begin bytes[at] <= shift; at <= next; end
        end else if (on && was_scl && !scl && n == 9) begin
            n <= 0; sda_low <= 0;
            if (phase == 0) phase <= shift[0] ? 3 : 1;
            if (phase == 1) phase <= 2;
            if (phase == 0 && shift[0]) sda_low <= !bytes[at][7];
            if (phase == 3) begin
                at <= next;
                if (nack) on <= 0; else sda_low <= !bytes[next][7];
            end
            if (hold != 0) begin scl_low <= 1; held <= hold; end
        end else if (on && was_scl && !scl && phase == 3 && n != 0) sda_low <= !bytes[at][7 - n];
    end
endmodule
"""
BUS = """wire scl_low, sda_low, slave_scl_low, slave_sda_low;
wire scl = !(scl_low || slave_scl_low), sda = !(sda_low || slave_sda_low);
{}
slave memory(CLOCK_50, scl, sda, {{SW[9:1], 1'b0}}, slave_scl_low, slave_sda_low);
"""
PRIMITIVE = """cyclonev_hps_interface_peripheral_i2c i2c1(.scl(scl), .sda(sda), .out_clk(scl_low),
    .out_data(sda_low));
assign LEDR = gpo;
"""


class I2c(PeripheralCase):
    # A pointer and three bytes; the pointer again, and after a repeated START the bytes.
    COPY = """begin(0x50);
I2C(DATA) = 7; I2C(DATA) = 0x5A; I2C(DATA) = 0xA5; I2C(DATA) = 0x210; rest();
CHECK(1, I2C(ABRT) == 0)
I2C(DATA) = 7; I2C(DATA) = 0x500; I2C(DATA) = 0x100; I2C(DATA) = 0x300;
CHECK(2, get() == 0x5A) CHECK(3, get() == 0xA5) CHECK(4, get() == 0x10)
rest(); CHECK(5, I2C(ABRT) == 0)
GPO = 0x155;"""

    def bus(self, more="", bus=PRIMITIVE):
        self.top(BUS.format(bus) + more)
        with open(self.folder / "top.v", "a", encoding="ascii") as file:
            file.write(SLAVE)

    def test_a_slave_in_the_design(self):
        self.bus()
        self.program(self.COPY, I2C)
        self.shows(0x155)

    def test_a_slave_that_holds_the_clock(self):
        self.bus()
        self.program(self.COPY, I2C)
        self.shows(0x155, ["hold: {switch: [9, 8, 1]}"])

    def test_nobody_at_the_address_and_then_somebody(self):
        self.bus()
        self.program("begin(0x51); I2C(DATA) = 0x201;\nwhile (!(I2C(RAW) & 0x40)) {}\n"
                     "CHECK(6, I2C(ABRT) == 1) rest(); (void)I2C(0x54);\n" + self.COPY, I2C)
        self.shows(0x155)

    def test_pins_of_a_header_with_their_pull_ups(self):
        self.bus(bus="""assign GPIO_0[0] = scl_low ? 1'b0 : 1'bz, GPIO_0[1] = sda_low ? 1'b0 : 1'bz;
assign GPIO_0[0] = slave_scl_low ? 1'b0 : 1'bz, GPIO_0[1] = slave_sda_low ? 1'b0 : 1'bz;
cyclonev_hps_interface_peripheral_i2c i2c1(.scl(GPIO_0[0]), .sda(GPIO_0[1]), .out_clk(scl_low),
    .out_data(sda_low));
assign LEDR = gpo;
""")
        self.program(self.COPY, I2C)
        self.shows(0x155)

    def test_another_that_holds_sda_low_takes_the_bus(self):
        self.top("wire scl_low, sda_low;\n"
                 "cyclonev_hps_interface_peripheral_i2c i2c1(.scl(!scl_low), .sda(1'b0),\n"
                 "    .out_clk(scl_low), .out_data(sda_low));\nassign LEDR = gpo;")
        self.program("begin(0x50); I2C(DATA) = 0x201;\nwhile (!(I2C(RAW) & 0x40)) {}\n"
                     "CHECK(1, I2C(ABRT) == 1 << 12)\nGPO = 0x155;", I2C)
        self.shows(0x155)

    def test_the_clock_has_the_time_that_is_set(self):
        """60 + spike 2 + 7 high, 130 + 1 low: 2 us, of which 1.31 us are low: 65 clocks."""
        self.bus("""reg was = 1; reg [9:0] time_ = 0, low = 0;
always @(posedge CLOCK_50) begin
    was <= scl; time_ <= scl != was ? 10'd1 : time_ + 1'b1;
    if (scl && !was) low <= time_;
end""")
        with open(self.folder / "top.v", encoding="ascii") as file:
            text = file.read().replace(".gp_in(32'd0)", ".gp_in({22'd0, low})")
        self.write(top_v=text)
        self.program("begin(0x50); I2C(DATA) = 1; I2C(DATA) = 0x202; rest();\n"
                     "GPO = GPI >= 65 && GPI <= 66;", I2C)
        self.shows(1)

    def test_platform_designer_exports_the_bus(self):
        self.system([("bus", "hps_0.i2c1"), ("scl_in", "hps_0.i2c1_scl_in"),
                     ("scl_out", "hps_0.i2c1_clk")], BUS.format(""),
                    ", .bus_out_data(sda_low), .bus_sda(sda), .scl_in_clk(scl),\n"
                    "    .scl_out_clk(scl_low)", I2C1_PinMuxing="FPGA", I2C1_Mode="Full")
        with open(self.folder / "top.v", "a", encoding="ascii") as file:
            file.write(SLAVE)
        self.program(self.COPY, I2C)
        self.shows(0x155)


SPI = CHECK + """#define SPI(base, n) R32(base + (n))
#define M0 0xFFF00000
#define S0 0xFFE02000
enum { CTRL = 0, COUNT = 4, EN = 8, SLAVES = 0x10, BAUD = 0x14, RX = 0x24, STAT = 0x28,
       DATA = 0x60 };
static void begin(uint32_t base, uint32_t control) {
    SPI(base, EN) = 0; SPI(base, CTRL) = control; SPI(base, BAUD) = 20; SPI(base, SLAVES) = 1;
    SPI(base, EN) = 1;
}
static uint32_t get(uint32_t base) { while (!SPI(base, RX)) {} return SPI(base, DATA); }
"""
# The last eight bits that came go back; `edges` counts the clock's, `frames` the selections.
SHIFTER = """wire mosi, sck, ss; reg miso = 0;
reg [7:0] shift = 8'h81, frames = 0, edges = 0; reg was_sck = 0, was_ss = 1;
wire second = gpo[16], high = gpo[17];
wire first_edge = was_sck != sck && sck != high, second_edge = was_sck != sck && sck == high;
wire takes = second ? second_edge : first_edge, moves = second ? first_edge : second_edge;
{}
always @(posedge CLOCK_50) begin
    was_sck <= sck; was_ss <= ss;
    if (was_ss && !ss) begin frames <= frames + 1'b1; if (!second) miso <= shift[7]; end
    if (!ss && !was_ss) begin
        if (was_sck != sck) edges <= edges + 1'b1;
        if (takes) shift <= {{shift[6:0], mosi}};
        if (moves) miso <= shift[7];
    end
end
"""
MASTER = """cyclonev_hps_interface_peripheral_spi_master spim0(.txd(mosi), .rxd(miso),
    .ss_in_n(1'b1), .ss_0_n(ss), .sclk_out(sck));
assign LEDR = gpo;"""


class Spi(PeripheralCase):
    def test_a_shift_register_in_all_four_modes(self):
        """What was sent comes back with the next frame, at 10 MHz."""
        self.top(SHIFTER.format(MASTER), gpi="{16'd0, frames, edges}")
        self.program("""for (uint32_t mode = 0; mode < 4; mode++) {
    GPO = mode << 16;
    begin(M0, 7 | mode << 6);
    SPI(M0, DATA) = 0x3C; (void)get(M0);
    SPI(M0, DATA) = 0xC5; CHECK(1 + mode, get(M0) == 0x3C)
    SPI(M0, DATA) = 0x00; CHECK(5 + mode, get(M0) == 0xC5)
}
CHECK(9, (GPI & 0xFF) == 4 * 3 * 16)
GPO = 0x155;""", SPI)
        self.shows(0x155)

    def test_frames_in_turn_select_again_with_scph_0_alone(self):
        self.top(SHIFTER.format(MASTER), gpi="{16'd0, frames, edges}")
        self.program("""for (uint32_t mode = 0; mode < 2; mode++) {
    const uint32_t before = GPI >> 8;
    GPO = mode << 16;
    begin(M0, 7 | mode << 6);
    SPI(M0, SLAVES) = 0;
    for (uint32_t n = 0; n < 5; n++) SPI(M0, DATA) = n;
    SPI(M0, SLAVES) = 1;
    while (SPI(M0, RX) < 5) {}
    CHECK(1 + mode, (GPI >> 8) - before == (mode ? 1 : 5))
}
GPO = 0x155;""", SPI)
        self.shows(0x155)

    def test_frames_of_sixteen_bits_in_a_loop(self):
        self.top("wire line;\ncyclonev_hps_interface_peripheral_spi_master spim0(.txd(line),\n"
                 "    .rxd(line), .ss_in_n(1'b1));\nassign LEDR = gpo;")
        self.program("begin(M0, 15);\nSPI(M0, DATA) = 0xA5C3; CHECK(1, get(M0) == 0xA5C3)\n"
                     "SPI(M0, DATA) = 0x1234; CHECK(2, get(M0) == 0x1234)\n"
                     "begin(M0, 0x20F); SPI(M0, EN) = 0; SPI(M0, COUNT) = 2; SPI(M0, EN) = 1;\n"
                     "SPI(M0, DATA) = 0x8001; while (SPI(M0, STAT) & 1) {}\n"
                     "CHECK(3, SPI(M0, RX) == 3) CHECK(4, get(M0) == 0x8001)\nGPO = 0x155;", SPI)
        self.shows(0x155)

    def test_a_master_and_a_slave_of_the_processor(self):
        """Each sends what the other gets, through the design."""
        self.top("wire mosi, miso, ss, sck;\n"
                 "cyclonev_hps_interface_peripheral_spi_master spim0(.txd(mosi), .rxd(miso),\n"
                 "    .ss_in_n(1'b1), .ss_0_n(ss), .sclk_out(sck));\n"
                 "cyclonev_hps_interface_peripheral_spi_slave spis0(.rxd(mosi), .txd(miso),\n"
                 "    .ss_in_n(ss), .sclk_in(sck));\nassign LEDR = gpo;")
        self.program("""for (uint32_t mode = 0; mode < 4; mode++) {
    begin(S0, 7 | mode << 6); begin(M0, 7 | mode << 6);
    SPI(S0, DATA) = 0x96; SPI(S0, DATA) = 0x0F;
    SPI(M0, DATA) = 0x5B; CHECK(1, get(M0) == 0x96) CHECK(2, get(S0) == 0x5B)
    SPI(M0, DATA) = 0xA1; CHECK(3, get(M0) == 0x0F) CHECK(4, get(S0) == 0xA1)
    SPI(M0, DATA) = 0x77; CHECK(5, get(M0) == 0x00) CHECK(6, get(S0) == 0x77)
}
GPO = 0x155;""", SPI)
        self.shows(0x155)

    def test_platform_designer_exports_a_master(self):
        self.system([("spi", "hps_0.spim0"), ("sclk", "hps_0.spim0_sclk_out")],
                    SHIFTER.format(""),
                    ", .spi_txd(mosi), .spi_rxd(miso), .spi_ss_in_n(1'b1), .spi_ssi_oe_n(),\n"
                    "    .spi_ss_0_n(ss), .spi_ss_1_n(), .spi_ss_2_n(), .spi_ss_3_n(),\n"
                    "    .sclk_clk(sck)", SPIM0_PinMuxing="FPGA", SPIM0_Mode="Full")
        self.program("begin(M0, 7); SPI(M0, DATA) = 0x3C; (void)get(M0);\n"
                     "SPI(M0, DATA) = 0; GPO = get(M0);", SPI)
        self.shows(0x3C)


class LoanIo(PeripheralCase):
    def test_the_led_and_the_key_of_the_processor(self):
        """The design lights HPS_LED while HPS_KEY is pressed, which it reads."""
        self.top("""wire [70:0] in;
cyclonev_hps_interface_loan_io loan(.loanio_in(in), .loanio_out({70'd0, !in[54]} << 53),
    .loanio_oe(71'd1 << 53));
assign LEDR = {9'd0, in[54]};""")
        self.program("")
        self.played("delay: 1ms", "expect-leds: {equals: \"0000000001\"}",
                    "hold: {key: hps}", "delay: 1ms", "expect-leds: {equals: \"0000000000\"}")
        self.assertTrue(self.report())

    def test_the_program_sees_what_the_design_drives(self):
        self.system([("loan", "hps_0.h2f_loan_io")],
                    "wire [66:0] in, out = {66'd0, SW[0]} << 53, oe = 67'd3 << 53;",
                    ", .loan_in(in), .loan_out(out), .loan_oe(oe)",
                    LOANIO_Enable=",".join(["No"] * 53 + ["Yes"] + ["No"] * 47))
        self.program("for (;;) R32(0xFF706010) = R32(0xFF709050) >> 24 & 3;")
        self.shows(3, ["hold: {switch: [0]}"])
        self.shows(2)


run()
