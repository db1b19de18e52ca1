// de1sim_st_width.v - a stream's beats of IN symbols as beats of OUT symbols
//
// The first symbol of a beat is its highest.  A packet's last beat goes out when the packet has
// ended, and its `empty` says how many symbols it lacks; without packets a beat waits until it is
// full.  A beat of several has the errors of all.
//
// Not handled: channels that change within a beat that goes out, which has the last.

`default_nettype none

module de1sim_st_width #(
    parameter SYMBOL  = 8,
    parameter IN      = 1,
    parameter OUT     = 4,
    parameter CHANNEL = 1,
    parameter ERROR   = 1
) (
    input  wire                  clk_i,
    input  wire                  rst_i,

    input  wire                  valid_i,
    output wire                  ready_o,
    input  wire [IN*SYMBOL-1:0]  data_i,
    input  wire                  sop_i,
    input  wire                  eop_i,
    input  wire [9:0]            empty_i,
    input  wire [CHANNEL-1:0]    channel_i,
    input  wire [ERROR-1:0]      error_i,

    output wire                  valid_o,
    input  wire                  ready_i,
    output wire [OUT*SYMBOL-1:0] data_o,
    output wire                  sop_o,
    output wire                  eop_o,
    output wire [9:0]            empty_o,
    output wire [CHANNEL-1:0]    channel_o,
    output wire [ERROR-1:0]      error_o
);
    localparam ALL = (IN + OUT) * SYMBOL;
    localparam [31:0] WIDE_IN = IN, WIDE_OUT = OUT;
    localparam [10:0] IN_SYMBOLS = WIDE_IN[10:0], OUT_SYMBOLS = WIDE_OUT[10:0];

    reg  [ALL-1:0]     held_q;    // the first symbol is the highest
    reg  [10:0]        count_q;   // of its symbols
    reg                sop_q, ends_q;
    reg  [CHANNEL-1:0] channel_q;
    reg  [ERROR-1:0]   error_q;

    wire        goes  = valid_o && ready_i;
    wire [10:0] left  = !goes ? count_q : eop_o ? 11'd0 : count_q - OUT_SYMBOLS;
    wire        takes = valid_i && ready_o;
    wire [ALL-1:0] after = !goes ? held_q : eop_o ? {ALL{1'b0}} : held_q << OUT * SYMBOL;
    wire [ALL-1:0] added = {data_i, {OUT*SYMBOL{1'b0}}} >> left * SYMBOL;

    assign ready_o   = (!ends_q || (goes && eop_o)) && left < OUT_SYMBOLS;
    assign valid_o   = count_q >= OUT_SYMBOLS || ends_q;
    assign data_o    = held_q[ALL-1:IN*SYMBOL];
    assign sop_o     = sop_q;
    assign eop_o     = ends_q && count_q <= OUT_SYMBOLS;
    assign empty_o   = eop_o ? OUT_SYMBOLS[9:0] - count_q[9:0] : 10'd0;
    assign channel_o = channel_q;
    assign error_o   = error_q;

    always @(posedge clk_i) begin
        held_q  <= takes ? after | added : after;
        count_q <= !takes ? left : left + IN_SYMBOLS - (eop_i ? {1'b0, empty_i} : 11'd0);
        sop_q   <= (sop_q && !goes) || (takes && sop_i);
        ends_q  <= (ends_q && !(goes && eop_o)) || (takes && eop_i);
        if (takes) begin
            channel_q <= channel_i;
            error_q   <= error_i | (left != 11'd0 ? error_q : {ERROR{1'b0}});
        end
        if (rst_i) begin
            held_q  <= {ALL{1'b0}};
            count_q <= 11'd0;
            {sop_q, ends_q} <= 2'b00;
        end
    end
endmodule

`default_nettype wire
