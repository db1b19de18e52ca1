// altera_avalon_dc_fifo.v - Platform Designer's FIFO of a stream, from one clock to another
//
//   in --> FIFO_DEPTH words --> a register --> out
//
//   in_csr:  0 fill_level, without the register's    1 almost_full_threshold
//   out_csr: 0 fill_level, with it                   1 almost_empty_threshold
//
// Each side sees the other's words some clocks later.  The thresholds are there with almost_full
// and almost_empty, and 0 after a reset.
//
// Source: Embedded Peripherals IP User Guide, Avalon-ST Dual-Clock FIFO Core, and its Verilog.

`default_nettype none

module altera_avalon_dc_fifo #(
    parameter SYMBOLS_PER_BEAT    = 1,
    parameter BITS_PER_SYMBOL     = 8,
    parameter FIFO_DEPTH          = 16,
    parameter CHANNEL_WIDTH       = 0,
    parameter ERROR_WIDTH         = 0,
    parameter STREAM_ALMOST_FULL  = 0,
    parameter STREAM_ALMOST_EMPTY = 0,
    parameter DATA    = SYMBOLS_PER_BEAT * BITS_PER_SYMBOL,
    parameter EMPTY   = SYMBOLS_PER_BEAT > 1 ? $clog2(SYMBOLS_PER_BEAT) : 1,
    parameter CHANNEL = CHANNEL_WIDTH > 0 ? CHANNEL_WIDTH : 1,
    parameter ERROR   = ERROR_WIDTH > 0 ? ERROR_WIDTH : 1,
    parameter LOG2    = $clog2(FIFO_DEPTH)
) (
    input  wire               in_clk,
    input  wire               in_reset_n,
    input  wire               out_clk,
    input  wire               out_reset_n,

    input  wire               in_valid,
    output wire               in_ready,
    input  wire [DATA-1:0]    in_data,
    input  wire               in_startofpacket,
    input  wire               in_endofpacket,
    input  wire [EMPTY-1:0]   in_empty,
    input  wire [CHANNEL-1:0] in_channel,
    input  wire [ERROR-1:0]   in_error,

    output reg                out_valid,
    input  wire               out_ready,
    output reg  [DATA-1:0]    out_data,
    output reg                out_startofpacket,
    output reg                out_endofpacket,
    output reg  [EMPTY-1:0]   out_empty,
    output reg  [CHANNEL-1:0] out_channel,
    output reg  [ERROR-1:0]   out_error,

    output reg                almost_full_valid,
    output reg                almost_full_data,
    output reg                almost_empty_valid,
    output reg                almost_empty_data,
    output wire [LOG2:0]      space_avail_data,

    input  wire               in_csr_address,
    input  wire               in_csr_read,
    input  wire               in_csr_write,
    input  wire               out_csr_address,
    input  wire               out_csr_read,
    input  wire               out_csr_write,
    // verilator lint_off UNUSED
    input  wire [31:0]        in_csr_writedata,
    input  wire [31:0]        out_csr_writedata,
    // verilator lint_on UNUSED
    output reg  [31:0]        in_csr_readdata,
    output reg  [31:0]        out_csr_readdata
);
    localparam WIDTH = DATA + 2 + EMPTY + CHANNEL + ERROR;
    localparam [31:0] DEPTH = FIFO_DEPTH;
    localparam [LOG2:0] FULL = DEPTH[LOG2:0];

    wire [WIDTH-1:0] word;
    wire [LOG2:0]    in_used, out_used;
    wire             goes = out_used != 0 && (!out_valid || out_ready);

    assign in_ready         = in_used != FULL;
    assign space_avail_data = FULL - in_used;

    de1sim_vip_fifo #(.WIDTH(WIDTH), .LOG2(LOG2)) words (
        .in_clk_i(in_clk), .in_rst_i(!in_reset_n), .write_i(in_valid && in_ready),
        .data_i({in_startofpacket, in_endofpacket, in_empty, in_channel, in_error, in_data}),
        .in_used_o(in_used), .out_clk_i(out_clk), .out_rst_i(!out_reset_n), .read_i(goes),
        .data_o(word), .out_used_o(out_used)
    );

    always @(posedge out_clk) begin
        if (!out_valid || out_ready) begin
            out_valid <= out_used != 0;
            {out_startofpacket, out_endofpacket, out_empty, out_channel, out_error, out_data}
                <= word;
        end
        if (!out_reset_n) out_valid <= 1'b0;
    end

    // ---- Registers ----
    reg  [23:0] almost_full_q, almost_empty_q;
    wire [24:0] in_fill  = {{24-LOG2{1'b0}}, in_used};
    wire [24:0] out_fill = {{24-LOG2{1'b0}}, out_used} + {24'd0, out_valid};

    always @(posedge in_clk) begin
        almost_full_valid <= in_reset_n;
        almost_full_data  <= in_reset_n && in_fill >= {1'b0, almost_full_q};
        if (in_csr_write && in_csr_address && STREAM_ALMOST_FULL != 0)
            almost_full_q <= in_csr_writedata[23:0];
        if (in_csr_read)
            in_csr_readdata <= in_csr_address ? {8'd0, almost_full_q} : {7'd0, in_fill};
        if (!in_reset_n) almost_full_q <= 24'd0;
    end
    always @(posedge out_clk) begin
        almost_empty_valid <= out_reset_n;
        almost_empty_data  <= out_reset_n && out_fill <= {1'b0, almost_empty_q};
        if (out_csr_write && out_csr_address && STREAM_ALMOST_EMPTY != 0)
            almost_empty_q <= out_csr_writedata[23:0];
        if (out_csr_read)
            out_csr_readdata <= out_csr_address ? {8'd0, almost_empty_q} : {7'd0, out_fill};
        if (!out_reset_n) almost_empty_q <= 24'd0;
    end
endmodule

`default_nettype wire
