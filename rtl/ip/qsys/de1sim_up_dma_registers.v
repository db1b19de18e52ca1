// de1sim_up_dma_registers.v - the registers of the University Program's video DMA controllers
//
//   +0 buffer       reads the address of the picture that is read or written; a write exchanges it
//                   with backbuffer at the begin of the next picture
//   +4 backbuffer
//   +8 resolution   31:16 lines, 15:0 pixels of a line
//   +C status       S bit 0: an exchange is due; A bit 1: consecutive addresses; EN bit 2; B 7:4
//                   bytes of a pixel; n 23:16, m 31:24: bits of x and of y
//
// Source: Intel FPGA University Program, Video Cores for DE-Series Boards.

`default_nettype none

module de1sim_up_dma_registers #(
    parameter WIDTH       = 640,
    parameter HEIGHT      = 480,
    parameter BYTES       = 2,     // of a pixel
    parameter CONSECUTIVE = 0,
    parameter X_BITS      = 10,
    parameter Y_BITS      = 9,
    parameter START       = 0,
    parameter BACK        = 0,
    parameter ENABLED     = 1
) (
    input  wire        clk,
    input  wire        reset,
    input  wire [1:0]  slave_address,
    input  wire [3:0]  slave_byteenable,
    input  wire        slave_write,
    input  wire [31:0] slave_writedata,
    output wire [31:0] slave_readdata,

    input  wire        picture_i,  // a picture ends, or begins: the exchange takes place
    output reg  [31:0] buffer_o,
    output reg         enabled_o
);
    reg [31:0] back_q;
    reg        swap_q;

    assign slave_readdata = slave_address == 2'd0 ? buffer_o
                          : slave_address == 2'd1 ? back_q
                          : slave_address == 2'd2 ? {HEIGHT[15:0], WIDTH[15:0]}
                          : {Y_BITS[7:0], X_BITS[7:0], 8'd0, BYTES[3:0], 1'b0, enabled_o,
                             CONSECUTIVE != 0, swap_q};

    integer i;
    always @(posedge clk) begin
        if (picture_i && swap_q) begin
            swap_q   <= 1'b0;
            buffer_o <= back_q;
            back_q   <= buffer_o;
        end
        if (slave_write && slave_address == 2'd0) swap_q <= 1'b1;
        for (i = 0; i < 4; i = i + 1)
            if (slave_write && slave_address == 2'd1 && slave_byteenable[i])
                back_q[8*i +: 8] <= slave_writedata[8*i +: 8];
        if (slave_write && slave_address == 2'd3 && slave_byteenable[0])
            enabled_o <= slave_writedata[2];
        if (reset) begin
            buffer_o  <= START;
            back_q    <= BACK;
            swap_q    <= 1'b0;
            enabled_o <= ENABLED != 0;
        end
    end
endmodule

`default_nettype wire
