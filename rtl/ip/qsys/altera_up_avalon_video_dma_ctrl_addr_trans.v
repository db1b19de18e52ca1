// altera_up_avalon_video_dma_ctrl_addr_trans.v - the University Program's translation of addresses
// for a pixel buffer: the processor's addresses of a picture have the bits of MASK, the buffer's
// have not
//
// Source: Intel FPGA University Program, Video Cores for DE-Series Boards.

`default_nettype none

module altera_up_avalon_video_dma_ctrl_addr_trans #(
    parameter ADDRESS_TRANSLATION_MASK = 32'hC0000000
) (
    // verilator lint_off UNUSED
    input  wire        clk,
    input  wire        reset,
    // verilator lint_on UNUSED

    input  wire [1:0]  slave_address,
    input  wire [3:0]  slave_byteenable,
    input  wire        slave_read,
    input  wire        slave_write,
    output wire [31:0] slave_readdata,
    input  wire [31:0] slave_writedata,
    output wire        slave_waitrequest,

    input  wire [31:0] master_readdata,
    input  wire        master_waitrequest,
    output wire [31:0] master_address,
    output wire [3:0]  master_byteenable,
    output wire        master_read,
    output wire        master_write,
    output wire [31:0] master_writedata
);
    wire is_address = !slave_address[1];     // of the buffer, of the back buffer

    assign master_address    = {28'd0, slave_address, 2'b00};
    assign master_byteenable = slave_byteenable;
    assign master_read       = slave_read;
    assign master_write      = slave_write;
    assign master_writedata  = is_address ? slave_writedata & ~ADDRESS_TRANSLATION_MASK
                                          : slave_writedata;
    assign slave_readdata    = is_address ? master_readdata | ADDRESS_TRANSLATION_MASK
                                          : master_readdata;
    assign slave_waitrequest = master_waitrequest;
endmodule

`default_nettype wire
