// de1sim_avalon_width.v - commands of a master for a slave of another width
//
// Commands and answers as in de1sim_avalon_decoder.v.  For a slave that is narrower a command
// becomes one for each part that has a byte enabled, the lowest first, and at least one.  For a
// wider one its bytes are put where they belong.

`default_nettype none

module de1sim_avalon_width #(
    parameter FROM       = 32,  // bits of the master: 8, 16, ... 1024
    parameter TO         = 16,  // of the slave: another
    parameter MOST_LOG2  = 7,   // of answers that are on their way
    parameter FROM_BYTES = FROM / 8,
    parameter TO_BYTES   = TO / 8
) (
    input  wire                  clk_i,
    input  wire                  rst_i,

    input  wire                  valid_i,
    output wire                  ready_o,
    input  wire                  write_i,
    input  wire [31:0]           address_i,
    input  wire [FROM-1:0]       wdata_i,
    input  wire [FROM_BYTES-1:0] be_i,
    output wire                  rvalid_o,
    output wire [FROM-1:0]       rdata_o,

    output wire                  valid_o,
    input  wire                  ready_i,
    output wire                  write_o,
    output wire [31:0]           address_o,
    output wire [TO-1:0]         wdata_o,
    output wire [TO_BYTES-1:0]   be_o,
    input  wire                  rvalid_i,
    input  wire [TO-1:0]         rdata_i
);
    localparam PARTS = FROM > TO ? FROM / TO : TO / FROM;
    localparam [MOST_LOG2:0] MOST = 1 << MOST_LOG2;

    // ---- The parts whose answers are on their way: which, and whether it is a command's last ----
    reg  [7:0]           parts_q [0:MOST-1];
    reg                  lasts_q [0:MOST-1];
    reg  [MOST_LOG2-1:0] first_q = 0, end_q = 0;
    reg  [MOST_LOG2:0]   pending_q = 0;
    wire                 taken = valid_o && ready_i;
    wire [7:0]           part;
    wire                 last;
    wire [7:0]           answered = parts_q[first_q];

    assign write_o = write_i;
    assign valid_o = valid_i && pending_q != MOST;
    assign ready_o = ready_i && valid_o && last;

    always @(posedge clk_i) begin
        if (taken) begin
            parts_q[end_q] <= part;
            lasts_q[end_q] <= last;
            end_q          <= end_q + 1'b1;
        end
        if (rvalid_i) first_q <= first_q + 1'b1;
        pending_q <= pending_q + {{MOST_LOG2{1'b0}}, taken} - {{MOST_LOG2{1'b0}}, rvalid_i};
        if (rst_i) begin
            {first_q, end_q} <= 0;
            pending_q        <= 0;
        end
    end

    generate
        if (FROM > TO) begin : narrower
            reg [PARTS-1:0] done_q = 0;  // parts of this command that were sent
            reg [PARTS-1:0] open;        // that are left
            reg [7:0]       next;
            integer         n;
            always @* begin
                for (n = 0; n < PARTS; n = n + 1)
                    open[n] = be_i[TO_BYTES*n +: TO_BYTES] != {TO_BYTES{1'b0}} && !done_q[n];
                if (be_i == {FROM_BYTES{1'b0}}) open = {{PARTS-1{1'b0}}, 1'b1} & ~done_q;
                next = 8'd0;
                for (n = PARTS - 1; n >= 0; n = n - 1) if (open[n]) next = n[7:0];
            end
            assign part      = next;
            assign last      = (open & (open - 1'b1)) == {PARTS{1'b0}};
            assign address_o = address_i + {24'd0, next} * TO_BYTES;
            assign wdata_o   = wdata_i[TO*next +: TO];
            assign be_o      = be_i[TO_BYTES*next +: TO_BYTES];

            reg [FROM-1:0] rdata_q = 0;
            reg [FROM-1:0] rdata;
            always @* begin
                rdata = rdata_q;
                rdata[TO*answered +: TO] = rdata_i;
            end
            assign rvalid_o = rvalid_i && lasts_q[first_q];
            assign rdata_o  = rdata;
            always @(posedge clk_i) begin
                if (taken)
                    done_q <= last ? {PARTS{1'b0}} : done_q | {{PARTS-1{1'b0}}, 1'b1} << next;
                if (rvalid_i) rdata_q <= rvalid_o ? {FROM{1'b0}} : rdata;
                if (rst_i) begin
                    done_q  <= {PARTS{1'b0}};
                    rdata_q <= {FROM{1'b0}};
                end
            end
        end else begin : wider
            wire [31:0] index = address_i / FROM_BYTES % PARTS;
            assign part      = index[7:0];
            assign last      = 1'b1;
            assign address_o = address_i / TO_BYTES * TO_BYTES;
            assign wdata_o   = {PARTS{wdata_i}};
            assign be_o      = {{TO_BYTES-FROM_BYTES{1'b0}}, be_i} << (part * FROM_BYTES);
            assign rvalid_o  = rvalid_i;
            assign rdata_o   = rdata_i[FROM*answered +: FROM];
        end
    endgenerate
endmodule

`default_nettype wire
