// de1sim_axi_master.v - an AXI master's transfers as commands: AXI3, AXI4 and AXI4-Lite
//
// Commands and answers as in de1sim_avalon_decoder.v.  A burst becomes a command for each beat; the
// next burst is taken when the last one has been answered, reads and writes in turn.
//
// Source: AMBA AXI Protocol Specification.
//
// Not handled: exclusive accesses; errors of a slave: each answer is OKAY.

`default_nettype none

module de1sim_axi_master #(
    parameter WIDTH   = 32,
    parameter ADDRESS = 32,
    parameter ID      = 1,
    parameter BYTES   = WIDTH / 8
) (
    input  wire               clk_i,
    input  wire               rst_i,

    input  wire [ID-1:0]      awid_i,
    input  wire [ADDRESS-1:0] awaddr_i,
    input  wire [7:0]         awlen_i,
    input  wire [2:0]         awsize_i,
    input  wire [1:0]         awburst_i,
    input  wire               awvalid_i,
    output wire               awready_o,
    input  wire [WIDTH-1:0]   wdata_i,
    input  wire [BYTES-1:0]   wstrb_i,
    input  wire               wvalid_i,
    output wire               wready_o,
    output wire [ID-1:0]      bid_o,
    output wire               bvalid_o,
    input  wire               bready_i,

    input  wire [ID-1:0]      arid_i,
    input  wire [ADDRESS-1:0] araddr_i,
    input  wire [7:0]         arlen_i,
    input  wire [2:0]         arsize_i,
    input  wire [1:0]         arburst_i,
    input  wire               arvalid_i,
    output wire               arready_o,
    output wire [ID-1:0]      rid_o,
    output wire [WIDTH-1:0]   axi_rdata_o,
    output wire               rlast_o,
    output wire               axi_rvalid_o,
    input  wire               rready_i,

    output wire               valid_o,
    input  wire               ready_i,
    output wire               write_o,
    output wire [15:0]        count_o,
    output wire [31:0]        address_o,
    output wire [WIDTH-1:0]   wdata_o,
    output wire [BYTES-1:0]   be_o,
    input  wire               rvalid_i,
    input  wire [WIDTH-1:0]   rdata_i
);
    localparam [1:0] FIXED = 2'd0, WRAP = 2'd2;

    // ---- The burst under way ----------------------------------------------
    reg            busy_q = 0, write_q = 0;
    reg  [ID-1:0]  id_q = 0;
    reg  [31:0]    address_q = 0;
    reg  [31:0]    wrap_q = 0;      // of the bytes of a wrapping burst, minus 1
    reg  [2:0]     size_q = 0;
    reg  [1:0]     burst_q = 0;
    reg  [8:0]     asked_q = 0, open_q = 0, left_q = 0;  // beats: to be asked for, asked for and
                                                         // not answered, not given to the master
    wire           takes_write = awvalid_i && (!arvalid_i || !write_q);

    assign awready_o = !busy_q && takes_write && !rst_i;
    assign arready_o = !busy_q && arvalid_i && !takes_write && !rst_i;

    wire [31:0]    step  = 32'd1 << size_q;
    wire [31:0]    after = (address_q & ~(step - 32'd1)) + step;
    wire [31:0]    next  = burst_q == FIXED ? address_q
                           : burst_q == WRAP ? (address_q & ~wrap_q) | (after & wrap_q) : after;

    // ---- Commands ---------------------------------------------------------
    wire           taken = valid_o && ready_i;
    // The lanes of a beat, from its first byte on.
    wire [BYTES-1:0] lanes = (step[31:0] >= BYTES ? {BYTES{1'b1}}
                              : ((({{BYTES-1{1'b0}}, 1'b1} << step) - 1'b1)
                                 << (address_q & (BYTES - 1) & ~(step - 32'd1))))
                             & ({BYTES{1'b1}} << (address_q & (BYTES - 1)));

    assign valid_o   = busy_q && asked_q != 9'd0 && !rst_i
                       && (write_q ? wvalid_i : open_q + {4'd0, stored} < 9'd16);
    assign write_o   = write_q;
    assign address_o = address_q & ~(BYTES - 1);
    assign wdata_o   = wdata_i;

    // Beats of less than a word, and of one word each time, are no burst behind here.
    wire [31:0]    left_of_wrap = (wrap_q + 32'd1 - (address_q & wrap_q)) / BYTES;
    assign count_o = step != BYTES || burst_q == FIXED ? 16'd1
                     : burst_q == WRAP && left_of_wrap < {23'd0, asked_q} ? left_of_wrap[15:0]
                     : {7'd0, asked_q};
    assign be_o      = write_q ? wstrb_i : lanes;
    assign wready_o  = busy_q && write_q && taken;

    // ---- Answers ----------------------------------------------------------
    reg  [WIDTH-1:0] words_q [0:15];
    reg  [4:0]     first_q = 0, end_q = 0;
    wire [4:0]     stored = end_q - first_q;
    wire           given = axi_rvalid_o && rready_i;

    assign axi_rvalid_o = busy_q && !write_q && stored != 5'd0;
    assign axi_rdata_o  = words_q[first_q[3:0]];
    assign rlast_o      = left_q == 9'd1;
    assign rid_o        = id_q;
    assign bvalid_o     = busy_q && write_q && asked_q == 9'd0 && open_q == 9'd0;
    assign bid_o        = id_q;

    wire [8:0]     len = awready_o ? {1'b0, awlen_i} : {1'b0, arlen_i};
    wire [2:0]     size = awready_o ? awsize_i : arsize_i;

    always @(posedge clk_i) begin
        if (awready_o || arready_o) begin
            busy_q    <= 1'b1;
            write_q   <= awready_o;
            id_q      <= awready_o ? awid_i : arid_i;
            address_q <= awready_o ? awaddr_i : araddr_i;
            size_q    <= size;
            burst_q   <= awready_o ? awburst_i : arburst_i;
            wrap_q    <= (({23'd0, len} + 32'd1) << size) - 32'd1;
            asked_q   <= len + 9'd1;
            left_q    <= len + 9'd1;
        end
        if (taken) begin
            asked_q   <= asked_q - 9'd1;
            address_q <= next;
        end
        open_q <= open_q + {8'd0, taken} - {8'd0, rvalid_i};
        if (rvalid_i && !write_q) begin
            words_q[end_q[3:0]] <= rdata_i;
            end_q <= end_q + 5'd1;
        end
        if (given) begin
            first_q <= first_q + 5'd1;
            left_q  <= left_q - 9'd1;
        end
        if ((given && rlast_o) || (bvalid_o && bready_i)) busy_q <= 1'b0;
        if (rst_i) begin
            {busy_q, write_q} <= 2'b00;
            {asked_q, open_q} <= 18'd0;
            {first_q, end_q}  <= 10'd0;
        end
    end
endmodule

`default_nettype wire
