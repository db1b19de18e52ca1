// de1sim_hps_axi.v - a bridge of the processor to the FPGA as AXI3
//
// A burst's address and its first word are there together.  BREADY and RREADY are always 1.  The
// next burst comes when the one before is answered; after a posted write, when that is sent.
//
// An answer counts if its ID is the burst's, if BVALID comes after the burst's last word was taken,
// and if RLAST comes with the last word of a read and with no other.  Otherwise the processor waits
// for ever, as on the board, and waits_i has what was seen.  SLVERR or DECERR, of a read in any of
// its words, is an abort.
//
// Source: AMBA AXI Protocol Specification (ARM IHI 0022D), AXI3.
//
// Not handled: reads that overlap, with others or with writes; words of two bursts at a time.

`default_nettype none

module de1sim_hps_axi #(
    parameter FULL = 0,  // as de1sim_hps_port
    parameter ADDRESS_BITS = 30
) (
    input  wire                    clk,
    input  wire [1:0]              size_i,  // as de1sim_hps_port

    output wire [11:0]             id,      // of AW, W and AR, and so on
    output wire [ADDRESS_BITS-1:0] addr,
    output wire [3:0]              len,
    output wire [2:0]              size,
    output wire [1:0]              burst,
    output wire [1:0]              lock,
    output wire [3:0]              cache,
    output wire [2:0]              prot,

    output wire                    awvalid,
    input  wire                    awready,
    output wire [127:0]            wdata,
    output wire [15:0]             wstrb,
    output wire                    wlast,
    output wire                    wvalid,
    input  wire                    wready,
    input  wire [11:0]             bid,
    input  wire [1:0]              bresp,
    input  wire                    bvalid,

    output wire                    arvalid,
    input  wire                    arready,
    input  wire [11:0]             rid,
    input  wire [127:0]            rdata,
    input  wire [1:0]              rresp,
    input  wire                    rlast,
    input  wire                    rvalid
);
    // As sim/project/runtime/bridge.h has them.
    localparam [3:0] AWREADY = 4'd1, WREADY = 4'd2, BVALID = 4'd3, ARREADY = 4'd4, RVALID = 4'd5,
                     BID = 4'd8, RID = 4'd9, EARLY_BVALID = 4'd10, EARLY_RLAST = 4'd11,
                     NO_RLAST = 4'd12;

    // verilator lint_off UNUSED
    reg  [63:0]  burst_q = 0;
    // verilator lint_on UNUSED
    reg          aw_q = 0, w_q = 0, ar_q = 0;  // not taken yet
    reg          open_q = 0;                   // not answered yet; a posted write: not sent
    reg          posted_q = 0;                 // posted writes are sent and not answered
    reg  [3:0]   beat_q = 0;
    reg  [127:0] wdata_q = 0;
    reg  [15:0]  wstrb_q = 0;
    reg  [3:0]   wrong_q = 0;                  // what was seen instead of an answer; 0: nothing
    reg  [11:0]  seen_q = 0;                   // that ID, or at which word

    wire         begins, reset;
    wire         write = burst_q[62];

    assign {prot, cache, lock, id, burst, size, len} = burst_q[61:32];
    assign addr = burst_q[ADDRESS_BITS-1:0];

    // ---- Writes ----

    wire         is_last = beat_q == len;
    wire         sent    = (!aw_q || awready) && (!w_q || (wready && is_last));
    wire         posting = open_q && burst_q[63];
    wire         posted  = posting && sent && wrong_q == 4'd0;
    wire         b_ours  = open_q && write && bvalid && (!posting || (bid == id && !posted));
    wire         b_ends  = b_ours && !posting && sent && bid == id && wrong_q == 4'd0;
    wire         b_else  = bvalid && (posting || posted_q) && !b_ours;

    assign awvalid = aw_q;
    assign wvalid  = w_q;
    assign wlast   = w_q && is_last;
    assign wdata   = wdata_q;
    assign wstrb   = wstrb_q;

    // ---- Reads ----

    wire         asked  = !ar_q || arready;
    wire         reads  = open_q && !write && rvalid && asked && wrong_q == 4'd0;
    wire         r_ours = reads && rid == id;
    wire         r_ends = r_ours && is_last && rlast;

    assign arvalid = ar_q;

    // ---- The processor ----

    wire         is_sending = aw_q || w_q;
    wire [3:0]   lacks = aw_q ? AWREADY : w_q ? WREADY : ar_q ? ARREADY : write ? BVALID : RVALID;

    de1sim_hps_port #(.FULL(FULL)) port (
        .clk_i(clk), .size_i(size_i),
        .begins_o(begins), .ends_i(b_ends || r_ends || posted), .reset_o(reset),
        .waits_i({beat_q, seen_q, wrong_q == 4'd0 || is_sending ? lacks : wrong_q})
    );

`ifdef DE1SIM_LISTS
    wire unused = &{1'b0, rdata, bresp, rresp, begins, reset, lacks, b_else};
`else
    `include "de1sim_hps_bridge.vh"

    wire         w_next = w_q && wready && !is_last;

    // verilator lint_off UNUSED
    reg  [63:0]  head;
    reg  [127:0] data;
    integer      strobes, address;
    // verilator lint_on UNUSED
    // verilator lint_off BLKSEQ
    always @(posedge clk) begin
        if (begins) begin
            head    = de1sim_hps_burst();
            burst_q <= head;
            {aw_q, w_q, ar_q} <= {head[62], head[62], !head[62]};
            open_q  <= 1'b1;
            beat_q  <= 4'd0;
            wrong_q <= 4'd0;
        end
        if (begins || w_next) begin
            strobes = de1sim_hps_beat(begins ? 0 : {28'd0, beat_q} + 1, address, data);
            wdata_q <= data;
            wstrb_q <= strobes[15:0];
        end
        if (awvalid && awready) aw_q <= 1'b0;
        if (arvalid && arready) ar_q <= 1'b0;
        if (wlast && wready) w_q <= 1'b0;
        if (w_next) beat_q <= beat_q + 4'd1;
        if (b_ours && wrong_q == 4'd0 && !b_ends)
            {wrong_q, seen_q} <= bid == id ? {EARLY_BVALID, 8'd0, beat_q} : {BID, bid};
        if (r_ours) begin
            de1sim_hps_answered({28'd0, beat_q}, rdata);
            if (rresp != 2'd0) de1sim_hps_refused({30'd0, rresp});
            if (rlast && !is_last) wrong_q <= EARLY_RLAST;
            if (!rlast && is_last) wrong_q <= NO_RLAST;
            if (!rlast && !is_last) beat_q <= beat_q + 4'd1;
        end else if (reads) {wrong_q, seen_q} <= {RID, rid};
        if (b_ends && bresp != 2'd0) de1sim_hps_refused({30'd0, bresp});
        if (posted || b_else)
            posted_q <= de1sim_hps_posted(FULL != 0, posted, b_else, {20'd0, bid}, {30'd0, bresp})
                        != 0;
        if (b_ends || r_ends || posted) open_q <= 1'b0;
        if (reset) {aw_q, w_q, ar_q, open_q, posted_q} <= 5'b00000;
    end
    // verilator lint_on BLKSEQ
`endif
endmodule

`default_nettype wire
