// pixel_registers.v - the registers of the pixel or the character buffer controller, and the swap
//
//   BUFFER write (any value)   S = 1
//   swap_i while S = 1         BUFFER and BACK_BUFFER change places, S = 0
//
// A direct write never loads BUFFER.  A write of BACK_BUFFER in the clock of swap_i wins: S falls,
// and nothing changes places.  STATUS.EN can be written, the rest of STATUS is fixed.  Bits 31:30
// of both addresses read as ones, whatever was written; front_o has what was written, so that a run
// can say that a program shows the processor's own memory.
//
// Source: the DMA controller and the address translation of the DE1-SoC Computer, in Verilog.

`default_nettype none

module pixel_registers #(
    parameter [31:0] BUFFER     = 32'd0,  // after reset, of BACK_BUFFER too
    parameter [31:0] RESOLUTION = 32'd0,
    parameter [31:0] STATUS     = 32'd0
) (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        we_i,
    input  wire [3:0]  wstrb_i,
    // Only the register's offset in the block is used.
    // verilator lint_off UNUSED
    input  wire [11:0] waddr_i,
    input  wire [11:0] raddr_i,
    // verilator lint_on UNUSED
    input  wire [31:0] wdata_i,
    input  wire        re_i,
    input  wire        resampler_re_i,
    output reg  [31:0] rdata_o,

    input  wire        swap_i,        // now a picture ends or begins
    output reg  [31:0] front_o,       // address of the picture
    output reg         enable_o,
    output wire        awake_o
);
    `include "regmap.vh"
    `include "lanes.vh"

    localparam [31:0] TRANSLATED = 32'hc000_0000;

    reg [31:0] back_q;
    reg        swap_q;

    assign awake_o = rdata_o != 32'd0;

    always @(posedge clk_i) begin
        rdata_o <= 32'd0;
        if (re_i) case (raddr_i[3:0])
            PIXEL_BUFFER[3:0]:      rdata_o <= front_o | TRANSLATED;
            PIXEL_BACK_BUFFER[3:0]: rdata_o <= back_q | TRANSLATED;
            PIXEL_RESOLUTION[3:0]:  rdata_o <= RESOLUTION;
            default: begin
                rdata_o                      <= STATUS;
                rdata_o[PIXEL_STATUS_S_LSB]  <= swap_q;
                rdata_o[PIXEL_STATUS_EN_LSB] <= enable_o;
            end
        endcase
        if (resampler_re_i) rdata_o <= RESAMPLER_STATUS_RESET;

        if (we_i && waddr_i[3:0] == PIXEL_BACK_BUFFER[3:0])
            back_q <= merged(back_q, wdata_i, wstrb_i);
        else if (swap_i && swap_q) {front_o, back_q} <= {back_q, front_o};

        if (we_i && waddr_i[3:0] == PIXEL_BUFFER[3:0] && wstrb_i != 4'd0) swap_q <= 1'b1;
        else if (swap_i) swap_q <= 1'b0;
        if (we_i && waddr_i[3:0] == PIXEL_STATUS[3:0] && wstrb_i[0])
            enable_o <= wdata_i[PIXEL_STATUS_EN_LSB];
        if (rst_i) begin
            front_o  <= BUFFER;
            back_q   <= BUFFER;
            swap_q   <= 1'b0;
            enable_o <= STATUS[PIXEL_STATUS_EN_LSB];
        end
    end
endmodule

`default_nettype wire
