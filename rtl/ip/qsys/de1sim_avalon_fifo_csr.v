// de1sim_avalon_fifo_csr.v - the control slave of Platform Designer's FIFO, on one of its sides
//
//   0 fill_level
//   1 i_status         FULL bit 0, EMPTY 1, ALMOSTFULL 2, ALMOSTEMPTY 3, OVERFLOW 4, UNDERFLOW 5
//   2 event            the same, each since it began; a write of 1 clears it
//   3 interruptenable  the same: the event interrupts
//   4 almostfull       from 1 to HIGHEST, which it is after a reset; a value beyond is the nearest
//   5 almostempty      the same, 1 after a reset
//
// Source: Embedded Peripherals IP User Guide, Avalon FIFO Memory Core, and the Verilog that it
// generates.

`default_nettype none

module de1sim_avalon_fifo_csr #(
    parameter LEVEL_BITS = 9,
    parameter HIGHEST    = 252
) (
    input  wire                  clk_i,
    input  wire                  rst_ni,
    input  wire [LEVEL_BITS-1:0] level_i,
    input  wire                  full_i, empty_i,
    input  wire                  overflow_i, underflow_i,

    input  wire [2:0]            address_i,
    input  wire                  read_i,
    input  wire                  write_i,
    input  wire [31:0]           writedata_i,
    output reg  [31:0]           readdata_o,
    output wire                  irq_o
);
    reg [31:0] almost_full_q, almost_empty_q;
    reg [5:0]  events_q, enabled_q;
    reg [3:0]  was_not_q;

    wire [31:0] level  = {{(32-LEVEL_BITS){1'b0}}, level_i};
    wire [5:0]  status = {underflow_i, overflow_i, level <= almost_empty_q, level >= almost_full_q,
                          empty_i, full_i};
    wire [5:0]  begins = {status[5:4], status[3:0] & was_not_q};
    wire [5:0]  clears = write_i && address_i == 3'd2 ? writedata_i[5:0] : 6'd0;
    wire [31:0] threshold = writedata_i == 32'd0 ? 32'd1 : writedata_i > HIGHEST ? HIGHEST
                            : writedata_i;

    assign irq_o = (events_q & enabled_q) != 6'd0;

    always @(posedge clk_i) begin
        if (!rst_ni) begin
            almost_full_q  <= HIGHEST;
            almost_empty_q <= 32'd1;
            {events_q, enabled_q, was_not_q} <= 16'd0;
            readdata_o <= 32'd0;
        end else begin
            was_not_q <= ~status[3:0];
            events_q  <= (events_q | begins) & ~clears;
            if (write_i && address_i == 3'd3) enabled_q <= writedata_i[5:0];
            if (write_i && address_i == 3'd4) almost_full_q <= threshold;
            if (write_i && address_i == 3'd5) almost_empty_q <= threshold;
            if (read_i)
                case (address_i)
                    3'd0:    readdata_o <= level;
                    3'd1:    readdata_o <= {26'd0, status};
                    3'd2:    readdata_o <= {26'd0, events_q};
                    3'd3:    readdata_o <= {26'd0, enabled_q};
                    3'd4:    readdata_o <= almost_full_q;
                    3'd5:    readdata_o <= almost_empty_q;
                    default: readdata_o <= 32'd0;
                endcase
        end
    end
endmodule

`default_nettype wire
