// altera_avalon_mm_clock_crossing_bridge.v - Platform Designer's bridge from one clock to another:
// commands from s0 to m0, answers back, each through a queue
//
// Source: Platform Designer User Guide, Avalon-MM Clock Crossing Bridge.
//
// Not handled: depths of the queues other than 16.

`default_nettype none

module altera_avalon_mm_clock_crossing_bridge #(
    parameter DATA_WIDTH       = 32,
    parameter HDL_ADDR_WIDTH   = 10,
    parameter BURSTCOUNT_WIDTH = 1,
    parameter BYTES            = DATA_WIDTH / 8
) (
    input  wire                      s0_clk,
    input  wire                      m0_clk,
    // verilator lint_off UNUSED
    input  wire                      m0_reset,
    // verilator lint_on UNUSED
    input  wire                      s0_reset,

    output wire                      s0_waitrequest,
    output wire [DATA_WIDTH-1:0]     s0_readdata,
    output wire                      s0_readdatavalid,
    input  wire [BURSTCOUNT_WIDTH-1:0] s0_burstcount,
    input  wire [DATA_WIDTH-1:0]     s0_writedata,
    input  wire [HDL_ADDR_WIDTH-1:0] s0_address,
    input  wire                      s0_write,
    input  wire                      s0_read,
    input  wire [BYTES-1:0]          s0_byteenable,
    input  wire                      s0_debugaccess,

    input  wire                      m0_waitrequest,
    input  wire [DATA_WIDTH-1:0]     m0_readdata,
    input  wire                      m0_readdatavalid,
    output wire [BURSTCOUNT_WIDTH-1:0] m0_burstcount,
    output wire [DATA_WIDTH-1:0]     m0_writedata,
    output wire [HDL_ADDR_WIDTH-1:0] m0_address,
    output wire                      m0_write,
    output wire                      m0_read,
    output wire [BYTES-1:0]          m0_byteenable,
    output wire                      m0_debugaccess
);
    localparam COMMAND = DATA_WIDTH + HDL_ADDR_WIDTH + BYTES + BURSTCOUNT_WIDTH + 2;

    // A read is sent on when its answer has a place.
    reg  [4:0] reads_q = 5'd0;
    wire       asks = (s0_read && reads_q != 5'd16) || s0_write;
    wire       room;
    assign s0_waitrequest = !(room && asks);
    always @(posedge s0_clk) begin
        reads_q <= reads_q + {4'd0, s0_read && !s0_waitrequest} - {4'd0, s0_readdatavalid};
        if (s0_reset) reads_q <= 5'd0;
    end

    wire valid, write;
    assign m0_read  = valid && !write;
    assign m0_write = valid && write;
    de1sim_avalon_queue #(.WIDTH(COMMAND)) commands (
        .clk_i(s0_clk), .valid_i(asks), .ready_o(room),
        .data_i({s0_write, s0_burstcount, s0_debugaccess, s0_byteenable, s0_address, s0_writedata}),
        .to_clk_i(m0_clk), .valid_o(valid), .ready_i(!m0_waitrequest),
        .data_o({write, m0_burstcount, m0_debugaccess, m0_byteenable, m0_address, m0_writedata})
    );
    // verilator lint_off PINCONNECTEMPTY
    de1sim_avalon_queue #(.WIDTH(DATA_WIDTH)) answers (
        .clk_i(m0_clk), .valid_i(m0_readdatavalid), .ready_o(), .data_i(m0_readdata),
        .to_clk_i(s0_clk), .valid_o(s0_readdatavalid), .ready_i(1'b1), .data_o(s0_readdata)
    );
    // verilator lint_on PINCONNECTEMPTY
endmodule

`default_nettype wire
