// de1sim_up_dma.v - pictures from memory as a stream of pixels: the University Program's pixel
// buffer, and its DMA controller from memory to stream
//
// Its registers: de1sim_up_dma_registers.v.
//
// In X-Y mode pixel (x, y) is at buffer + ((y << n) + x) * BYTES.  Up to 120 reads are on their way
// or wait in the FIFO.
//
// Source: Intel FPGA University Program, Video Cores for DE-Series Boards.

`default_nettype none

module de1sim_up_dma #(
    parameter WIDTH       = 640,
    parameter HEIGHT      = 480,
    parameter BITS        = 16,    // of a pixel in the stream
    parameter BYTES       = 2,     // ... in memory
    parameter CONSECUTIVE = 0,
    parameter X_BITS      = 10,
    parameter Y_BITS      = 9,
    parameter START       = 0,
    parameter BACK        = 0,
    parameter ENABLED     = 1
) (
    input  wire               clk,
    input  wire               reset,

    input  wire [1:0]         slave_address,
    input  wire [3:0]         slave_byteenable,
    // verilator lint_off UNUSED
    input  wire               slave_read,
    // verilator lint_on UNUSED
    input  wire               slave_write,
    input  wire [31:0]        slave_writedata,
    output wire [31:0]        slave_readdata,

    output wire [31:0]        master_address,
    output wire               master_read,
    output wire               master_arbiterlock,
    input  wire               master_waitrequest,
    input  wire               master_readdatavalid,
    input  wire [8*BYTES-1:0] master_readdata,

    input  wire               stream_ready,
    output wire [BITS-1:0]    stream_data,
    output wire               stream_startofpacket,
    output wire               stream_endofpacket,
    output wire               stream_valid
);
    localparam [7:0] MOST = 8'd120;

    wire [31:0] buffer;
    wire        enabled;
    reg  [31:0] next_q;                       // of consecutive addresses
    reg  [15:0] x_q, y_q, come_x_q, come_y_q; // of the next read, of the next answer
    reg  [7:0]  under_way_q;

    wire       last_x = x_q == WIDTH - 1, last_y = y_q == HEIGHT - 1;
    wire       come_last_x = come_x_q == WIDTH - 1, come_last_y = come_y_q == HEIGHT - 1;
    wire       taken = master_read && !master_waitrequest;
    wire       begins = x_q == 16'd0 && y_q == 16'd0;
    wire [7:0] count;
    wire       pops = stream_ready && stream_valid;

    assign master_address = CONSECUTIVE != 0 ? (begins ? buffer : next_q)
                          : buffer + (({16'd0, y_q} << X_BITS) + {16'd0, x_q}) * BYTES;
    assign master_read = (enabled || !begins) && count + under_way_q < MOST && !reset;
    assign master_arbiterlock = 1'b0;
    assign stream_valid = count != 8'd0;

    de1sim_up_dma_registers #(
        .WIDTH(WIDTH), .HEIGHT(HEIGHT), .BYTES(BYTES), .CONSECUTIVE(CONSECUTIVE), .X_BITS(X_BITS),
        .Y_BITS(Y_BITS), .START(START), .BACK(BACK), .ENABLED(ENABLED)
    ) registers (
        .clk(clk), .reset(reset), .slave_address(slave_address),
        .slave_byteenable(slave_byteenable), .slave_write(slave_write),
        .slave_writedata(slave_writedata), .slave_readdata(slave_readdata),
        .picture_i(taken && last_x && last_y), .buffer_o(buffer), .enabled_o(enabled)
    );
    de1sim_up_fifo #(.WIDTH(BITS + 2)) pixels (
        .clk_i(clk), .rst_i(reset), .push_i(master_readdatavalid),
        .wdata_i({come_x_q == 16'd0 && come_y_q == 16'd0, come_last_x && come_last_y,
                  master_readdata[BITS-1:0]}),
        .pop_i(pops), .rdata_o({stream_startofpacket, stream_endofpacket, stream_data}),
        .count_o(count)
    );

    always @(posedge clk) begin
        under_way_q <= under_way_q + {7'd0, taken} - {7'd0, master_readdatavalid};
        if (taken) begin
            next_q <= master_address + BYTES;
            x_q    <= last_x ? 16'd0 : x_q + 16'd1;
            if (last_x) y_q <= last_y ? 16'd0 : y_q + 16'd1;
        end
        if (master_readdatavalid) begin
            come_x_q <= come_last_x ? 16'd0 : come_x_q + 16'd1;
            if (come_last_x) come_y_q <= come_last_y ? 16'd0 : come_y_q + 16'd1;
        end
        if (reset) begin
            under_way_q <= 8'd0;
            {x_q, y_q, come_x_q, come_y_q} <= 64'd0;
        end
    end
endmodule

`default_nettype wire
