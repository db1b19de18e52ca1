// open_jtag.v - replaces the JTAG primitive in tools without it: a terminal that nobody reads
//
// The parameters are ignored.

`default_nettype none
// verilator lint_off DECLFILENAME
// verilator lint_off UNUSED

module alt_jtag_atlantic #(
    parameter INSTANCE_ID = 0, LOG2_RXFIFO_DEPTH = 0, LOG2_TXFIFO_DEPTH = 0,
              SLD_AUTO_INSTANCE_INDEX = ""
) (
    input  wire       clk,
    input  wire       rst_n,
    input  wire [7:0] r_dat,
    input  wire       r_val,
    output wire       r_ena,
    output wire [7:0] t_dat,
    input  wire       t_dav,
    output wire       t_ena,
    output wire       t_pause
);
    assign r_ena   = 1'b0;
    assign t_dat   = 8'd0;
    assign t_ena   = 1'b0;
    assign t_pause = 1'b0;
endmodule

`default_nettype wire
