// i2c_writer.v - writes one 16-bit word to a slave on I2C
//
//   SCL  ~~~~~~~~|____~~~~|____~~~~|_ ... ____~~~~|____~~~~~~~~
//   SDA  ~~~~|_____< bit  >< bit  >   ... < ack  >___ |___|~~~~
//        | START  |  cell 1 |  2    | ... |   27  |  STOP  |
//
// A cell is four quarters of 2.52 us: SCL is low in the first two and SDA moves between them, which
// keeps all times of the standard at 100 kHz (4.7 us low, 4.0 us high, START, STOP, bus free).
// Cells 9, 18 and 27 are acknowledge bits.  One that stays high ends the word with STOP at once.
//
// Not handled: a slave that stretches the clock, which the board's do not; other masters.

`default_nettype none

module i2c_writer #(
    parameter QUARTER_CYCLES = 63     // 2.52 us at 25 MHz: 99.2 kHz
) (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        start_i,       // taken while !busy_o
    input  wire [6:0]  slave_i,       // its address
    input  wire [15:0] word_i,
    output reg         busy_o,
    output reg         done_o,        // one clock, when busy_o falls
    output reg         nack_o,        // with done_o: a byte was not acknowledged

    output reg         sclk_o,
    output reg         sdat_oe_o,     // 1 = pull SDA low
    input  wire        sdat_i,        // asynchronous

    output wire        awake_o
);
    localparam       WRITE        = 1'b0;
    localparam       RELEASED     = 1'b1;    // SDA in an acknowledge bit
    localparam [4:0] START        = 5'd0;
    localparam [4:0] STOP         = 5'd28;
    localparam       CLOCK_W      = $clog2(QUARTER_CYCLES);
    // The constant fits: the width was computed from it.
    // verilator lint_off WIDTH
    localparam [CLOCK_W-1:0] QUARTER_LAST = QUARTER_CYCLES - 1;
    // verilator lint_on WIDTH

    wire sdat;
    wire sdat_awake;
    sync sdat_sync (.clk_i(clk_i), .async_i(sdat_i), .sync_o(sdat), .awake_o(sdat_awake));

    assign awake_o = busy_o || done_o || sdat_awake;

    reg [CLOCK_W-1:0] clock_q;        // of the quarter
    reg [1:0]  quarter_q;             // of the cell
    reg [4:0]  cell_q;
    reg [26:0] bits_q;                // still to send, and acknowledge bits between them

    wire ack_cell = cell_q == 5'd9 || cell_q == 5'd18 || cell_q == 5'd27;

    always @(posedge clk_i) begin
        done_o <= 1'b0;
        if (!busy_o) begin
            if (start_i) begin
                busy_o    <= 1'b1;
                nack_o    <= 1'b0;
                clock_q   <= 0;
                quarter_q <= 2'd0;
                cell_q    <= START;
                bits_q    <= {slave_i, WRITE, RELEASED,
                              word_i[15:8], RELEASED, word_i[7:0], RELEASED};
            end
        end else if (clock_q != QUARTER_LAST) begin
            clock_q <= clock_q + 1'b1;
        end else begin
            clock_q   <= 0;
            quarter_q <= quarter_q + 2'd1;
            case (quarter_q)
                2'd0:
                    if (cell_q == STOP) sdat_oe_o <= 1'b1;
                    else if (cell_q != START) sdat_oe_o <= !bits_q[26];
                2'd1:
                    if (cell_q == START) sdat_oe_o <= 1'b1;
                    else sclk_o <= 1'b1;
                2'd2:
                    if (ack_cell && sdat) nack_o <= 1'b1;
                default:
                    if (cell_q == STOP) begin
                        sdat_oe_o <= 1'b0;
                        busy_o    <= 1'b0;
                        done_o    <= 1'b1;
                    end else begin
                        sclk_o <= 1'b0;
                        cell_q <= nack_o ? STOP : cell_q + 5'd1;
                        if (cell_q != START) bits_q <= {bits_q[25:0], RELEASED};
                    end
            endcase
        end
        if (rst_i) begin
            busy_o    <= 1'b0;
            done_o    <= 1'b0;
            nack_o    <= 1'b0;
            sclk_o    <= 1'b1;
            sdat_oe_o <= 1'b0;
        end
    end
endmodule

`default_nettype wire
