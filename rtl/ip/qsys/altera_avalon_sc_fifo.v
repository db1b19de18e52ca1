// altera_avalon_sc_fifo.v - Platform Designer's FIFO of a stream, with one clock
//
//   in --> FIFO_DEPTH words --> [a register] --> out
//
// A word that is written into the empty FIFO is at the output EMPTY_LATENCY clocks later: 3 with a
// register there, which is one more place, 1 without.
//
//   csr: 0 fill_level              words here, with that of the register
//        2 almost_full_threshold   FIFO_DEPTH - 1 after a reset
//        3 almost_empty_threshold  0 after a reset
//        4 cut_through_threshold   0 = a packet goes out when it is here as a whole, else when
//                                  so many words are here; 0 after a reset
//        5 drop_on_error           a packet whose last word has an error is dropped, unless it has
//                                  begun to go out; 0 after a reset
//
// The last two are there with USE_STORE_FORWARD.  A packet that does not fit goes out when the FIFO
// is full.
//
// Source: Embedded Peripherals IP User Guide, Avalon-ST Single-Clock FIFO Core, and its Verilog.

`default_nettype none

module altera_avalon_sc_fifo #(
    parameter SYMBOLS_PER_BEAT    = 1,
    parameter BITS_PER_SYMBOL     = 8,
    parameter FIFO_DEPTH          = 16,
    parameter CHANNEL_WIDTH       = 0,
    parameter ERROR_WIDTH         = 0,
    parameter USE_PACKETS         = 0,
    parameter USE_STORE_FORWARD   = 0,
    parameter EMPTY_LATENCY       = 3,
    parameter DATA    = SYMBOLS_PER_BEAT * BITS_PER_SYMBOL,
    parameter EMPTY   = SYMBOLS_PER_BEAT > 1 ? $clog2(SYMBOLS_PER_BEAT) : 1,
    parameter CHANNEL = CHANNEL_WIDTH > 0 ? CHANNEL_WIDTH : 1,
    parameter ERROR   = ERROR_WIDTH > 0 ? ERROR_WIDTH : 1
) (
    input  wire               clk,
    input  wire               reset,

    input  wire               in_valid,
    output wire               in_ready,
    input  wire [DATA-1:0]    in_data,
    input  wire               in_startofpacket,
    input  wire               in_endofpacket,
    input  wire [EMPTY-1:0]   in_empty,
    input  wire [CHANNEL-1:0] in_channel,
    input  wire [ERROR-1:0]   in_error,

    output wire               out_valid,
    input  wire               out_ready,
    output wire [DATA-1:0]    out_data,
    output wire               out_startofpacket,
    output wire               out_endofpacket,
    output wire [EMPTY-1:0]   out_empty,
    output wire [CHANNEL-1:0] out_channel,
    output wire [ERROR-1:0]   out_error,

    output wire               almost_full_data,
    output wire               almost_empty_data,

    input  wire [2:0]         csr_address,   // two bits without USE_STORE_FORWARD
    input  wire               csr_read,
    input  wire               csr_write,
    // verilator lint_off UNUSED
    input  wire [31:0]        csr_writedata,
    // verilator lint_on UNUSED
    output reg  [31:0]        csr_readdata
);
    localparam LOG2  = $clog2(FIFO_DEPTH), SIDE = 2 + EMPTY + CHANNEL + ERROR;
    localparam WIDTH = DATA + SIDE;
    localparam [31:0] DEPTH = FIFO_DEPTH, LAST = FIFO_DEPTH - 1;
    localparam [LOG2:0] FULL = DEPTH[LOG2:0];

    // ---- Words ----
    reg  [WIDTH-1:0] words_q [0:(1<<LOG2)-1];
    reg  [LOG2:0]    in_q, out_q, begin_q;   // the next, and the place of the packet's first
    reg              seen_q;                 // that it is not empty
    reg              valid_q;
    reg  [WIDTH-1:0] register_q;

    wire [LOG2:0]    used  = in_q - out_q;
    wire             full  = used == FULL;
    wire             takes = in_valid && in_ready;
    wire             forwards;
    wire [WIDTH-1:0] word  = words_q[out_q[LOG2-1:0]];
    wire             has   = (EMPTY_LATENCY > 1 ? seen_q : used != 0) && forwards;
    wire             next  = EMPTY_LATENCY == 3 ? !valid_q || out_ready : out_ready;
    wire             goes  = has && next;
    wire [24:0]      fill  = {{24-LOG2{1'b0}}, used} + {24'd0, EMPTY_LATENCY == 3 && valid_q};

    assign in_ready  = !full;
    assign out_valid = EMPTY_LATENCY == 3 ? valid_q : has;
    assign {out_startofpacket, out_endofpacket, out_empty, out_channel, out_error, out_data} =
        EMPTY_LATENCY == 3 ? register_q : word;

    wire drops;
    always @(posedge clk) begin
        if (takes)
            words_q[in_q[LOG2-1:0]] <= {in_startofpacket, in_endofpacket, in_empty, in_channel,
                                        in_error, in_data};
        if (takes && in_startofpacket) begin_q <= in_q;
        in_q   <= drops ? (in_startofpacket ? in_q : begin_q) : in_q + {{LOG2{1'b0}}, takes};
        out_q  <= out_q + {{LOG2{1'b0}}, goes};
        seen_q <= used != 0 && !(goes && used == 1);
        if (next) begin
            valid_q    <= has;
            register_q <= word;
        end
        if (reset) begin
            {in_q, out_q, begin_q} <= 0;
            {seen_q, valid_q} <= 2'b00;
        end
    end

    // ---- Registers ----
    reg [23:0] almost_full_q, almost_empty_q, cut_through_q;
    reg        drop_q;

    assign almost_full_data  = fill >= {1'b0, almost_full_q};
    assign almost_empty_data = fill <= {1'b0, almost_empty_q};

    always @(posedge clk) begin
        if (csr_read)
            case (csr_address)
                3'd0:    csr_readdata <= {7'd0, fill};
                3'd2:    csr_readdata <= {8'd0, almost_full_q};
                3'd3:    csr_readdata <= {8'd0, almost_empty_q};
                3'd4:    csr_readdata <= {8'd0, cut_through_q};
                3'd5:    csr_readdata <= {31'd0, drop_q};
                default: csr_readdata <= 32'd0;
            endcase
        else if (csr_write)
            case (csr_address)
                3'd2:    almost_full_q  <= csr_writedata[23:0];
                3'd3:    almost_empty_q <= csr_writedata[23:0];
                3'd4:    cut_through_q  <= csr_writedata[23:0];
                3'd5:    drop_q         <= csr_writedata[0];
                default: ;
            endcase
        if (reset) begin
            almost_full_q <= LAST[23:0];
            {almost_empty_q, cut_through_q} <= 48'd0;
            drop_q <= 1'b0;
        end
    end

    // ---- Whole packets ----
    generate
        if (USE_STORE_FORWARD != 0 && USE_PACKETS != 0) begin : store
            reg  [LOG2:0] whole_q;     // packets in the FIFO
            reg           begun_q;     // the next word is not the first of its packet
            wire          ends  = takes && in_endofpacket && !drops;
            wire          leaves = goes && word[WIDTH-2];

            assign forwards = begun_q || whole_q != 0 || full
                              || (cut_through_q != 24'd0 && fill >= {1'b0, cut_through_q});
            // In a packet of which something has gone, the end has to follow.
            assign drops = takes && in_endofpacket && drop_q && in_error != 0
                           && !(whole_q == 0 && (begun_q || goes));
            always @(posedge clk) begin
                whole_q <= whole_q + {{LOG2{1'b0}}, ends} - {{LOG2{1'b0}}, leaves};
                if (goes) begun_q <= !word[WIDTH-2];
                if (reset) begin
                    whole_q <= 0;
                    begun_q <= 1'b0;
                end
            end
        end else begin : pass
            assign forwards = 1'b1;
            assign drops    = 1'b0;
        end
    endgenerate
endmodule

`default_nettype wire
