// de1sim_up_dma_to_memory.v - the University Program's video DMA controller from a stream of pixels
// to memory
//
// Its registers: de1sim_up_dma_registers.v.  While EN is 0 the stream waits.  Each packet begins at
// buffer, whatever the one before had; in X-Y mode pixel (x, y) goes to
// buffer + ((y << n) + x) * BYTES, and lines beyond the last are counted on in the bits of y.

`default_nettype none

module de1sim_up_dma_to_memory #(
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
    output wire               master_write,
    output wire [8*BYTES-1:0] master_writedata,
    input  wire               master_waitrequest,

    output wire               stream_ready,
    input  wire [BITS-1:0]    stream_data,
    input  wire               stream_startofpacket,
    // verilator lint_off UNUSED
    input  wire               stream_endofpacket,
    // verilator lint_on UNUSED
    input  wire               stream_valid
);
    wire [31:0]       buffer;
    wire              enabled;
    reg               writes_q;
    reg [8*BYTES-1:0] data_q;
    reg [15:0]        x_q;               // of the pixel that is written
    reg [Y_BITS-1:0]  y_q;
    wire              taken  = stream_valid && stream_ready;
    wire              begins = taken && stream_startofpacket;
    wire              last_x = x_q == WIDTH - 1;

    assign stream_ready     = enabled && !reset && (!writes_q || !master_waitrequest);
    assign master_write     = writes_q;
    assign master_writedata = data_q;
    assign master_address   = buffer + BYTES * (
        CONSECUTIVE != 0 ? {{(32 - Y_BITS){1'b0}}, y_q} * WIDTH + {16'd0, x_q}
                         : ({{(32 - Y_BITS){1'b0}}, y_q} << X_BITS) + {16'd0, x_q});

    de1sim_up_dma_registers #(
        .WIDTH(WIDTH), .HEIGHT(HEIGHT), .BYTES(BYTES), .CONSECUTIVE(CONSECUTIVE), .X_BITS(X_BITS),
        .Y_BITS(Y_BITS), .START(START), .BACK(BACK), .ENABLED(ENABLED)
    ) registers (
        .clk(clk), .reset(reset), .slave_address(slave_address),
        .slave_byteenable(slave_byteenable), .slave_write(slave_write),
        .slave_writedata(slave_writedata), .slave_readdata(slave_readdata),
        .picture_i(begins), .buffer_o(buffer), .enabled_o(enabled)
    );

    always @(posedge clk) begin
        if (taken) begin
            // verilator lint_off WIDTH
            data_q   <= stream_data;
            // verilator lint_on WIDTH
            writes_q <= 1'b1;
            x_q      <= begins || last_x ? 16'd0 : x_q + 16'd1;
            if (begins) y_q <= {Y_BITS{1'b0}};
            else if (last_x) y_q <= y_q + 1'b1;
        end else if (!master_waitrequest) begin
            writes_q <= 1'b0;
        end
        if (reset) begin
            writes_q <= 1'b0;
            x_q      <= WIDTH - 1;
            y_q      <= {Y_BITS{1'b1}};
        end
    end
endmodule

`default_nettype wire
