// pixel_registers.v - the pixel buffer controller's registers, and the swap
//
//   BUFFER write (any value)   S = 1
//   frame_end_i while S = 1    BUFFER and BACK_BUFFER change places, S = 0
//
// A direct write never loads BUFFER.  STATUS.EN = 0 blanks the screen; the rest of STATUS is fixed.

`default_nettype none

module pixel_registers (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        we_i,
    input  wire [3:0]  wstrb_i,
    // Only the register's place in the block counts.
    // verilator lint_off UNUSED
    input  wire [11:0] waddr_i,
    input  wire [11:0] raddr_i,
    // verilator lint_on UNUSED
    input  wire [31:0] wdata_i,
    input  wire        re_i,
    input  wire        resampler_re_i,
    output reg  [31:0] rdata_o,

    input  wire        frame_end_i,   // the last line has been fetched
    output reg  [31:0] front_o,       // address of the picture on screen
    output reg         enable_o
);
    `include "regmap.vh"
    `include "lanes.vh"

    reg [31:0] back_q;
    reg        swap_q;

    wire swap_now = frame_end_i && swap_q;

    // ---- Writes and the swap ----------------------------------------------
    always @(posedge clk_i) begin
        if (swap_now) begin
            front_o <= back_q;
            back_q  <= front_o;
            swap_q  <= 1'b0;
        end
        if (we_i) case (waddr_i[3:0])
            PIXEL_BUFFER[3:0]:      if (wstrb_i != 4'd0) swap_q <= 1'b1;
            PIXEL_BACK_BUFFER[3:0]: back_q <= merged(swap_now ? front_o : back_q, wdata_i, wstrb_i);
            PIXEL_STATUS[3:0]:      if (wstrb_i[0]) enable_o <= wdata_i[PIXEL_STATUS_EN_LSB];
            default: ;
        endcase
        if (rst_i) begin
            front_o  <= PIXEL_BUFFER_RESET;
            back_q   <= PIXEL_BACK_BUFFER_RESET;
            swap_q   <= 1'b0;
            enable_o <= PIXEL_STATUS_RESET[PIXEL_STATUS_EN_LSB];
        end
    end

    // ---- Reads ------------------------------------------------------------
    always @(posedge clk_i) begin
        rdata_o <= 32'd0;
        if (re_i) case (raddr_i[3:0])
            PIXEL_BUFFER[3:0]:      rdata_o <= front_o;
            PIXEL_BACK_BUFFER[3:0]: rdata_o <= back_q;
            PIXEL_RESOLUTION[3:0]:  rdata_o <= PIXEL_RESOLUTION_RESET;
            default:                rdata_o <= {PIXEL_STATUS_RESET[31:3], enable_o, 1'b0, swap_q};
        endcase
        if (resampler_re_i) rdata_o <= RESAMPLER_STATUS_RESET;
    end
endmodule

`default_nettype wire
